#include "raster/texture.hpp"

#include <sys/mman.h>

#include <new>

namespace caustics::raster {

namespace {
constexpr std::size_t kLargePage = std::size_t{1} << 21;
constexpr std::size_t kCacheLine = 64;
}  // namespace

Texels allocate_texels(std::size_t values) {
  const std::size_t bytes = values * sizeof(float);
  const bool large = bytes >= 2 * kLargePage;
  const std::size_t unit = large ? kLargePage : kCacheLine;
  const std::size_t whole = (bytes + unit - 1) / unit * unit;
  Texels texels(static_cast<float*>(std::aligned_alloc(unit, whole)));
  if (!texels) throw std::bad_alloc();
  // Where it is refused, pages stay small.
  if (large) madvise(texels.get(), whole, MADV_HUGEPAGE);
  return texels;
}

}  // namespace caustics::raster
