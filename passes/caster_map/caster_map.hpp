#pragma once
#include <glm/glm.hpp>

#include "pipeline/plan/pass.hpp"

namespace caustics {

// The uniform block of passes that draw casters into a frame.
struct CasterMapUniforms {
  using vec4 = glm::vec4;
  using mat4 = glm::mat4;
#include "passes/caster_map/caster_map_uniforms.glsl"
};
CasterMapUniforms caster_map_uniforms(const View& view, int material_row);

// caster_map.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass caster_map_pass();

}  // namespace caustics
