#pragma once
#include <glm/glm.hpp>

#include "pipeline/plan/pass.hpp"

namespace caustics {

struct CausticMapUniforms {
  using vec4 = glm::vec4;
  using mat4 = glm::mat4;
  using ivec4 = glm::ivec4;
#include "passes/caustic_map/caustic_map_uniforms.glsl"
};

// Of the map whose frame is `map`.
CausticMapUniforms caustic_map_uniforms(const PassContext& context, const View& map);

// caustic_map.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass caustic_map_pass();

}  // namespace caustics
