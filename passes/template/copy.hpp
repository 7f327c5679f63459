// The smallest whole pass: copies a texture times a factor. A model for new passes, and a test pass.
#pragma once
#include "pipeline/gpu/pass_definition.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

struct Copy {
#include "passes/template/copy_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

PassDefinition copy_pass();

}  // namespace caustics
