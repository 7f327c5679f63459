// Random draws that two devices must agree on. Everything follows from a test's name: the same
// name, the same draws, on every machine.
#pragma once
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "pipeline/gpu/device.hpp"
#include "pipeline/plan/pass.hpp"

namespace caustics {
extern const Shader torture_shader;
extern const Shader torture_points_shader;
}  // namespace caustics

namespace caustics::test {

// splitmix64 (Steele, Lea, Flood 2014), seeded by a hash of a name (FNV-1a).
class Random {
 public:
  explicit Random(const std::string& name) {
    for (const char c : name) state_ = (state_ ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  }
  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  // 0 .. count - 1.
  int below(int count) { return static_cast<int>(bits() % static_cast<std::uint64_t>(count)); }
  bool one_in(int count) { return below(count) == 0; }
  // Uniform in [least, most), by 24 bits.
  float between(float least, float most) {
    return least + (most - least) * (static_cast<float>(bits() >> 40) * 0x1p-24f);
  }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325u;
};

struct TortureVertex {
  float x = 0, y = 0, z = 0.5f, w = 1;  // clip coordinates
  float color[4] = {1, 1, 1, 1};
  float size = 1;
};

// One draw into random targets.
struct TortureCase {
  PassDefinition definition;
  int width = 1, height = 1;
  std::vector<TortureVertex> vertices;
  std::vector<bool> keep;
  std::vector<Image> before;  // what kept attachments hold, depth last
  float discard_below = -std::numeric_limits<float>::infinity();
};

inline void random_color(Random& random, TortureVertex& v) {
  for (float& c : v.color) c = random.between(-0.5f, 1.5f);
}

// How the three corners of one triangle are placed in a target of this size.
using TriangleMaker = std::function<void(Random&, int width, int height, TortureVertex (&corner)[3])>;

namespace torture {

inline void large(Random& r, int, int, TortureVertex (&c)[3]) {
  for (TortureVertex& v : c) {
    v.x = r.between(-0.98f, 0.98f);
    v.y = r.between(-0.98f, 0.98f);
    v.z = r.between(0.01f, 0.99f);
  }
}

inline void perspective(Random& r, int width, int height, TortureVertex (&c)[3]) {
  large(r, width, height, c);
  for (TortureVertex& v : c) {
    v.w = r.between(0.2f, 5.0f);
    v.x *= v.w;
    v.y *= v.w;
    v.z *= v.w;
  }
}

// Within some pixels of a random centre.
inline void small(Random& r, int width, int height, float pixels, TortureVertex (&c)[3]) {
  const float x = r.between(-0.9f, 0.9f), y = r.between(-0.9f, 0.9f);
  for (TortureVertex& v : c) {
    v.x = x + r.between(-pixels, pixels) / static_cast<float>(width);
    v.y = y + r.between(-pixels, pixels) / static_cast<float>(height);
    v.z = r.between(0.1f, 0.9f);
  }
}
inline void tiny(Random& r, int w, int h, TortureVertex (&c)[3]) { small(r, w, h, 1.5f, c); }
inline void medium(Random& r, int w, int h, TortureVertex (&c)[3]) { small(r, w, h, 12.0f, c); }

// Two corners within a hundredth of a pixel, the third anywhere.
inline void sliver(Random& r, int width, int height, TortureVertex (&c)[3]) {
  large(r, width, height, c);
  c[1].x = c[0].x + r.between(-0.02f, 0.02f) / static_cast<float>(width);
  c[1].y = c[0].y + r.between(-0.02f, 0.02f) / static_cast<float>(height);
}

// Corners on pixel centres, pixel borders and sub-pixel steps: every tie of the rules.
inline void aligned(Random& r, int width, int height, TortureVertex (&c)[3]) {
  const int step = r.one_in(2) ? 2 : 256;
  for (TortureVertex& v : c) {
    const float sx = static_cast<float>(r.below(width * step)) / static_cast<float>(step);
    const float sy = static_cast<float>(r.below(height * step)) / static_cast<float>(step);
    v.x = 2.0f * sx / static_cast<float>(width) - 1.0f;
    v.y = 2.0f * sy / static_cast<float>(height) - 1.0f;
    v.z = r.between(0.1f, 0.9f);
  }
}

// Far beyond the target, by up to a hundred times its size.
inline void off_screen(Random& r, int width, int height, TortureVertex (&c)[3]) {
  large(r, width, height, c);
  const float reach[3] = {1.9f, 6.0f, 100.0f};
  const float scale = reach[r.below(3)];
  for (TortureVertex& v : c) {
    v.x *= scale;
    v.y *= scale;
    v.w = r.one_in(2) ? 1.0f : r.between(0.5f, 2.0f);
  }
}

// Through the near and the far plane, in front of the eye.
inline void near_and_far(Random& r, int width, int height, TortureVertex (&c)[3]) {
  perspective(r, width, height, c);
  for (TortureVertex& v : c) v.z = r.between(-1.0f, 2.0f) * v.w;
}

// Corners behind the eye.
inline void behind_the_eye(Random& r, int width, int height, TortureVertex (&c)[3]) {
  large(r, width, height, c);
  for (TortureVertex& v : c) {
    v.w = r.between(-1.0f, 1.5f);
    v.z = r.between(-0.5f, 1.5f);
  }
}

inline float not_finite(Random& r) {
  const float values[3] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                           -std::numeric_limits<float>::infinity()};
  return values[r.below(3)];
}

// Some coordinate of some corner is NaN or infinite.
inline void non_finite_position(Random& r, int width, int height, TortureVertex (&c)[3]) {
  perspective(r, width, height, c);
  TortureVertex& v = c[r.below(3)];
  float* const coordinates[4] = {&v.x, &v.y, &v.z, &v.w};
  if (r.one_in(3)) *coordinates[r.below(4)] = not_finite(r);
}

// Degenerate: two corners coincide, or all three lie on a line.
inline void degenerate(Random& r, int width, int height, TortureVertex (&c)[3]) {
  medium(r, width, height, c);
  if (r.one_in(2)) {
    c[2] = c[1];
  } else {
    c[2].x = 0.5f * (c[0].x + c[1].x);
    c[2].y = 0.5f * (c[0].y + c[1].y);
  }
}

}  // namespace torture

// Colours to try instead of plain ones.
inline void odd_color(Random& r, TortureVertex& v) {
  static const float kOdd[] = {0.0f,     -0.0f,    1e-39f,       -1e-39f,   1.2e-38f, 65504.0f,
                               65520.0f, 6e-8f,    5.96e-8f,     1e30f,     -1e30f,   3e38f,
                               0.5f,     1.0f / 3, 127.5f / 255, 2.5f / 255};
  for (float& c : v.color) c = kOdd[r.below(static_cast<int>(std::size(kOdd)))];
}

inline void non_finite_color(Random& r, TortureVertex& v) {
  random_color(r, v);
  if (r.one_in(4)) v.color[r.below(4)] = torture::not_finite(r);
}

using Painter = void (*)(Random&, TortureVertex&);

inline std::vector<TortureVertex> random_triangles(Random& r, int count, int width, int height,
                                                   const TriangleMaker& maker, Painter paint = random_color) {
  std::vector<TortureVertex> vertices;
  for (int i = 0; i < count; ++i) {
    TortureVertex corner[3];
    maker(r, width, height, corner);
    for (TortureVertex& v : corner) {
      paint(r, v);
      vertices.push_back(v);
    }
  }
  return vertices;
}

// A sheet of jittered squares, whose triangles share every inner edge.
inline std::vector<TortureVertex> shared_edges(Random& r, int cells) {
  std::vector<TortureVertex> grid;
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) {
      TortureVertex v;
      const float step = 1.9f / static_cast<float>(cells);
      v.w = r.between(0.5f, 2.0f);
      v.x = v.w * (-0.95f + step * (static_cast<float>(i) + r.between(-0.3f, 0.3f)));
      v.y = v.w * (-0.95f + step * (static_cast<float>(j) + r.between(-0.3f, 0.3f)));
      v.z = v.w * r.between(0.1f, 0.9f);
      random_color(r, v);
      grid.push_back(v);
    }
  std::vector<TortureVertex> vertices;
  const auto at = [&](int i, int j) { return grid[static_cast<std::size_t>(j * (cells + 1) + i)]; };
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i)
      for (const TortureVertex& v :
           {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)})
        vertices.push_back(v);
  return vertices;
}

inline std::vector<TortureVertex> random_points(Random& r, int count, float largest,
                                                Painter paint = random_color) {
  std::vector<TortureVertex> vertices(static_cast<std::size_t>(count));
  for (TortureVertex& v : vertices) {
    v.w = r.one_in(2) ? 1.0f : r.between(0.25f, 4.0f);
    v.x = v.w * r.between(-1.1f, 1.1f);
    v.y = v.w * r.between(-1.1f, 1.1f);
    v.z = v.w * r.between(-0.05f, 1.05f);
    v.size = r.one_in(3) ? 0.5f * static_cast<float>(1 + r.below(128)) : r.between(0.5f, 64.0f);
    if (v.size > largest) v.size = r.between(0.5f, largest);
    paint(r, v);
  }
  return vertices;
}

// Two float targets and a depth buffer, everything drawn.
inline TortureCase plain_case(Topology topology, int width, int height) {
  TortureCase c;
  c.width = width;
  c.height = height;
  c.definition = {.name = "torture",
                  .purpose = "test",
                  .writes = {{.name = "smooth", .meaning = "m"}, {.name = "flat", .meaning = "m"}},
                  .depth = DepthWrite{.name = "depth", .meaning = "m"},
                  .topology = topology,
                  .depth_state = {Compare::Less, true},
                  .count_samples = true,
                  .shader = topology == Topology::Points ? &torture_points_shader : &torture_shader};
  return c;
}

struct TortureResult {
  std::vector<Image> images;  // colours, then depth
  PassResult counts;
};

inline TortureResult draw(Device& device, const TortureCase& c) {
  MeshData mesh;
  mesh.layout = {{"position", 4}, {"color", 4}, {"size", 1}};
  for (const TortureVertex& v : c.vertices)
    for (const float f : {v.x, v.y, v.z, v.w, v.color[0], v.color[1], v.color[2], v.color[3], v.size})
      mesh.vertices.push_back(f);
  const auto target = [&](std::size_t i, Format format) {
    return !c.keep.empty() && c.keep[i] ? device.upload(c.before[i])
                                        : device.create_texture(format, c.width, c.height);
  };
  PassRun run{.definition = &c.definition, .keep = c.keep};
  for (std::size_t i = 0; i < c.definition.writes.size(); ++i)
    run.colors.push_back(target(i, c.definition.writes[i].format));
  if (c.definition.depth) run.depth = target(run.colors.size(), Format::Depth32F);
  const float limits[4] = {c.discard_below, 0, 0, 0};
  Draw draw{.mesh = device.create_mesh(mesh)};
  draw.uniforms.resize(sizeof limits);
  std::memcpy(draw.uniforms.data(), limits, sizeof limits);
  run.draws.push_back(draw);
  TortureResult result;
  result.counts = device.run(run);
  std::vector<TextureId> targets = run.colors;
  if (c.definition.depth) targets.push_back(run.depth);
  for (const TextureId texture : targets) {
    result.images.push_back(device.read_back(texture));
    device.destroy(texture);
  }
  device.destroy(draw.mesh);
  return result;
}

}  // namespace caustics::test
