// A texture or render target of the software Device.
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <memory>
#include <vector>

#include "pipeline/gpu/image.hpp"
#include "raster/workers.hpp"

namespace caustics::raster {

inline bool same_bits(const std::array<float, 4>& a, const std::array<float, 4>& b) {
  using Bits = std::array<std::uint32_t, 4>;
  return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

struct FreeTexels {
  std::size_t mapped = 0;  // bytes; 0: of the heap
  bool is_shared = false;  // they are somebody else's
  void operator()(float* texels) const;
};
using Texels = std::unique_ptr<float[], FreeTexels>;

// Of undefined contents. Large ones lie in the system's large pages where it has them: the first touch of
// small ones takes longer than many a pass.
Texels allocate_texels(std::size_t values);

// Texels as an Image holds them, but of undefined contents when made, as on a GPU: large targets cost
// nothing before they are drawn into.
struct Texture {
  ImageShape shape;
  Texels values;
  // Tiles where nothing has been drawn since they were cleared to `clear_texel`; empty: none is known to be
  // so.
  std::array<float, 4> clear_texel{};
  std::vector<std::uint8_t> clear_tiles{};

  explicit Texture(const ImageShape& s) : shape(s), values(allocate_texels(value_count())) {}
  explicit Texture(const Image& image) : Texture(image.shape) {
    std::copy(image.values.begin(), image.values.end(), values.get());
    is_in_ = true;
  }

  // Reads where the image lies.
  static Texture sharing(const Image& image) { return Texture(image.shape, image.values.data()); }

  // Before it is drawn into for the first time: has its large pages made, each by one thread. Two that touch
  // the same page at once would both be given a cleared one, and one of these be thrown away.
  void bring_in(const Workers& workers);

  // Do its pages hold the system's zeros, untouched?
  bool is_fresh() const { return !is_in_ && values.get_deleter().mapped > 0; }

  bool is_clear(std::size_t tile, const std::array<float, 4>& texel) const {
    return !clear_tiles.empty() && clear_tiles[tile] != 0 && same_bits(clear_texel, texel);
  }

  int channels() const { return channel_count(shape.format); }
  std::size_t value_count() const {
    return static_cast<std::size_t>(shape.width) * static_cast<std::size_t>(shape.height) *
           static_cast<std::size_t>(channels());
  }
  // The texel at x, y, its channels one after the other; the row goes on behind it.
  float* texel(int x, int y) {
    return values.get() + (static_cast<std::size_t>(y) * static_cast<std::size_t>(shape.width) +
                           static_cast<std::size_t>(x)) *
                              static_cast<std::size_t>(channels());
  }
  Image image() const {
    Image copy;
    copy.shape = shape;
    copy.values.assign(values.get(), values.get() + value_count());
    return copy;
  }

 private:
  Texture(const ImageShape& s, const float* shared)
      : shape(s), values(const_cast<float*>(shared), FreeTexels{0, true}), is_in_(true) {}

  bool is_in_ = false;
};

}  // namespace caustics::raster
