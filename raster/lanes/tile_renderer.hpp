// Coverage, depth, interpolation, shading and blending of one tile. Included once for each instruction
// set, in a namespace of its own; uses nothing whose inline functions the linker could share.
//
// Primitives come in API order. Their fragments are collected sixteen at a time, across primitives, so
// that small triangles fill the lanes too; within a pixel the order stays the API's because depth is
// tested while collecting, or after shading lane by lane, and blending runs lane by lane.
#pragma once
#include "raster/lanes/merging.hpp"
#include "raster/tile_job.hpp"

namespace caustics::raster::CAUSTICS_TILE_NAMESPACE {

inline int larger(int a, int b) { return a > b ? a : b; }
inline int smaller(int a, int b) { return a < b ? a : b; }

inline float evaluate(const Plane& plane, float x, float y) {
  return __builtin_fmaf(plane.per_y, y, __builtin_fmaf(plane.per_x, x, plane.origin));
}

inline bool passes(Compare compare, float incoming, float stored) {
  switch (compare) {
    case Compare::Always:
      return true;
    case Compare::Less:
      return incoming < stored;
    case Compare::LessEqual:
      return incoming <= stored;
    case Compare::Greater:
      return incoming > stored;
    case Compare::GreaterEqual:
      return incoming >= stored;
    case Compare::Equal:
      return incoming == stored;
    case Compare::Never:
      return false;
  }
  return false;
}

struct Span {
  float first, last;
};

// Lengthens a span of a row by what of an edge lies in it.
inline void add_edge(Span& span, const float* p, const float* q, float lower, float upper) {
  if (p[1] > q[1]) {
    const float* const swapped = p;
    p = q;
    q = swapped;
  }
  if (q[1] < lower || p[1] > upper) return;
  const float rise = q[1] - p[1];
  const float slope = rise > 0.0f ? (q[0] - p[0]) / rise : 0.0f;
  const float from = p[1] < lower ? p[0] + (lower - p[1]) * slope : p[0];
  const float to = q[1] > upper ? p[0] + (upper - p[1]) * slope : q[0];
  const float left = from < to ? from : to, right = from < to ? to : from;
  if (left < span.first) span.first = left;
  if (right > span.last) span.last = right;
}

// Where a row of pixels meets the triangles (a, b, c) and (d, c, b), with the margin: none of it where
// `first` is larger. Rounding takes less than half of the margin: corners are less than 2^15 pixels apart.
inline Span quad_span(const float* corners, int row) {
  const float *const a = corners, *const b = corners + 2, *const c = corners + 4, *const d = corners + 6;
  const float lower = static_cast<float>(row) - kQuadMargin,
              upper = static_cast<float>(row + 1) + kQuadMargin;
  Span span{1e30f, -1e30f};
  add_edge(span, a, b, lower, upper);
  add_edge(span, c, a, lower, upper);
  add_edge(span, b, c, lower, upper);
  add_edge(span, d, c, lower, upper);
  add_edge(span, b, d, lower, upper);
  return {span.first - kQuadMargin, span.last + kQuadMargin};
}

class TileRenderer {
 public:
  TileRenderer(const TileJob& job, TileCounters& counters) : job_(job), counters_(counters) {
    for (int i = 0; i < job.color_count; ++i) merging_[i] = merging_of(job.colors[i]);
  }

  void run() {
    for (int c = 0; c < job_.chunk_count; ++c) {
      const PrimitiveChunk& chunk = job_.chunks[c];
      for (std::uint32_t i = 0; i < chunk.count; ++i) {
        if (job_.is_points)
          draw_point(chunk.points[chunk.touching[i]]);
        else
          draw_triangle(chunk.triangles[chunk.touching[i]]);
      }
    }
    flush();
  }

 private:
  void draw_point(const PointRecord& point) {
    const int x_last = smaller(point.x_last, job_.x + job_.width - 1);
    const int y_last = smaller(point.y_last, job_.y + job_.height - 1);
    const int x_first = larger(point.x_first, job_.x), y_first = larger(point.y_first, job_.y);
    const bool narrows = job_.zero_outside_quad >= 0 && x_last - x_first >= 3 && y_last > y_first;
    for (int y = y_first; y <= y_last; ++y) {
      if (!narrows) {
        add_row(x_first, x_last, y, point);
        continue;
      }
      const Span span = quad_span(point.varyings + job_.zero_outside_quad, y);
      if (!(span.first <= span.last)) continue;
      const float first = static_cast<float>(x_first), last = static_cast<float>(x_last);
      // Truncated below 0 too: there the row begins anyway.
      add_row(static_cast<int>(span.first > first ? span.first : first),
              static_cast<int>(span.last < last ? span.last : last), y, point);
    }
  }

  void add_row(int x_first, int x_last, int y, const PointRecord& point) {
    if (job_.depth) {
      for (int x = x_first; x <= x_last; ++x) add(x, y, point.z, nullptr, point.varyings, -1, 0);
      return;
    }
    const int pixel = (y - job_.y) * kTile - job_.x;
    for (int x = x_first; x <= x_last;) {
      const int end = smaller(x_last + 1, x + kBlock - count_);
      for (; x < end; ++x, ++count_) {
        pixel_[count_] = pixel + x;
        x_[count_] = static_cast<float>(x);
        y_[count_] = static_cast<float>(y);
        z_[count_] = point.z;
        planes_[count_] = nullptr;
        constant_[count_] = point.varyings;
        front_[count_] = -1;
        primitive_[count_] = 0;
      }
      if (count_ == kBlock) flush();
    }
  }

  void draw_triangle(const TriangleRecord& t) {
    const int x_first = larger(t.x_first, job_.x), y_first = larger(t.y_first, job_.y);
    const int x_last = smaller(t.x_last, job_.x + job_.width - 1);
    const int y_last = smaller(t.y_last, job_.y + job_.height - 1);
    if (x_first > x_last || y_first > y_last) return;
    // Edge values at the first pixel. Over a tile they change by less than 2^28, so an edge farther from
    // 0 than that contains all of it or none, and the rest fits 32 bits.
    std::int32_t row[3], dx[3], dy[3];
    int edges = 0;
    for (int i = 0; i < 3; ++i) {
      const std::int64_t e = t.c[i] + std::int64_t{t.dx[i]} * y_first - std::int64_t{t.dy[i]} * x_first;
      const std::int64_t across = -std::int64_t{t.dy[i]} * (x_last - x_first);
      const std::int64_t up = std::int64_t{t.dx[i]} * (y_last - y_first);
      const std::int64_t lowest = e + (across < 0 ? across : 0) + (up < 0 ? up : 0);
      const std::int64_t highest = e + (across > 0 ? across : 0) + (up > 0 ? up : 0);
      if (highest < 0) return;
      if (lowest >= 0) continue;
      row[edges] = static_cast<std::int32_t>(e);
      dx[edges] = t.dx[i];
      dy[edges] = t.dy[i];
      ++edges;
    }
    if (edges == 0 && !job_.depth) return fill(x_first, x_last, y_first, y_last, t);
    for (int i = edges; i < 3; ++i) row[i] = dx[i] = dy[i] = 0;
    for (int y = y_first; y <= y_last; ++y) {
      std::int32_t a = row[0], b = row[1], c = row[2];
      for (int x = x_first; x <= x_last; ++x) {
        if ((a | b | c) >= 0) add_of_triangle(x, y, t);
        a -= dy[0];
        b -= dy[1];
        c -= dy[2];
      }
      row[0] += dx[0];
      row[1] += dx[1];
      row[2] += dx[2];
    }
  }

  // A rectangle that the triangle covers whole.
  void fill(int x_first, int x_last, int y_first, int y_last, const TriangleRecord& t) {
    flush();
    in_row_ = true;
    for (int lane = 0; lane < kBlock; ++lane) {
      z_[lane] = 0.0f;
      planes_[lane] = t.planes;
      constant_[lane] = t.provoking;
      front_[lane] = t.front_facing;
      primitive_[lane] = t.primitive;
    }
    for (int y = y_first; y <= y_last; ++y)
      for (int x = x_first; x <= x_last; x += kBlock) {
        count_ = smaller(kBlock, x_last - x + 1);
        for (int lane = 0; lane < kBlock; ++lane) {
          const int inside = smaller(x + lane, x_last);
          pixel_[lane] = (y - job_.y) * kTile + (inside - job_.x);
          x_[lane] = static_cast<float>(inside);
          y_[lane] = static_cast<float>(y);
        }
        run_block();
      }
    in_row_ = false;
  }

  void add_of_triangle(int x, int y, const TriangleRecord& t) {
    float z = 0.0f;
    if (job_.depth) {
      // Rounding leads thin triangles out of the range of window depth (13.6.1), to which it is clamped.
      z = evaluate(t.planes[0], static_cast<float>(x), static_cast<float>(y));
      z = z < 0.0f ? 0.0f : z > 1.0f ? 1.0f : z;
    }
    add(x, y, z, t.planes, t.provoking, t.front_facing, t.primitive);
  }

  bool depth_passes(int pixel, float z) {
    if (!job_.depth) return true;
    if (!passes(job_.depth_state.compare, z, job_.depth[pixel])) return false;
    if (job_.depth_state.write) job_.depth[pixel] = z;
    return true;
  }

  void add(int x, int y, float z, const Plane* planes, const float* constant, std::int32_t front,
           std::int32_t primitive) {
    const int pixel = (y - job_.y) * kTile + (x - job_.x);
    if (!job_.test_depth_late && !depth_passes(pixel, z)) return;
    const int lane = count_++;
    pixel_[lane] = pixel;
    x_[lane] = static_cast<float>(x);
    y_[lane] = static_cast<float>(y);
    z_[lane] = z;
    planes_[lane] = planes;
    constant_[lane] = constant;
    front_[lane] = front;
    primitive_[lane] = primitive;
    if (count_ == kBlock) flush();
  }

  void flush() {
    if (count_ == 0) return;
    for (int lane = count_; lane < kBlock; ++lane) {
      x_[lane] = x_[0];
      y_[lane] = y_[0];
      planes_[lane] = planes_[0];
      constant_[lane] = constant_[0];
      front_[lane] = front_[0];
      primitive_[lane] = primitive_[0];
    }
    run_block();
  }

  void run_block() {
    interpolate();
    shade();
    merge();
    counters_.fragments += static_cast<std::uint64_t>(count_);
    count_ = 0;
  }

  void interpolate() {
    if (job_.varying_count == 0) return;
    bool one_triangle = planes_[0] != nullptr;
    for (int lane = 1; lane < kBlock; ++lane) one_triangle &= planes_[lane] == planes_[0];
    float w[kBlock];
    if (planes_[0])
      for (int lane = 0; lane < kBlock; ++lane)
        w[lane] = 1.0f / evaluate(planes_[lane][1], x_[lane], y_[lane]);
    bool one_constant = true;
    for (int lane = 1; lane < kBlock; ++lane) one_constant &= constant_[lane] == constant_[0];
    for (int c = 0; c < job_.varying_count; ++c) {
      float* out = varyings_[c];
      const bool flat = !planes_[0] || job_.varying_flat[c];
      if (flat && one_constant) {
        const float value = constant_[0][c];
        for (int lane = 0; lane < kBlock; ++lane) out[lane] = value;
      } else if (flat) {
        for (int lane = 0; lane < kBlock; ++lane) out[lane] = constant_[lane][c];
      } else if (one_triangle) {
        const Plane plane = planes_[0][2 + c];
        for (int lane = 0; lane < kBlock; ++lane) out[lane] = evaluate(plane, x_[lane], y_[lane]) * w[lane];
      } else {
        for (int lane = 0; lane < kBlock; ++lane)
          out[lane] = evaluate(planes_[lane][2 + c], x_[lane], y_[lane]) * w[lane];
      }
    }
  }

  void shade() {
    float center_x[kBlock], center_y[kBlock];
    for (int lane = 0; lane < kBlock; ++lane) {
      center_x[lane] = x_[lane] + 0.5f;
      center_y[lane] = y_[lane] + 0.5f;
      discarded_[lane] = 0;
    }
    job_.fragment({job_.uniforms, job_.textures, center_x, center_y, front_, primitive_, varyings_, outputs_,
                   discarded_, nullptr});
  }

  void merge() {
    for (int i = 0; i < job_.color_count; ++i)
      if (merging_[i] == Merging::ReplaceByte)
        for (int c = 0; c < 4; ++c) round_to_bytes(outputs_[4 * i + c]);
    if (in_row_ && count_ == kBlock && nothing_discarded()) {
      merge_row();
      return;
    }
    for (int lane = 0; lane < count_; ++lane) {
      if (discarded_[lane]) continue;
      if (job_.test_depth_late && !depth_passes(pixel_[lane], z_[lane])) continue;
      if (counters_.samples_passed == 0) job_.load_colors(job_.tile);
      ++counters_.samples_passed;
      for (int i = 0; i < job_.color_count; ++i) merge_into(i, lane);
    }
  }

  bool nothing_discarded() const {
    std::int32_t any = 0;
    for (int lane = 0; lane < kBlock; ++lane) any |= discarded_[lane];
    return any == 0;
  }

  // Sixteen neighbours in a row, of a triangle that is drawn without a depth test.
  void merge_row() {
    if (counters_.samples_passed == 0) job_.load_colors(job_.tile);
    counters_.samples_passed += static_cast<std::uint64_t>(kBlock);
    for (int i = 0; i < job_.color_count; ++i) {
      if (merging_[i] == Merging::Replace || merging_[i] == Merging::ReplaceByte)
        replace_row(job_.colors[i].texels + pixel_[0], outputs_ + 4 * i);
      else
        for (int lane = 0; lane < kBlock; ++lane) merge_into(i, lane);
    }
  }

  void merge_into(int i, int lane) {
    merge_texel(job_.colors[i], merging_[i], job_.colors[i].texels[pixel_[lane]], outputs_ + 4 * i, lane);
  }

  const TileJob& job_;
  TileCounters& counters_;
  Merging merging_[kMaxColors] = {};
  int count_ = 0;
  bool in_row_ = false;  // the block is of neighbours in a row, without a depth test
  int pixel_[kBlock];
  alignas(64) float x_[kBlock], y_[kBlock], z_[kBlock];
  const Plane* planes_[kBlock];
  const float* constant_[kBlock];
  alignas(64) std::int32_t front_[kBlock], primitive_[kBlock], discarded_[kBlock];
  alignas(64) float varyings_[64][kBlock];
  alignas(64) float outputs_[4 * kMaxColors][kBlock];
};

inline void render(const TileJob& job, TileCounters& counters) { TileRenderer(job, counters).run(); }

}  // namespace caustics::raster::CAUSTICS_TILE_NAMESPACE
