// The render target of a pass, and filling its tiles.
#pragma once
#include <span>
#include <vector>

#include "raster/primitives.hpp"
#include "raster/texture.hpp"
#include "raster/tile_job.hpp"
#include "raster/workers.hpp"

namespace caustics::raster {

// The attachments of a run. What is not kept is cleared, whether or not anything is drawn there.
struct RenderTarget {
  struct Color {
    Texture* texture = nullptr;  // null: what is written goes nowhere
    const ColorWrite* write = nullptr;
    bool keep = false;
  };
  std::vector<Color> colors;
  Texture* depth = nullptr;
  float depth_clear = 1.0f;
  bool keep_depth = false;

  ImageShape shape() const;
  void clear(const Workers& workers);  // everything that is not kept
  void keep_all();                     // from now on: the next draw goes on where this one ended
};

// How the fragments of one draw are shaded.
struct FragmentWork {
  const PassDefinition* definition = nullptr;
  FragmentKernel fragment = nullptr;
  const void* uniforms = nullptr;
  const TextureView* textures = nullptr;
  int varying_count = 0;
  const std::uint8_t* varying_flat = nullptr;
  bool may_discard = false;
  // Textures of the targets' size: where a tile of one is known to be zeros, every fragment is discarded.
  std::vector<const Texture*> idle_where_zero{};
  TileKernel kernel = nullptr;
};

// What a draw's jobs have in common: all but where, what and onto which texels.
TileJob job_of(const FragmentWork& work);

// A draw's primitives, or a stretch of them, sorted into tiles.
struct BinnedDraw {
  const FragmentWork* work = nullptr;
  const std::vector<BinnedChunk>* chunks = nullptr;
};

// Draws them all, in order, into one tile after the other, so that a tile's attachments are loaded and stored
// once; the fullest tiles first, so that no thread is left with a long one at the end.
TileCounters fill_tiles(std::span<const BinnedDraw> draws, const TileGrid& grid, RenderTarget& target,
                        const Workers& workers);

}  // namespace caustics::raster
