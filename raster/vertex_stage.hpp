// The vertex stage: a pass's vertex kernel over all vertices of a draw.
#pragma once
#include <vector>

#include "pipeline/gpu/pass_run.hpp"
#include "pipeline/shader/kernel.hpp"
#include "raster/workers.hpp"

namespace caustics::raster {

// Shaded vertices, one after the other: clip position (4 floats), point size, varyings.
struct ShadedVertices {
  static constexpr int kHeader = 5;
  int stride = kHeader;
  std::size_t count = 0;
  std::vector<float> values;
  const float* at(std::size_t vertex) const {
    return values.data() + vertex * static_cast<std::size_t>(stride);
  }
};

// Where each of a shader's attribute components lies in a vertex of this mesh.
std::vector<int> attribute_offsets(const ShaderInterface& interface, const MeshData& mesh);

struct VertexStage {
  const ShaderInterface* interface = nullptr;
  VertexKernel kernel = nullptr;
  const void* uniforms = nullptr;
  const TextureView* textures = nullptr;
  const MeshData* mesh = nullptr;  // null: vertices know only their number
  std::size_t vertex_count = 0;
};
ShadedVertices shade_vertices(const VertexStage& stage, const Workers& workers);

}  // namespace caustics::raster
