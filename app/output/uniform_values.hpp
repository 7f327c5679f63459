// What a draw's uniform block holds, value by value under the names of the shader's text.
#pragma once
#include <string>
#include <vector>

#include "pipeline/gpu/pass_run.hpp"
#include "pipeline/gpu/uniform_layout.hpp"

namespace caustics::app {

struct NamedUniform : UniformVariable {
  // As many as the type has components, of a matrix column by column; whole numbers where it is int.
  std::vector<double> values;
};

// In the order of the block; none where the shader has no uniforms.
std::vector<NamedUniform> uniform_values(const PassDefinition& definition, const Draw& draw);

}  // namespace caustics::app
