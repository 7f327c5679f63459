// Coverage, depth, interpolation, shading and blending of one tile. Included once for each instruction
// set, in a namespace of its own; uses nothing whose inline functions the linker could share.
//
// Primitives come in API order. Their fragments are collected sixteen at a time, across primitives, so
// that small triangles fill the lanes too; within a pixel the order stays the API's because depth is
// tested while collecting, or after shading lane by lane, and blending runs lane by lane.
#pragma once
#include "raster/lanes/interpolation.hpp"
#include "raster/lanes/merging.hpp"
#include "raster/lanes/sixteen.hpp"
#include "raster/tile_job.hpp"

namespace caustics::raster::CAUSTICS_TILE_NAMESPACE {

inline int larger(int a, int b) { return a > b ? a : b; }
inline int smaller(int a, int b) { return a < b ? a : b; }

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

// Where rows of pixels meet the triangles (a, b, c) and (d, c, b), with the margin. Rounding takes less than
// half of the margin: corners are less than 2^15 pixels apart.
class QuadRows {
 public:
  explicit QuadRows(const float* corners) {
    const float *const a = corners, *const b = corners + 2, *const c = corners + 4, *const d = corners + 6;
    edges_[0] = edge_between(a, b);
    edges_[1] = edge_between(c, a);
    edges_[2] = edge_between(b, c);
    edges_[3] = edge_between(d, c);
    edges_[4] = edge_between(b, d);
  }

  // None of the row where `first` is larger.
  Span at(int row) const {
    const float lower = static_cast<float>(row) - kQuadMargin,
                upper = static_cast<float>(row + 1) + kQuadMargin;
    Span span{1e30f, -1e30f};
    for (const Edge& edge : edges_) {
      if (edge.top < lower || edge.bottom > upper) continue;
      const float from =
          edge.bottom < lower ? edge.x_bottom + (lower - edge.bottom) * edge.slope : edge.x_bottom;
      const float to = edge.top > upper ? edge.x_bottom + (upper - edge.bottom) * edge.slope : edge.x_top;
      const float left = from < to ? from : to, right = from < to ? to : from;
      span.first = left < span.first ? left : span.first;
      span.last = right > span.last ? right : span.last;
    }
    return {span.first - kQuadMargin, span.last + kQuadMargin};
  }

 private:
  struct Edge {
    float x_bottom, bottom, x_top, top, slope;
  };
  static Edge edge_between(const float* p, const float* q) {
    const bool turned = p[1] > q[1];
    const float *const from = turned ? q : p, *const to = turned ? p : q;
    const float rise = to[1] - from[1];
    return {from[0], from[1], to[0], to[1], rise > 0.0f ? (to[0] - from[0]) / rise : 0.0f};
  }

  Edge edges_[5];
};

class TileRenderer {
 public:
  TileRenderer(const TileJob& job, TileCounters& counters) : job_(job), counters_(counters) {
    for (int i = 0; i < job.color_count; ++i) merging_[i] = merging_of(job.colors[i]);
    for (int lane = 0; lane < kBlock; ++lane) collected_.front[lane] = -1;
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
    if (!narrows) {
      for (int y = y_first; y <= y_last; ++y) add_row(x_first, x_last, y, point);
      return;
    }
    const QuadRows quad(point.varyings + job_.zero_outside_quad);
    for (int y = y_first; y <= y_last; ++y) {
      const Span span = quad.at(y);
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
    // Sixteen are put, as many as there are count.
    for (int x = x_first; x <= x_last;) {
      const int before = collected_.count, count = smaller(x_last + 1 - x, kBlock - before);
      place_neighbours(collected_, before, x, y);
      for (int lane = 0; lane < kBlock; ++lane) collected_.constant[before + lane] = point.varyings;
      collected_.count += count;
      x += count;
      if (collected_.count == kBlock) flush();
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
    if (edges == 0 && job_.discards_where_zero.texels && !job_.depth)
      return draw_squares(x_first, x_last, y_first, y_last, t);
    for (int i = edges; i < 3; ++i) row[i] = dx[i] = dy[i] = 0;
    const int begin = x_first - (x_first - job_.x) % kBlock;
    for (int i = 0; i < 3; ++i) row[i] += dy[i] * (x_first - begin);
    for (int y = y_first; y <= y_last; ++y) {
      for (int x = begin; x <= x_last; x += kBlock) {
        const std::int32_t edge[3] = {row[0] - dy[0] * (x - begin), row[1] - dy[1] * (x - begin),
                                      row[2] - dy[2] * (x - begin)};
        const Ints inside = covered(edge, dy, x_first - x, x_last - x);
        if (bits_of(inside) != 0) draw_neighbours(x, y, inside, t);
      }
      for (int i = 0; i < 3; ++i) row[i] += dx[i];
    }
  }

  // All pixels there whose texel is not 0, square by square of four a side: what such fragments do is more
  // alike than what sixteen in a row do.
  void draw_squares(int x_first, int x_last, int y_first, int y_last, const TriangleRecord& t) {
    flush();
    for (int y = y_first; y <= y_last; y += 4)
      for (int x = x_first; x <= x_last; x += 4)
        for (int row = y; row <= smaller(y + 3, y_last); ++row) {
          const unsigned inside = (1u << smaller(4, x_last + 1 - x)) - 1u;
          for (unsigned left = kept(inside, x, row); left != 0; left &= left - 1)
            collect(x + __builtin_ctz(left), row, 0.0f, t.planes, t.provoking, t.front_facing, t.primitive);
        }
  }

  // Which of sixteen neighbours in a row, from `first` to `last`, lie inside the edges.
  static Ints covered(const std::int32_t (&edge)[3], const std::int32_t (&dy)[3], int first, int last) {
    // The sign of what is negative outside: comparisons of sixteen are taken apart one by one where registers
    // are narrower.
    const Ints outside = (edge[0] - dy[0] * kNeighbours) | (edge[1] - dy[1] * kNeighbours) |
                         (edge[2] - dy[2] * kNeighbours) | (kNeighbours - first) | (last - kNeighbours);
    return ~(outside >> 31);
  }

  void draw_neighbours(int x, int y, Ints inside, const TriangleRecord& t) {
    Floats z{};
    if (job_.depth) {
      z = depth_of(x, y, t.planes[0]);
      float* const stored = job_.depth + pixel_at(x, y);
      inside = job_.test_depth_late ? inside & may_pass(stored, z) : test_depth(stored, z, inside);
    }
    unsigned drawn = bits_of(inside);
    if (job_.discards_where_zero.texels) drawn = kept(drawn, x, y);
    if (drawn == 0xffffu) {
      // What waits of the same triangle lies at other pixels; of an earlier one it comes first.
      if (oldest_of_ != &t) flush();
      return shade_row(x, y, z, t);
    }
    for (; drawn != 0; drawn &= drawn - 1) {
      const int lane = __builtin_ctz(drawn);
      if (collected_.count == 0) oldest_of_ = &t;
      collect(x + lane, y, z[lane], t.planes, t.provoking, t.front_facing, t.primitive);
    }
  }

  // Those of some neighbours whose texel is not 0. What is left of rows fills blocks together, so that a few
  // fragments here and there cost no more than they are.
  unsigned kept(unsigned neighbours, int x, int y) const {
    const DiscardingTexture& read = job_.discards_where_zero;
    const float* const row = read.texels + 4 * (static_cast<std::ptrdiff_t>(y) * read.width + x);
    unsigned result = 0;
    for (unsigned left = neighbours; left != 0; left &= left - 1) {
      const int lane = __builtin_ctz(left);
      std::uint64_t halves[2];
      __builtin_memcpy(halves, row + 4 * lane, sizeof halves);
      result |= static_cast<unsigned>((halves[0] | halves[1]) != 0) << lane;
    }
    return result;
  }

  // Rounding leads thin triangles out of the range of window depth (13.6.1), to which it is clamped.
  static Floats depth_of(int x, int y, const Plane& plane) {
    const Floats z = evaluate(plane, to_floats(x + kNeighbours), broadcast(static_cast<float>(y)));
    const Floats nearest{}, farthest = broadcast(1.0f);
    return chosen(less(z, nearest), nearest, chosen(less(farthest, z), farthest, z));
  }

  // What lies behind before it is shaded does so after: stored depths only come nearer.
  Ints may_pass(const float* stored, Floats z) const {
    const Floats before = load_floats(stored);
    if (job_.depth_state.compare == Compare::Less) return less(z, before);
    if (job_.depth_state.compare == Compare::Greater) return less(before, z);
    return ~Ints{};
  }

  // Which of sixteen pass, whose depths are then stored.
  Ints test_depth(float* stored, Floats z, Ints inside) const {
    const Floats before = load_floats(stored);
    Ints passing{};
    if (job_.depth_state.compare == Compare::Less)
      passing = less(z, before);
    else if (job_.depth_state.compare == Compare::Greater)
      passing = less(before, z);
    else
      for (int lane = 0; lane < kBlock; ++lane)
        passing[lane] = passes(job_.depth_state.compare, z[lane], before[lane]) ? -1 : 0;
    passing &= inside;
    if (job_.depth_state.write) store_floats(stored, chosen(passing, z, before));
    return passing;
  }

  // Sixteen neighbours at once.
  void shade_row(int x, int y, Floats z, const TriangleRecord& t) {
    if (row_of_ != &t) take_triangle(t);
    place_neighbours(row_, 0, x, y);
    interpolate(job_, t, row_, varyings_);
    shade(row_);
    merge_row(pixel_at(x, y), z);
    counters_.fragments += static_cast<std::uint64_t>(kBlock);
  }

  void take_triangle(const TriangleRecord& t) {
    for (int lane = 0; lane < kBlock; ++lane) {
      row_.front[lane] = t.front_facing;
      row_.primitive[lane] = t.primitive;
    }
    row_of_ = &t;
  }

  // From lane `first` on.
  void place_neighbours(Fragments& f, int first, int x, int y) const {
    store_ints(f.pixel + first, pixel_at(x, y) + kNeighbours);
    store_floats(f.x + first, to_floats(x + kNeighbours));
    store_floats(f.y + first, broadcast(static_cast<float>(y)));
  }

  int pixel_at(int x, int y) const { return (y - job_.y) * job_.row + (x - job_.x); }

  bool depth_passes(int pixel, float z) {
    if (!job_.depth) return true;
    if (!passes(job_.depth_state.compare, z, job_.depth[pixel])) return false;
    if (job_.depth_state.write) job_.depth[pixel] = z;
    return true;
  }

  void add(int x, int y, float z, const Plane* planes, const float* constant, std::int32_t front,
           std::int32_t primitive) {
    if (job_.test_depth_late || depth_passes(pixel_at(x, y), z))
      collect(x, y, z, planes, constant, front, primitive);
  }

  void collect(int x, int y, float z, const Plane* planes, const float* constant, std::int32_t front,
               std::int32_t primitive) {
    Fragments& f = collected_;
    const int lane = f.count++;
    f.pixel[lane] = pixel_at(x, y);
    f.x[lane] = static_cast<float>(x);
    f.y[lane] = static_cast<float>(y);
    f.z[lane] = z;
    f.planes[lane] = planes;
    f.constant[lane] = constant;
    f.front[lane] = front;
    f.primitive[lane] = primitive;
    if (f.count == kBlock) flush();
  }

  void flush() {
    Fragments& f = collected_;
    if (f.count == 0) return;
    fill_up(f);
    interpolate(job_, f, varyings_);
    shade(f);
    unsigned merged = ~bits_of(load_ints(discarded_)) & ((1u << f.count) - 1u);
    if (job_.depth && job_.test_depth_late)
      for (unsigned left = merged; left != 0; left &= left - 1) {
        const int lane = __builtin_ctz(left);
        if (!depth_passes(f.pixel[lane], f.z[lane])) merged &= ~(1u << lane);
      }
    merge_lanes(merged, f.pixel);
    counters_.fragments += static_cast<std::uint64_t>(f.count);
    f.count = 0;
  }

  void shade(const Fragments& f) {
    float center_x[kBlock], center_y[kBlock];
    for (int lane = 0; lane < kBlock; ++lane) {
      center_x[lane] = f.x[lane] + 0.5f;
      center_y[lane] = f.y[lane] + 0.5f;
      discarded_[lane] = 0;
    }
    job_.fragment({job_.uniforms, job_.textures, center_x, center_y, f.front, f.primitive, varyings_,
                   outputs_, discarded_, nullptr});
    for (int i = 0; i < job_.color_count; ++i)
      if (merging_[i] == Merging::ReplaceByte)
        for (int c = 0; c < 4; ++c) round_to_bytes(outputs_[4 * i + c]);
  }

  // Of neighbours from `pixel` on.
  void merge_row(int pixel, Floats z) {
    Ints passing = ~load_ints(discarded_);
    if (job_.depth && job_.test_depth_late) passing = test_depth(job_.depth + pixel, z, passing);
    unsigned merged = bits_of(passing);
    if (merged == 0xffffu) {
      merge_whole_row(pixel);
      return;
    }
    std::int32_t pixels[kBlock];
    store_ints(pixels, pixel + kNeighbours);
    merge_lanes(merged, pixels);
  }

  void merge_whole_row(int pixel) {
    if (counters_.samples_passed == 0) job_.load_colors(job_.tile);
    counters_.samples_passed += static_cast<std::uint64_t>(kBlock);
    for (int i = 0; i < job_.color_count; ++i)
      merge_texels(job_.colors[i], merging_[i], pixel, outputs_ + 4 * i);
  }

  void merge_lanes(unsigned lanes, const std::int32_t* pixels) {
    if (lanes == 0) return;
    if (counters_.samples_passed == 0) job_.load_colors(job_.tile);
    counters_.samples_passed += static_cast<std::uint64_t>(__builtin_popcount(lanes));
    for (int i = 0; i < job_.color_count; ++i)
      CAUSTICS_TILE_NAMESPACE::merge_lanes(job_.colors[i], merging_[i], pixels, lanes, outputs_ + 4 * i);
  }

  const TileJob& job_;
  TileCounters& counters_;
  Merging merging_[kMaxColors] = {};
  Fragments collected_;                        // of any primitives
  const TriangleRecord* oldest_of_ = nullptr;  // whose the first collected fragment is
  Fragments row_;                              // sixteen neighbours
  const TriangleRecord* row_of_ = nullptr;     // whose they are
  alignas(64) std::int32_t discarded_[kBlock];
  alignas(64) float varyings_[64 + 3][kBlock];
  alignas(64) float outputs_[4 * kMaxColors][kBlock];
};

inline void render(const TileJob& job, TileCounters& counters) { TileRenderer(job, counters).run(); }

}  // namespace caustics::raster::CAUSTICS_TILE_NAMESPACE
