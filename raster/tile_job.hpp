// What the per-instruction-set tile renderer is given: plain data, no types of the standard library,
// whose inline functions must not be compiled for an instruction set that not every processor has.
#pragma once
#include <cstdint>

#include "pipeline/gpu/format.hpp"
#include "pipeline/gpu/shader.hpp"
#include "pipeline/gpu/state.hpp"
#include "pipeline/shader/kernel.hpp"

namespace caustics::raster {

inline constexpr int kTile = 32;  // pixels a side: colour of one attachment fits the first-level cache
inline constexpr int kMaxColors = 8;

// A value that varies linearly over the window: at integer pixel (x, y) it is
// fma(per_y, y, fma(per_x, x, origin)).
struct Plane {
  float origin, per_x, per_y;
};

// A triangle ready to be rasterized, wound counter-clockwise.
struct TriangleRecord {
  // Edge i contains pixel (x, y) when dx[i] * y - dy[i] * x + c[i] >= 0 (24.8 coordinates; c has the
  // fill rule in it and is divided by 256, which loses nothing at pixel centres).
  std::int64_t c[3];
  std::int32_t dx[3], dy[3];
  std::int32_t x_first, x_last, y_first, y_last;  // pixels, inclusive
  const Plane* planes;                            // z, 1/w, then each varying component
  const float* provoking;                         // varyings of the provoking vertex
  std::int32_t front_facing;                      // 0 or -1
  std::int32_t primitive;                         // its place in the draw
};

// A point or a rectangle ready to be rasterized.
struct PointRecord {
  std::int32_t x_first, x_last, y_first, y_last;  // pixels, inclusive
  float z;
  std::int32_t primitive;  // its place in the draw
  const float* varyings;
};

// A stretch of primitives in API order, and those of them that touch the tile.
struct PrimitiveChunk {
  const TriangleRecord* triangles;
  const PointRecord* points;
  const std::uint32_t* touching;
  std::uint32_t count;
};

// One colour attachment's share of a tile: four floats a texel, whatever the format; both null where nothing
// is attached.
struct TileColor {
  float (*texels)[4];
  float* values;  // one a texel instead, of a single channel that is replaced or added to; else null
  Format format;
  BlendState blend;
  bool mask[4];
};

// A texture of four channels and the targets' size: fragments where it is 0 are discarded.
struct DiscardingTexture {
  const float* texels;
  int width;
};

struct TileJob {
  int x, y, width, height;  // window coordinates of the tile's lower left pixel, and its size
  TileColor colors[kMaxColors];
  int color_count;
  int row;       // texels from one row of the attachments to the next
  float* depth;  // null without a depth attachment
  DepthState depth_state;
  bool test_depth_late;  // the shader may discard
  const PrimitiveChunk* chunks;
  int chunk_count;
  bool is_points;                         // or rectangles
  int zero_outside_quad;                  // as in PassDefinition; -1: unknown
  DiscardingTexture discards_where_zero;  // null where there is none
  // Puts the colours into the tile before the first fragment is merged: most tiles of some passes have none.
  void (*load_colors)(void* tile);
  void* tile;
  FragmentKernel fragment;
  const void* uniforms;
  const TextureView* textures;
  int varying_count;                 // components
  const std::uint8_t* varying_flat;  // by component
};

struct TileCounters {
  std::uint64_t fragments = 0;
  std::uint64_t samples_passed = 0;
  std::uint64_t operations = 0;  // of the shader
};

using TileKernel = void (*)(const TileJob&, TileCounters&);

}  // namespace caustics::raster
