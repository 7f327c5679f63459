#include "passes/shared/sight_uniforms.glsl"
float drawn_from;        // each of a pixel's samples shows other surfaces: by so much of one they differ
CHOICE(mirrors)          // 1: of what the first surface mirrors, else of what it lets through
