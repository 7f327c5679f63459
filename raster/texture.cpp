#include "raster/texture.hpp"

#include <sys/mman.h>

#include <cstdint>
#include <cstdlib>
#include <new>

namespace caustics::raster {

namespace {

constexpr std::size_t kLargePage = std::size_t{1} << 21, kSmallPage = std::size_t{1} << 12;

// Begins with a large page: what is mapped beside it goes back.
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

// Whole large pages, and small ones behind them for a rest that would leave most of a large one unused.
std::size_t bytes_of_pages(std::size_t bytes) {
  const std::size_t page = bytes % kLargePage > kLargePage / 2 ? kLargePage : kSmallPage;
  return (bytes + page - 1) / page * page;
}

}  // namespace

void FreeTexels::operator()(float* texels) const {
  if (is_shared) return;
  if (mapped > 0)
    munmap(texels, mapped);
  else
    std::free(texels);
}

Texels allocate_texels(std::size_t values) {
  const std::size_t bytes = values * sizeof(float);
  if (bytes >= kLargePage) {
    const std::size_t whole = bytes_of_pages(bytes);
    return Texels(map_large_pages(whole), FreeTexels{whole});
  }
  Texels texels(static_cast<float*>(std::malloc(bytes)));
  if (!texels) throw std::bad_alloc();
  return texels;
}

void Texture::bring_in(const Workers& workers) {
  if (is_in_) return;
  is_in_ = true;
  constexpr std::size_t kStep = kLargePage / sizeof(float);
  if (const std::size_t pages = values.get_deleter().mapped / kLargePage)
    workers.run(static_cast<int>(pages),
                [&](int page) { values[static_cast<std::size_t>(page) * kStep] = 0.0f; });
}

}  // namespace caustics::raster
