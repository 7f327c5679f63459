#pragma once
#include "passes/shared/material_uniforms.hpp"
#include "pipeline/plan/pass.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

// The uniform block of passes that draw casters with their textures into a view.
struct TexturedCasters {
#include "passes/textured_casters/textured_casters_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

// `role`: what the material's colour means, what it lets through or what it mirrors.
std140::TexturedCasters textured_casters_uniforms(const View& view, const Material& material, Role role,
                                                  int material_row);

// textured_casters.md says what these passes are for, what they read and write, and what can go wrong.
// In place of caster_map, caster_exit_map, view_caster_map and view_exit_map where a caster has textures:
// "detailed" ones have normals and holes, "tinted" ones a colour besides.
Pass detailed_caster_map_pass();
Pass tinted_caster_map_pass();
Pass detailed_exit_map_pass();
Pass detailed_view_casters_pass();
Pass tinted_view_casters_pass();
Pass detailed_view_exits_pass();

}  // namespace caustics
