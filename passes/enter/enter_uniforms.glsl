#include "passes/shared/grid_light_uniforms.glsl"
#include "passes/shared/bend_light_uniforms.glsl"
