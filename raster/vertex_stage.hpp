// The vertex stage: a pass's vertex kernel over a draw's vertices, all or a stretch of them.
#pragma once
#include <vector>

#include "pipeline/gpu/pass_run.hpp"
#include "pipeline/shader/kernel.hpp"
#include "raster/texture.hpp"
#include "raster/workers.hpp"

namespace caustics::raster {

// A stretch of a draw's vertices, shaded, one after the other: clip position (4 floats), point size,
// varyings.
struct ShadedVertices {
  static constexpr int kHeader = 5;
  int stride = kHeader;
  std::size_t first = 0;
  Texels values{};
  std::size_t room = 0;  // floats in `values`
  // For so many vertices, in memory of before where that is enough. Undefined contents.
  void hold(std::size_t vertices);
  // By the vertex's number in the draw.
  const float* at(std::size_t vertex) const {
    return values.get() + (vertex - first) * static_cast<std::size_t>(stride);
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
};
// The vertices `first` to `first` + `count`, into memory that `out` may have from before. Returns what the
// shader's operations were counted to.
std::uint64_t shade_vertices(const VertexStage& stage, std::size_t first, std::size_t count,
                             const Workers& workers, ShadedVertices& out);

}  // namespace caustics::raster
