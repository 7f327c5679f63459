#include "raster/primitives.hpp"

#include <algorithm>

#include "raster/clip.hpp"

namespace caustics::raster {

namespace {

// Enough to keep threads busy, few enough that every tile can walk all chunks' lists.
constexpr std::size_t kPrimitivesPerChunk = 8192;

class ChunkBuilder {
 public:
  ChunkBuilder(const PrimitiveStage& stage, const TileGrid& grid, BinnedChunk& chunk)
      : stage_(stage), grid_(grid), viewport_{grid.width, grid.height}, chunk_(chunk) {}

  void build(std::size_t first, std::size_t last) {
    chunk_.triangles.clear();
    chunk_.points.clear();
    chunk_.planes.clear();
    const std::size_t planes_each = 2 + static_cast<std::size_t>(stage_.options.varying_count);
    if (stage_.topology == Topology::Triangles) {
      chunk_.triangles.reserve(last - first);
      chunk_.planes.reserve((last - first) * planes_each);
    } else {
      chunk_.points.reserve(last - first);
    }
    for (std::size_t i = first; i < last; ++i) {
      if (stage_.topology == Topology::Triangles)
        add_triangle(i);
      else
        add_point(i);
    }
    // The planes' vector has stopped growing: records can point into it now.
    for (std::size_t i = 0; i < chunk_.triangles.size(); ++i)
      chunk_.triangles[i].planes = chunk_.planes.data() + i * planes_each;
    if (stage_.topology == Topology::Triangles)
      sort_into_tiles(chunk_.triangles);
    else
      sort_into_tiles(chunk_.points);
  }

 private:
  std::size_t vertex_index(std::size_t corner) const {
    return stage_.indices && !stage_.indices->empty() ? (*stage_.indices)[corner] : corner;
  }

  void add_point(std::size_t i) {
    const auto set_up = stage_.topology == Topology::Points ? set_up_point : set_up_rectangle;
    PointRecord record;
    record.primitive = static_cast<std::int32_t>(i);
    if (set_up(stage_.vertices->at(vertex_index(i)), viewport_, record)) chunk_.points.push_back(record);
  }

  void add_triangle(std::size_t i) {
    const float* corner[3];
    for (std::size_t k = 0; k < 3; ++k) corner[k] = stage_.vertices->at(vertex_index(3 * i + k));
    const float* provoking = corner[2] + ShadedVertices::kHeader;
    if (is_inside(corner[0]) && is_inside(corner[1]) && is_inside(corner[2])) {
      set_up({to_window(corner[0], false, viewport_), to_window(corner[1], false, viewport_),
              to_window(corner[2], false, viewport_)},
             provoking, i);
      return;
    }
    std::vector<float> storage;
    const ClippedPolygon polygon =
        clip_triangle(corner[0], corner[1], corner[2], stage_.vertices->stride, storage);
    if (polygon.count < 3) return;
    WindowVertex v[ClippedPolygon::kMaxVertices];
    for (int k = 0; k < polygon.count; ++k) v[k] = to_window(polygon.vertices[k], polygon.made[k], viewport_);
    for (int k = 2; k < polygon.count; ++k) set_up({v[k - 1], v[k], v[0]}, provoking, i);
  }

  void set_up(const WindowVertex (&v)[3], const float* provoking, std::size_t primitive) {
    TriangleRecord record;
    record.primitive = static_cast<std::int32_t>(primitive);
    if (set_up_triangle(v, provoking, viewport_, stage_.options, record, chunk_.planes))
      chunk_.triangles.push_back(record);
  }

  template <class Record>
  void sort_into_tiles(const std::vector<Record>& records) {
    const auto each_tile = [&](const Record& r, const auto& visit) {
      for (int row = r.y_first / kTile; row <= r.y_last / kTile; ++row)
        for (int column = r.x_first / kTile; column <= r.x_last / kTile; ++column)
          visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(grid_.columns) +
                static_cast<std::size_t>(column));
    };
    chunk_.first.assign(static_cast<std::size_t>(grid_.count()) + 1, 0);
    for (const Record& r : records) each_tile(r, [&](std::size_t t) { ++chunk_.first[t + 1]; });
    for (std::size_t t = 1; t < chunk_.first.size(); ++t) chunk_.first[t] += chunk_.first[t - 1];
    chunk_.touching.resize(chunk_.first.back());
    std::vector<std::uint32_t> next(chunk_.first.begin(), chunk_.first.end() - 1);
    for (std::size_t i = 0; i < records.size(); ++i)
      each_tile(records[i],
                [&](std::size_t t) { chunk_.touching[next[t]++] = static_cast<std::uint32_t>(i); });
  }

  const PrimitiveStage& stage_;
  const TileGrid& grid_;
  Viewport viewport_;
  BinnedChunk& chunk_;
};

}  // namespace

void bin_primitives(const PrimitiveStage& stage, std::size_t first, std::size_t count, const TileGrid& grid,
                    const Workers& workers, std::vector<BinnedChunk>& chunks) {
  chunks.resize((count + kPrimitivesPerChunk - 1) / kPrimitivesPerChunk);
  workers.run(static_cast<int>(chunks.size()), [&](int chunk) {
    const std::size_t begin = first + static_cast<std::size_t>(chunk) * kPrimitivesPerChunk;
    ChunkBuilder(stage, grid, chunks[static_cast<std::size_t>(chunk)])
        .build(begin, std::min(begin + kPrimitivesPerChunk, first + count));
  });
}

}  // namespace caustics::raster
