#include "raster/vertex_stage.hpp"

#include <algorithm>
#include <atomic>

namespace caustics::raster {

namespace {

constexpr std::size_t kVerticesPerTask = 4096;
constexpr int kMaxComponents = 64;

void shade_range(const VertexStage& stage, const std::vector<int>& offsets, std::size_t first,
                 std::size_t last, ShadedVertices& out) {
  alignas(64) float attributes[kMaxComponents][kBlock];
  alignas(64) float position[4][kBlock] = {};
  alignas(64) float point_size[kBlock];
  alignas(64) float varyings[kMaxComponents][kBlock] = {};
  std::int32_t id[kBlock];
  const std::size_t floats = stage.mesh ? static_cast<std::size_t>(stage.mesh->floats_per_vertex()) : 0;
  const int varying_count = stage.interface->varying_components();
  for (std::size_t block = first; block < last; block += kBlock) {
    const std::size_t used = std::min<std::size_t>(kBlock, last - block);
    for (std::size_t lane = 0; lane < kBlock; ++lane) {
      // Lanes beyond the end repeat the last vertex, so that every lane holds sound data.
      const std::size_t vertex = block + std::min(lane, used - 1);
      id[lane] = static_cast<std::int32_t>(vertex);
      point_size[lane] = 1.0f;
      if (stage.mesh)
        for (std::size_t c = 0; c < offsets.size(); ++c)
          attributes[c][lane] = stage.mesh->vertices[vertex * floats + static_cast<std::size_t>(offsets[c])];
    }
    stage.kernel({stage.uniforms, stage.textures, attributes, id, position, point_size, varyings});
    for (std::size_t lane = 0; lane < used; ++lane) {
      float* v = out.values.get() + (block - out.first + lane) * static_cast<std::size_t>(out.stride);
      for (int c = 0; c < 4; ++c) v[c] = position[c][lane];
      v[4] = point_size[lane];
      for (int c = 0; c < varying_count; ++c) v[ShadedVertices::kHeader + c] = varyings[c][lane];
    }
  }
}

}  // namespace

void ShadedVertices::hold(std::size_t vertices) {
  // Varyings are read in fours: three more may be behind the last.
  constexpr std::size_t kBehind = 3;
  const std::size_t used = vertices * static_cast<std::size_t>(stride);
  if (room < used + kBehind) {
    values.reset();  // not both at once
    values = allocate_texels(used + kBehind);
    room = used + kBehind;
  }
  std::fill_n(values.get() + used, kBehind, 0.0f);
}

std::vector<int> attribute_offsets(const ShaderInterface& interface, const MeshData& mesh) {
  std::vector<int> offsets;
  for (const ShaderVariable& wanted : interface.attributes) {
    int offset = 0;
    for (const MeshData::Attribute& attribute : mesh.layout) {
      if (attribute.name == wanted.name)
        for (int c = 0; c < wanted.components; ++c) offsets.push_back(offset + c);
      offset += attribute.components;
    }
  }
  return offsets;
}

std::uint64_t shade_vertices(const VertexStage& stage, std::size_t first, std::size_t count,
                             const Workers& workers, ShadedVertices& out) {
  out.stride = ShadedVertices::kHeader + stage.interface->varying_components();
  out.first = first;
  out.hold(count);
  const std::vector<int> offsets =
      stage.mesh ? attribute_offsets(*stage.interface, *stage.mesh) : std::vector<int>{};
  const std::size_t tasks = (count + kVerticesPerTask - 1) / kVerticesPerTask;
  std::atomic<std::uint64_t> operations = 0;
  workers.run(static_cast<int>(tasks), [&](int task) {
    const std::size_t begin = first + static_cast<std::size_t>(task) * kVerticesPerTask;
    const std::uint64_t before = operations_of_thread;
    shade_range(stage, offsets, begin, std::min(begin + kVerticesPerTask, first + count), out);
    operations += operations_of_thread - before;
  });
  return operations;
}

}  // namespace caustics::raster
