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

}  // namespace caustics
