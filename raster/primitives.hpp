// Primitive assembly, clipping, set-up and binning of a draw, batch by batch.
#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/gpu/pass_definition.hpp"
#include "raster/tile_job.hpp"
#include "raster/triangle_setup.hpp"
#include "raster/vertex_stage.hpp"

namespace caustics::raster {

// The tiles of a target, row by row from the bottom left.
struct TileGrid {
  int width = 0, height = 0;  // pixels
  int columns = 0, rows = 0;
  explicit TileGrid(int w, int h)
      : width(w), height(h), columns((w + kTile - 1) / kTile), rows((h + kTile - 1) / kTile) {}
  int count() const { return columns * rows; }
};

// A stretch of a draw's primitives, set up and sorted into tiles. `first[t]` to `first[t + 1]` are the
// places in `touching` of the records that touch tile t, in API order.
struct BinnedChunk {
  std::vector<TriangleRecord> triangles;
  std::vector<PointRecord> points;
  std::vector<Plane> planes;
  std::vector<std::uint32_t> first;
  std::vector<std::uint32_t> touching;

  std::size_t bytes() const {
    return triangles.capacity() * sizeof(TriangleRecord) + points.capacity() * sizeof(PointRecord) +
           planes.capacity() * sizeof(Plane) +
           (first.capacity() + touching.capacity()) * sizeof(std::uint32_t);
  }
};

struct PrimitiveStage {
  Topology topology = Topology::Triangles;
  TriangleOptions options{};
  const ShadedVertices* vertices = nullptr;
  const std::vector<std::uint32_t>* indices = nullptr;  // null or empty: vertices in order
};
// The chunks of the primitives `first` to `first` + `count` in API order, in the memory of those that are in
// `chunks`. The stage's vertices must outlive them.
void bin_primitives(const PrimitiveStage& stage, std::size_t first, std::size_t count, const TileGrid& grid,
                    const Workers& workers, std::vector<BinnedChunk>& chunks);

}  // namespace caustics::raster
