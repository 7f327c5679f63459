#include "raster/texture.hpp"

#include <sys/mman.h>

#include <cstdint>
#include <cstdlib>
#include <new>

namespace caustics::raster {

namespace {

constexpr std::size_t kLargePage = std::size_t{1} << 21;

// Whole large pages: what is mapped beside them goes back.
float* map_large_pages(std::size_t bytes) {
  void* const all =
      mmap(nullptr, bytes + kLargePage, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (all == MAP_FAILED) throw std::bad_alloc();
  auto* const first = static_cast<std::byte*>(all);
  const std::size_t before = (kLargePage - reinterpret_cast<std::uintptr_t>(all) % kLargePage) % kLargePage;
  if (before > 0) munmap(first, before);
  if (before < kLargePage) munmap(first + before + bytes, kLargePage - before);
  // Where it is refused, pages stay small.
  madvise(first + before, bytes, MADV_HUGEPAGE);
  return reinterpret_cast<float*>(first + before);
}

}  // namespace

void FreeTexels::operator()(float* texels) const {
  if (mapped > 0)
    munmap(texels, mapped);
  else
    std::free(texels);
}

Texels allocate_texels(std::size_t values) {
  const std::size_t bytes = values * sizeof(float);
  if (bytes > 2 * kLargePage) {
    const std::size_t whole = (bytes + kLargePage - 1) / kLargePage * kLargePage;
    return Texels(map_large_pages(whole), FreeTexels{whole});
  }
  Texels texels(static_cast<float*>(std::malloc(bytes)));
  if (!texels) throw std::bad_alloc();
  return texels;
}

}  // namespace caustics::raster
