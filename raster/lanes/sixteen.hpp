// Sixteen neighbouring pixels of a row as vectors, whatever the instruction set; compilers take them apart
// where its registers are narrower. As tile_renderer.hpp, which includes it in the namespace of one
// instruction set.
#pragma once
#include <cstdint>

#if defined(__AVX2__)
#include <immintrin.h>
#elif defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "pipeline/shader/kernel.hpp"

namespace caustics::raster::CAUSTICS_TILE_NAMESPACE {

static_assert(kBlock == 16);
using Floats = float __attribute__((vector_size(64)));
using Ints = std::int32_t __attribute__((vector_size(64)));

using Texel = float __attribute__((vector_size(16)));

inline constexpr Ints kNeighbours = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

inline Floats load_floats(const float* p) {
  Floats v;
  __builtin_memcpy(&v, p, sizeof v);
  return v;
}
inline Ints load_ints(const std::int32_t* p) {
  Ints v;
  __builtin_memcpy(&v, p, sizeof v);
  return v;
}
inline void store_floats(float* p, Floats v) { __builtin_memcpy(p, &v, sizeof v); }
inline void store_ints(std::int32_t* p, Ints v) { __builtin_memcpy(p, &v, sizeof v); }

inline Floats broadcast(float s) { return s - Floats{}; }
inline Floats to_floats(Ints v) { return __builtin_convertvector(v, Floats); }

// Comparisons, choices and calls of sixteen: GCC takes them apart one by one where registers are narrower.
#if defined(__AVX512F__)
inline constexpr int kRegister = 64;  // bytes
#elif defined(__AVX2__)
inline constexpr int kRegister = 32;
#else
inline constexpr int kRegister = 16;
#endif
using FloatRegister = float __attribute__((vector_size(kRegister)));
using IntRegister = std::int32_t __attribute__((vector_size(kRegister)));

inline Ints less(Floats a, Floats b) {
  FloatRegister x[64 / kRegister], y[64 / kRegister];
  IntRegister result[64 / kRegister];
  __builtin_memcpy(x, &a, sizeof a);
  __builtin_memcpy(y, &b, sizeof b);
  for (int i = 0; i < 64 / kRegister; ++i) result[i] = x[i] < y[i];
  Ints v;
  __builtin_memcpy(&v, result, sizeof v);
  return v;
}

// Of `a` where the condition is -1, of `b` where it is 0.
inline Floats chosen(Ints condition, Floats a, Floats b) {
  return (Floats)(((Ints)a & condition) | ((Ints)b & ~condition));
}

// a * b + c, rounded once.
inline Floats fused(Floats a, Floats b, Floats c) {
#if defined(__AVX512F__)
  return (Floats)_mm512_fmadd_ps((__m512)a, (__m512)b, (__m512)c);
#elif defined(__AVX2__) && defined(__FMA__)
  __m256 x[2], y[2], z[2];
  __builtin_memcpy(x, &a, sizeof a);
  __builtin_memcpy(y, &b, sizeof b);
  __builtin_memcpy(z, &c, sizeof c);
  for (int i = 0; i < 2; ++i) z[i] = _mm256_fmadd_ps(x[i], y[i], z[i]);
  __builtin_memcpy(&c, z, sizeof c);
  return c;
#else
  Floats sum;
  for (int lane = 0; lane < kBlock; ++lane) sum[lane] = __builtin_fmaf(a[lane], b[lane], c[lane]);
  return sum;
#endif
}

// A bit for each of sixteen conditions, 0 or -1: the lowest is the first one's.
inline unsigned bits_of(Ints conditions) {
#if defined(__AVX512DQ__)
  return _mm512_movepi32_mask((__m512i)conditions);
#elif defined(__AVX2__)
  __m256 part[2];
  __builtin_memcpy(part, &conditions, sizeof part);
  return static_cast<unsigned>(_mm256_movemask_ps(part[0]) | _mm256_movemask_ps(part[1]) << 8);
#elif defined(__SSE2__)
  __m128 part[4];
  __builtin_memcpy(part, &conditions, sizeof part);
  return static_cast<unsigned>(_mm_movemask_ps(part[0]) | _mm_movemask_ps(part[1]) << 4 |
                               _mm_movemask_ps(part[2]) << 8 | _mm_movemask_ps(part[3]) << 12);
#else
  unsigned bits = 0;
  for (int lane = 0; lane < kBlock; ++lane) bits |= static_cast<unsigned>(conditions[lane] & 1) << lane;
  return bits;
#endif
}

// Four values in a row at each of sixteen places, as four rows of sixteen.
inline void transpose_four(const float* const* places, int first, float (*rows)[kBlock]) {
#if defined(__SSE2__)
  for (int lane = 0; lane < kBlock; lane += 4) {
    __m128 a = _mm_loadu_ps(places[lane] + first), b = _mm_loadu_ps(places[lane + 1] + first);
    __m128 c = _mm_loadu_ps(places[lane + 2] + first), d = _mm_loadu_ps(places[lane + 3] + first);
    _MM_TRANSPOSE4_PS(a, b, c, d);
    _mm_storeu_ps(rows[0] + lane, a);
    _mm_storeu_ps(rows[1] + lane, b);
    _mm_storeu_ps(rows[2] + lane, c);
    _mm_storeu_ps(rows[3] + lane, d);
  }
#else
  for (int lane = 0; lane < kBlock; ++lane)
    for (int c = 0; c < 4; ++c) rows[c][lane] = places[lane][first + c];
#endif
}

// Four rows of sixteen as sixteen neighbours of four values each.
inline void replace_row(float (*texels)[4], const float (*rows)[kBlock]) {
#if defined(__SSE2__)
  for (int lane = 0; lane < kBlock; lane += 4) {
    __m128 a = _mm_loadu_ps(rows[0] + lane), b = _mm_loadu_ps(rows[1] + lane);
    __m128 c = _mm_loadu_ps(rows[2] + lane), d = _mm_loadu_ps(rows[3] + lane);
    _MM_TRANSPOSE4_PS(a, b, c, d);
    _mm_storeu_ps(texels[lane], a);
    _mm_storeu_ps(texels[lane + 1], b);
    _mm_storeu_ps(texels[lane + 2], c);
    _mm_storeu_ps(texels[lane + 3], d);
  }
#else
  for (int lane = 0; lane < kBlock; ++lane)
    for (int c = 0; c < 4; ++c) texels[lane][c] = rows[c][lane];
#endif
}

}  // namespace caustics::raster::CAUSTICS_TILE_NAMESPACE
