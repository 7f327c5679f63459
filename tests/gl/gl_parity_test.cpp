// The same runs on the software Device and on OpenGL. On llvmpipe every texel must be equal to the
// bit; other drivers may choose differently what the specification leaves open, so there the test
// only says how much differs.
#include <bit>
#include <cmath>
#include <random>

#include "tests/gl/gl_or_skip.hpp"
#include "tests/raster/raster_bench.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// Uniform in [-1, 1) from the generator's bits alone.
float random_value(std::mt19937& bits) { return static_cast<float>(bits() >> 8) * 0x1p-23f - 1.0f; }

std::uint32_t bits_of(float value) {
  return std::isnan(value) ? 0x7fc00000u : std::bit_cast<std::uint32_t>(value);
}

struct Difference {
  std::size_t values = 0, differing = 0, drawn = 0;
};

Difference compare(const std::vector<Image>& a, const std::vector<Image>& b) {
  Difference d;
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    REQUIRE(a[i].shape == b[i].shape);
    for (std::size_t k = 0; k < a[i].values.size(); ++k) {
      ++d.values;
      if (a[i].values[k] != a[i].values[0]) ++d.drawn;
      if (bits_of(a[i].values[k]) == bits_of(b[i].values[k])) continue;
      if (d.differing++ < 3)
        WARN("image " << i << " value " << k << ": software " << a[i].values[k] << ", gl "
                      << b[i].values[k]);
    }
  }
  return d;
}

// Draws the same on both devices.
void expect_same(GlDevice& device, RasterBench bench, const std::vector<RasterVertex>& vertices) {
  const std::vector<Image> software = bench.draw(vertices);
  const PassResult counted = bench.result;
  bench.on = &device;
  const std::vector<Image> gl = bench.draw(vertices);
  const Difference d = compare(software, gl);
  CHECK(d.drawn > 0);
  if (!is_llvmpipe(device)) {
    WARN(d.differing << " of " << d.values << " values differ on " << device.description());
    return;
  }
  CHECK(d.differing == 0);
  CHECK(bench.result.samples_passed == counted.samples_passed);
  CHECK(bench.result.vertices == counted.vertices);
  CHECK(bench.result.primitives == counted.primitives);
}

// `spread` 1 stays inside the view volume; beyond, primitives are clipped. Whole triangles or
// points.
std::vector<RasterVertex> random_vertices(std::mt19937& bits, int count, float spread,
                                          float w_range, float largest_point) {
  std::vector<RasterVertex> v(static_cast<std::size_t>(count));
  for (RasterVertex& r : v) {
    r.w = 1.0f + w_range * random_value(bits);
    r.x = spread * random_value(bits) * r.w;
    r.y = spread * random_value(bits) * r.w;
    r.z = (0.5f + 0.5f * std::min(spread, 1.2f) * 0.99f * random_value(bits)) * r.w;
    r.red = random_value(bits);
    r.green = 0.5f + 0.5f * random_value(bits);
    r.blue = 100.0f * random_value(bits);
    r.alpha = 0.5f + 0.5f * random_value(bits);
    r.size = 0.5f * largest_point * (1.0f + random_value(bits));
  }
  return v;
}

RasterBench two_targets(int width, int height) {
  RasterBench b;
  b.width = width;
  b.height = height;
  b.definition.shader = &raster_two_targets_shader;
  b.definition.writes = {{.name = "a", .meaning = "m"}, {.name = "b", .meaning = "m"}};
  b.definition.depth = DepthWrite{.name = "depth", .meaning = "m"};
  b.definition.depth_state = {Compare::Less, true};
  b.definition.count_samples = true;
  return b;
}

}  // namespace

TEST_CASE("parity: triangles inside the view volume, two targets and depth") {
  const auto device = gl_or_skip();
  if (!device) return;
  std::mt19937 bits(1);
  for (const auto& [width, height] : {std::pair{128, 128}, {117, 85}, {240, 180}})
    for (const float w_range : {0.0f, 0.9f}) {
      INFO(width << " x " << height << ", w 1 +- " << w_range);
      expect_same(*device, two_targets(width, height),
                  random_vertices(bits, 900, 0.98f, w_range, 1.0f));
    }
}

TEST_CASE("parity: triangles that are clipped") {
  const auto device = gl_or_skip();
  if (!device) return;
  std::mt19937 bits(2);
  for (const auto& [width, height] : {std::pair{128, 128}, {117, 85}})
    for (const float spread : {1.3f, 4.0f}) {
      INFO(width << " x " << height << ", spread " << spread);
      expect_same(*device, two_targets(width, height),
                  random_vertices(bits, 600, spread, 0.7f, 1.0f));
    }
}

TEST_CASE("parity: culling, each comparison of depth, discard") {
  const auto device = gl_or_skip();
  if (!device) return;
  std::mt19937 bits(3);
  for (const Cull cull : {Cull::None, Cull::Back, Cull::Front})
    for (const Compare compare :
         {Compare::Always, Compare::Less, Compare::LessEqual, Compare::Greater,
          Compare::GreaterEqual, Compare::Equal, Compare::Never})
      for (const bool write : {true, false}) {
        RasterBench b = two_targets(64, 48);
        b.definition.cull = cull;
        b.definition.depth_state = {compare, write};
        b.definition.depth->clear = 0.5f;
        std::vector<RasterVertex> v = random_vertices(bits, 90, 0.95f, 0.3f, 1.0f);
        for (std::size_t i = 0; i < 30; ++i) v[i].z = 0.5f * v[i].w;
        INFO("cull " << int(cull) << " compare " << int(compare) << " write " << write);
        if (compare == Compare::Never) {
          b.on = device.get();
          b.draw(v);
          CHECK(b.result.samples_passed == 0);
        } else if (compare == Compare::Equal) {
          // Depth 0.5 everywhere on one triangle is equal only where interpolation is exact.
          for (RasterVertex& r : v) r.x /= r.w, r.y /= r.w, r.w = 1.0f, r.z = 0.5f;
          expect_same(*device, b, v);
        } else {
          expect_same(*device, b, v);
        }
      }
  RasterBench b = two_targets(64, 48);
  b.definition.writes.pop_back();
  b.definition.shader = &raster_discard_shader;
  std::vector<RasterVertex> v = random_vertices(bits, 300, 0.95f, 0.3f, 1.0f);
  for (std::size_t i = 0; i < v.size(); ++i) v[i].red = i / 3 % 3 == 0 ? 0.0f : v[i].red;
  expect_same(*device, b, v);
}

TEST_CASE("parity: every blend equation and factor, in every format, with masks") {
  const auto device = gl_or_skip();
  if (!device) return;
  std::mt19937 bits(4);
  const BlendFactor factors[] = {BlendFactor::Zero,
                                 BlendFactor::One,
                                 BlendFactor::SourceColor,
                                 BlendFactor::SourceAlpha,
                                 BlendFactor::OneMinusSourceAlpha,
                                 BlendFactor::DestinationColor};
  const ColorMask masks[] = {kAllChannels, {true, false, true, false}, {false, true, true, true}};
  int round = 0;
  for (const Format format :
       {Format::RGBA32F, Format::RG32F, Format::R32F, Format::RGBA16F, Format::RGBA8})
    for (const BlendEquation equation :
         {BlendEquation::Add, BlendEquation::Min, BlendEquation::Max})
      for (const BlendFactor source : factors)
        for (const BlendFactor destination : factors) {
          if (equation != BlendEquation::Add && source != destination) continue;
          RasterBench b;
          b.width = b.height = 24;
          b.definition.writes[0] = {.name = "a",
                                    .format = format,
                                    .meaning = "m",
                                    .clear = {0.25f, 0.5f, 0.75f, 1.0f},
                                    .blend = {true, equation, source, destination},
                                    .mask = masks[round++ % 3]};
          std::vector<RasterVertex> v = random_vertices(bits, 45, 0.95f, 0.0f, 1.0f);
          for (RasterVertex& r : v) r.blue *= 0.01f;
          INFO(format_name(format) << " equation " << int(equation) << " source " << int(source)
                                   << " destination " << int(destination));
          b.definition.shader = &raster_probe_shader;
          const bool unchanged = equation == BlendEquation::Add && source == BlendFactor::Zero &&
                                 destination == BlendFactor::One;
          if (!unchanged && !(format == Format::R32F && !b.definition.writes[0].mask[0]))
            expect_same(*device, b, v);
        }
}

TEST_CASE("parity: points of every size, additively, in float and half targets") {
  const auto device = gl_or_skip();
  if (!device) return;
  std::mt19937 bits(5);
  for (const Format format : {Format::RGBA32F, Format::R32F, Format::RGBA16F})
    for (const float largest : {1.0f, 4.0f, 17.0f})
      for (const float spread : {0.98f, 1.3f}) {
        RasterBench b;
        b.width = 117;
        b.height = 85;
        b.definition.topology = Topology::Points;
        b.definition.writes[0] = {
            .name = "a", .format = format, .meaning = "m", .blend = kAccumulate};
        b.definition.count_samples = true;
        INFO(format_name(format) << " up to " << largest << " pixels, spread " << spread);
        // Only clip depth may leave the volume by chance: points outside are dropped whole.
        expect_same(*device, b, random_vertices(bits, 3000, spread, 0.5f, largest));
      }
}

TEST_CASE("parity: flat varyings of points, bit for bit") {
  const auto device = gl_or_skip();
  if (!device) return;
  std::mt19937 bits(6);
  RasterBench b = two_targets(117, 85);
  b.definition.topology = Topology::Points;
  b.definition.writes[0].mask = {false, false, false, false};  // smooth ones may lose a last place
  expect_same(*device, b, random_vertices(bits, 2000, 1.1f, 0.5f, 9.0f));
}

TEST_CASE("parity: what is not a number is drawn or dropped alike") {
  const auto device = gl_or_skip();
  if (!device) return;
  std::mt19937 bits(7);
  for (const Topology topology : {Topology::Triangles, Topology::Points}) {
    RasterBench b = two_targets(64, 64);
    b.definition.topology = topology;
    if (topology == Topology::Points) b.definition.writes[0].mask = {false, false, false, false};
    std::vector<RasterVertex> v = random_vertices(bits, 300, 0.95f, 0.2f, 5.0f);
    for (std::size_t i = 0; i < v.size(); i += 7) {
      const float bad = i % 2 ? std::nanf("") : 1.0f / 0.0f;
      (i % 3 == 0 ? v[i].x : i % 3 == 1 ? v[i].w : v[i].red) = bad;
    }
    INFO("topology " << int(topology));
    expect_same(*device, b, v);
  }
}
