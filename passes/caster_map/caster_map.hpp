#pragma once
#include "pipeline/plan/pass.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

// The uniform block of passes that draw casters into a view.
struct alignas(16) CasterMap {
#include "passes/caster_map/caster_map_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

std140::CasterMap caster_map_uniforms(const View& view, int material_row, int first_triangle = 0);
// Of the mesh that is drawn.
std140::CasterMap plain_casters(const PassContext& context);

// caster_map.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass caster_map_pass();

}  // namespace caustics
