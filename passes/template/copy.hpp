// The smallest whole pass: copies a texture times a factor. A model for new passes, and a test pass.
#pragma once
#include <glm/glm.hpp>

#include "pipeline/gpu/pass_definition.hpp"

namespace caustics {

struct CopyUniforms {
  using vec4 = glm::vec4;
#include "passes/template/copy_uniforms.glsl"
};

PassDefinition copy_pass();

}  // namespace caustics
