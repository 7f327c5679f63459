#include "passes/shared/grid_light_uniforms.glsl"
