#include "pipeline/gpu/device.hpp"

namespace caustics {

int MeshData::floats_per_vertex() const {
  int sum = 0;
  for (const Attribute& attribute : layout) sum += attribute.components;
  return sum;
}

std::size_t MeshData::vertex_count() const {
  const int floats = floats_per_vertex();
  return floats == 0 ? 0 : vertices.size() / static_cast<std::size_t>(floats);
}

}  // namespace caustics
