#pragma once
#include <glm/glm.hpp>

#include "pipeline/plan/pass.hpp"

namespace caustics {

// The uniform block of passes that draw casters with their textures into a frame.
struct TexturedCastersUniforms {
  using vec4 = glm::vec4;
  using mat4 = glm::mat4;
#include "passes/textured_casters/textured_casters_uniforms.glsl"
};
// `role`: what the material's colour means, what it lets through or what it mirrors.
TexturedCastersUniforms textured_casters_uniforms(const View& view, const Material& material, Role role,
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
