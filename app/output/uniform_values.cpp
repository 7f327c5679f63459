#include "app/output/uniform_values.hpp"

#include <cstring>

namespace caustics::app {

namespace {

template <class T>
double value_at(const std::vector<std::byte>& block, std::size_t offset) {
  T value{};
  if (offset + sizeof value <= block.size()) std::memcpy(&value, &block[offset], sizeof value);
  return static_cast<double>(value);
}

}  // namespace

std::vector<NamedUniform> uniform_values(const PassDefinition& definition, const Draw& draw) {
  std::vector<NamedUniform> uniforms;
  for (const UniformVariable& variable : uniform_layout_of(*definition.shader).variables) {
    NamedUniform uniform{variable, {}};
    for (std::size_t i = 0; i < static_cast<std::size_t>(uniform_components(variable.type)); ++i) {
      const std::size_t offset = variable.offset + 4 * i;
      uniform.values.push_back(variable.type == "int" ? value_at<std::int32_t>(draw.uniforms, offset)
                                                      : value_at<float>(draw.uniforms, offset));
    }
    uniforms.push_back(std::move(uniform));
  }
  return uniforms;
}

}  // namespace caustics::app
