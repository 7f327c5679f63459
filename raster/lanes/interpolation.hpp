// Fragments on their way to the shader, and their varyings. As tile_renderer.hpp, which includes it in the
// namespace of one instruction set.
#pragma once
#include "raster/lanes/sixteen.hpp"
#include "raster/tile_job.hpp"

namespace caustics::raster::CAUSTICS_TILE_NAMESPACE {

inline float evaluate(const Plane& plane, float x, float y) {
  return __builtin_fmaf(plane.per_y, y, __builtin_fmaf(plane.per_x, x, plane.origin));
}

inline Floats evaluate(const Plane& plane, Floats x, Floats y) {
  return fused(broadcast(plane.per_y), y, fused(broadcast(plane.per_x), x, broadcast(plane.origin)));
}

// A block of fragments. What rows are put into at once is twice as long.
struct Fragments {
  int count = 0;
  std::int32_t pixel[2 * kBlock];
  alignas(64) float x[2 * kBlock], y[2 * kBlock], z[kBlock] = {};
  const float* constant[2 * kBlock];
  const Plane* planes[kBlock] = {};  // null: of points
  alignas(64) std::int32_t front[kBlock], primitive[kBlock] = {};
};

// Lanes behind the last fragment are as the first.
inline void fill_up(Fragments& f) {
  for (int lane = f.count; lane < kBlock; ++lane) {
    f.x[lane] = f.x[0];
    f.y[lane] = f.y[0];
    f.planes[lane] = f.planes[0];
    f.constant[lane] = f.constant[0];
    f.front[lane] = f.front[0];
    f.primitive[lane] = f.primitive[0];
  }
}

// Of any primitives.
inline void interpolate(const TileJob& job, const Fragments& f, float (*varyings)[kBlock]) {
  if (job.varying_count == 0) return;
  bool one_triangle = f.planes[0] != nullptr;
  for (int lane = 1; lane < kBlock; ++lane) one_triangle &= f.planes[lane] == f.planes[0];
  float w[kBlock];
  if (f.planes[0])
    for (int lane = 0; lane < kBlock; ++lane)
      w[lane] = 1.0f / evaluate(f.planes[lane][1], f.x[lane], f.y[lane]);
  bool one_constant = true;
  for (int lane = 1; lane < kBlock; ++lane) one_constant &= f.constant[lane] == f.constant[0];
  for (int c = 0; c < job.varying_count; ++c) {
    float* out = varyings[c];
    const bool flat = !f.planes[0] || job.varying_flat[c];
    if (flat && one_constant) {
      const float value = f.constant[0][c];
      for (int lane = 0; lane < kBlock; ++lane) out[lane] = value;
    } else if (flat && !f.planes[0]) {
      transpose_four(f.constant, c, varyings + c);
      c += 3;
    } else if (flat) {
      for (int lane = 0; lane < kBlock; ++lane) out[lane] = f.constant[lane][c];
    } else if (one_triangle) {
      const Plane plane = f.planes[0][2 + c];
      for (int lane = 0; lane < kBlock; ++lane) out[lane] = evaluate(plane, f.x[lane], f.y[lane]) * w[lane];
    } else {
      for (int lane = 0; lane < kBlock; ++lane)
        out[lane] = evaluate(f.planes[lane][2 + c], f.x[lane], f.y[lane]) * w[lane];
    }
  }
}

// Of one triangle.
inline void interpolate(const TileJob& job, const TriangleRecord& t, const Fragments& f,
                        float (*varyings)[kBlock]) {
  const Floats x = load_floats(f.x), y = load_floats(f.y);
  const Floats w = broadcast(1.0f) / evaluate(t.planes[1], x, y);
  for (int c = 0; c < job.varying_count; ++c) {
    if (job.varying_flat[c]) {
      const float value = t.provoking[c];  // no arithmetic, whatever its bits mean
      for (int lane = 0; lane < kBlock; ++lane) varyings[c][lane] = value;
    } else {
      store_floats(varyings[c], evaluate(t.planes[2 + c], x, y) * w);
    }
  }
}

}  // namespace caustics::raster::CAUSTICS_TILE_NAMESPACE
