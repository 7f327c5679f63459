// A tile of a render target while a draw fills it.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "raster/target.hpp"

namespace caustics::raster {

// What an attachment is cleared to, as it holds it.
std::array<float, 4> cleared(const ColorWrite& write);
// Unless the tile is known to hold the texel.
void clear_tile(Texture& texture, int index, const std::array<float, 4>& texel);

// The attachments of a tile: compact, so that they stay in the cache.
struct TileStorage {
  alignas(64) float color[kMaxColors][kTile * kTile][4];
  alignas(64) float depth[kTile * kTile];
};

// Are most texels drawn once? Then a tile's copy would cost more than it saves.
bool is_drawn_in_place(const RenderTarget& target, const PassDefinition& definition);

class Tile {
 public:
  Tile(const TileGrid& grid, int index, const RenderTarget& target, bool in_place, TileStorage& storage);

  void load_depth();
  // Must not outlive the tile.
  TileJob job(const FragmentWork& work, const std::vector<PrimitiveChunk>& chunks);
  // `drawn`: any fragment has passed. What holds its contents anyway is left alone.
  void store(bool drawn);

 private:
  void load_colors();
  void load_color(std::size_t i);
  void load_values(std::size_t i);
  void clear_colors();
  void store_color(std::size_t i);
  float* values_of(std::size_t i) const { return storage_.color[i][0]; }

  const RenderTarget& target_;
  bool in_place_;
  TileStorage& storage_;
  std::size_t index_ = 0;
  int x_ = 0, y_ = 0, width_ = 0, height_ = 0;
};

}  // namespace caustics::raster
