#include "passes/shared/grid_light_uniforms.glsl"
#include "passes/shared/bend_light_uniforms.glsl"
CHOICE(has_caster_tint)   // 1: caster_tint has the colours, not caster_materials
