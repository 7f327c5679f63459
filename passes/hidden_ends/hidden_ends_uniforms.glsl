#include "passes/shared/sight_uniforms.glsl"
CHOICE(mirrors)          // 1: of what the first surface mirrors, else of what it lets through
