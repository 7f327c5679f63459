Sky sky;
#include "passes/shared/sight_uniforms.glsl"
vec3 receivers_lower;    // the box around all receivers, scene space
vec3 receivers_upper;
CHOICE(blends)           // there are blended surfaces
CHOICE(several_rays)     // 1: two or four rays a pixel, else one
