#include "passes/shared/grid_light_uniforms.glsl"
#include "passes/shared/bend_light_uniforms.glsl"
CHOICE(is_tinted)  // 1: blended surfaces may stand before casters
