// The same runs on the software Device and on OpenGL. On llvmpipe every texel must be equal to the
// bit; other drivers may choose differently what the specification leaves open, so there the test
// only says how much differs.
#include <bit>
#include <cmath>
#include <limits>
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
  float largest = 0.0f;  // of the values, relative where they are above 1
};

Difference compare(const std::vector<Image>& a, const std::vector<Image>& b) {
  Difference d;
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    REQUIRE(a[i].shape == b[i].shape);
    for (std::size_t k = 0; k < a[i].values.size(); ++k) {
      const float x = a[i].values[k], y = b[i].values[k];
      ++d.values;
      if (x != a[i].values[0]) ++d.drawn;
      if (bits_of(x) == bits_of(y)) continue;
      if (d.differing++ == 0)
        UNSCOPED_INFO("image " << i << " value " << k << ": software " << x << ", gl " << y);
      d.largest = std::max(d.largest, std::fabs(x - y) / std::max(1.0f, std::fabs(x)));
    }
  }
  return d;
}

// Draws the same on both devices. On llvmpipe nothing may differ by more than `allowed`, and
// nothing at all where that is 0.
void expect_same(GlDevice& device, RasterBench bench, const std::vector<RasterVertex>& vertices,
                 float allowed = 0.0f) {
  const std::vector<Image> software = bench.draw(vertices);
  const PassResult counted = bench.result;
  bench.on = &device;
  const std::vector<Image> gl = bench.draw(vertices);
  const Difference d = compare(software, gl);
  CHECK(d.drawn > 0);
  if (!is_llvmpipe(device)) {
    if (d.differing > 0)
      WARN(d.differing << " of " << d.values << " values differ, by " << d.largest
                       << " at most, on " << device.description());
    return;
  }
  if (allowed == 0.0f)
    CHECK(d.differing == 0);
  else
    CHECK(d.largest <= allowed);
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
          continue;
        }
        if (compare == Compare::Equal)  // all at the depth that is stored
          for (RasterVertex& r : v) r.x /= r.w, r.y /= r.w, r.w = 1.0f, r.z = 0.5f;
        expect_same(*device, b, v);
      }
  RasterBench b = two_targets(64, 48);
  b.definition.writes.pop_back();
  b.definition.shader = &raster_discard_shader;
  std::vector<RasterVertex> v = random_vertices(bits, 300, 0.95f, 0.3f, 1.0f);
  for (std::size_t i = 0; i < v.size(); ++i) v[i].red = i / 3 % 3 == 0 ? 0.0f : v[i].red;
  expect_same(*device, b, v);
}

namespace {

constexpr BlendFactor kFactors[] = {BlendFactor::Zero,
                                    BlendFactor::One,
                                    BlendFactor::SourceColor,
                                    BlendFactor::SourceAlpha,
                                    BlendFactor::OneMinusSourceAlpha,
                                    BlendFactor::DestinationColor};

bool is_constant(BlendFactor f) { return f == BlendFactor::Zero || f == BlendFactor::One; }

// How far llvmpipe's blending may be from the equation as the contract writes it; 0 is equality.
// None of the deviating states is one that a pass uses.
float allowance(Format format, const BlendState& blend) {
  if (format == Format::RGBA16F) return 0.05f;  // halves are rounded towards zero after each blend
  if (blend.equation != BlendEquation::Add) return 0.0f;
  const BlendFactor s = blend.source, d = blend.destination;
  const bool constant = is_constant(s) && is_constant(d);
  if (format == Format::RGBA8)
    return constant ? 0.0f : 12.0f / 255.0f;  // products of 8-bit integers
  if (s == d && !constant) return 1e-5f;      // s * f + d * f is computed as (s + d) * f
  const auto pair = [&](BlendFactor a, BlendFactor b) {
    return (s == a && d == b) || (s == b && d == a);
  };
  // One channel: f and 1 - f become d + f * (s - d), even for f = 1.
  if (format == Format::R32F && (pair(BlendFactor::One, BlendFactor::Zero) ||
                                 pair(BlendFactor::SourceAlpha, BlendFactor::OneMinusSourceAlpha)))
    return 1e-5f;
  return 0.0f;
}

void expect_same_blend(GlDevice& device, std::mt19937& bits, Format format, const BlendState& blend,
                       const ColorMask& mask) {
  RasterBench b;
  b.width = b.height = 24;
  b.definition.writes[0] = {.name = "a",
                            .format = format,
                            .meaning = "m",
                            .clear = {0.25f, 0.5f, 0.75f, 1.0f},
                            .blend = blend,
                            .mask = mask};
  std::vector<RasterVertex> v = random_vertices(bits, 45, 0.95f, 0.0f, 1.0f);
  for (RasterVertex& r : v) r.blue *= 0.01f;
  INFO(format_name(format) << " equation " << int(blend.equation) << " source " << int(blend.source)
                           << " destination " << int(blend.destination));
  expect_same(device, b, v, allowance(format, blend));
}

}  // namespace

TEST_CASE("parity: every blend equation and factor, in every format, with masks") {
  const auto device = gl_or_skip();
  if (!device) return;
  std::mt19937 bits(4);
  const ColorMask masks[] = {kAllChannels, {true, false, true, false}, {true, true, false, true}};
  int round = 0;
  for (const Format format :
       {Format::RGBA32F, Format::RG32F, Format::R32F, Format::RGBA16F, Format::RGBA8}) {
    expect_same_blend(*device, bits, format, {true, BlendEquation::Min}, kAllChannels);
    expect_same_blend(*device, bits, format, {true, BlendEquation::Max}, kAllChannels);
    for (const BlendFactor source : kFactors)
      for (const BlendFactor destination : kFactors)
        if (source != BlendFactor::Zero || destination != BlendFactor::One)  // changes nothing
          expect_same_blend(*device, bits, format, {true, BlendEquation::Add, source, destination},
                            masks[round++ % 3]);
  }
}

TEST_CASE(
    "parity: llvmpipe stores halves rounded towards zero, the software device to the nearest") {
  const auto device = gl_or_skip();
  if (!device || !is_llvmpipe(*device)) return;
  std::mt19937 bits(9);
  RasterBench b;
  b.width = b.height = 64;
  b.on = device.get();
  b.definition.writes[0].format = Format::RGBA32F;
  const std::vector<RasterVertex> v = random_vertices(bits, 60, 0.95f, 0.0f, 1.0f);
  const Image full = b.draw(v)[0];
  b.definition.writes[0].format = Format::RGBA16F;
  const Image half = b.draw(v)[0];
  for (std::size_t i = 0; i < full.values.size(); ++i) {
    float expected = stored_value(Format::RGBA16F, full.values[i]);
    if (std::fabs(expected) > std::fabs(full.values[i]))
      expected = float_from_half(static_cast<std::uint16_t>(half_from_float(expected) - 1));
    REQUIRE(half.values[i] == expected);
  }
}

TEST_CASE("parity: points of every size, additively") {
  const auto device = gl_or_skip();
  if (!device) return;
  std::mt19937 bits(5);
  for (const Format format : {Format::RGBA32F, Format::R32F})
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
        // w is 1: llvmpipe divides a smooth value by w and multiplies it again, which costs a last
        // place for others. Passes draw points with flat varyings.
        expect_same(*device, b, random_vertices(bits, 3000, spread, 0.0f, largest));
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

TEST_CASE("parity: what is not finite is drawn or dropped alike") {
  // Left out: w = +infinity, which the software device drops and llvmpipe draws at the view's
  // centre.
  const auto device = gl_or_skip();
  if (!device) return;
  const float nan = std::nanf(""), infinity = std::numeric_limits<float>::infinity();
  struct Bad {
    float RasterVertex::*member;
    float value;
  };
  for (const Topology topology : {Topology::Triangles, Topology::Points})
    for (const Bad& bad : {Bad{&RasterVertex::x, nan},
                           {&RasterVertex::x, infinity},
                           {&RasterVertex::y, -infinity},
                           {&RasterVertex::z, nan},
                           {&RasterVertex::w, nan},
                           {&RasterVertex::w, -infinity},
                           {&RasterVertex::w, 0.0f},
                           {&RasterVertex::w, -1.0f},
                           {&RasterVertex::red, nan},
                           {&RasterVertex::red, infinity},
                           {&RasterVertex::size, nan},
                           {&RasterVertex::size, infinity}}) {
      std::mt19937 bits(7);
      RasterBench b = two_targets(64, 64);
      b.definition.topology = topology;
      if (topology == Topology::Points) b.definition.writes[0].mask = {false, false, false, false};
      std::vector<RasterVertex> v = random_vertices(bits, 300, 0.95f, 0.2f, 5.0f);
      for (std::size_t i = 0; i < v.size(); i += 7) v[i].*bad.member = bad.value;
      INFO("topology " << int(topology) << ", value " << bad.value);
      expect_same(*device, b, v);
    }
}
