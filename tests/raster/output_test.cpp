// What becomes of a fragment: interpolation, depth, blending, formats, masks, several targets, queries.
#include <cmath>

#include "tests/support/device_contracts.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// Full-screen triangles of these values at these depths, in order.
std::vector<RasterVertex> layers(const RasterBench& b, const std::vector<float>& values,
                                 const std::vector<float>& depths = {}) {
  std::vector<RasterVertex> v;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const float z = depths.empty() ? 0.5f : depths[i];
    v.push_back(b.at(0, 0, values[i], z));
    v.push_back(b.at(2 * b.width, 0, values[i], z));
    v.push_back(b.at(0, 2 * b.height, values[i], z));
  }
  return v;
}

RasterBench with_depth(Compare compare, float clear, bool write = true) {
  RasterBench b;
  b.width = b.height = 2;
  b.definition.depth = DepthWrite{.name = "depth", .meaning = "m", .clear = clear};
  b.definition.depth_state = {compare, write};
  b.definition.count_samples = true;
  return b;
}

RasterBench with_format(Format format, const BlendState& blend, std::array<float, 4> clear = {}) {
  RasterBench b;
  b.width = b.height = 1;
  b.definition.writes[0].format = format;
  b.definition.writes[0].blend = blend;
  b.definition.writes[0].clear = clear;
  return b;
}

// Hundredths from 0.1 on, the texel beside or above holding another.
Image uneven(Format format, int width, int height) {
  Image image(format, width, height);
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = stored_value(format, static_cast<float>(i * 37 % 89 + 10) / 100.0f);
  return image;
}

}  // namespace

TEST_CASE("interpolation: perspective-correct, within a few ulp of double precision") {
  // A triangle with w of 1, 2 and 4: at each pixel the barycentric weights of clip space, by double
  // precision from the window coordinates.
  RasterBench b;
  b.width = b.height = 16;
  const double window[3][2] = {{0.3, 0.7}, {15.6, 1.2}, {6.4, 15.1}}, w[3] = {1, 2, 4};
  const float value[3] = {1.0f, 5.0f, 2.0f};
  std::vector<RasterVertex> v;
  for (int i = 0; i < 3; ++i) {
    RasterVertex r = b.at(window[i][0], window[i][1], value[i]);
    r.x *= static_cast<float>(w[i]);
    r.y *= static_cast<float>(w[i]);
    r.z *= static_cast<float>(w[i]);
    r.w = static_cast<float>(w[i]);
    v.push_back(r);
  }
  const Image image = b.draw(v)[0];
  int compared = 0;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      if (image.at(x, y, 0) == 0.0f) continue;
      double area[3], sum = 0.0, weighted = 0.0;
      for (int i = 0; i < 3; ++i) {
        const double* p = window[(i + 1) % 3];
        const double* q = window[(i + 2) % 3];
        area[i] = ((q[0] - p[0]) * (y + 0.5 - p[1]) - (q[1] - p[1]) * (x + 0.5 - p[0])) / w[i];
        sum += area[i];
      }
      for (int i = 0; i < 3; ++i) weighted += area[i] / sum * double(value[i]);
      CHECK(image.at(x, y, 0) == Approx(weighted).epsilon(2e-6));
      ++compared;
    }
  CHECK(compared > 80);
}

TEST_CASE("interpolation: a flat varying has the last vertex's value") {
  RasterBench b;
  b.width = b.height = 4;
  b.definition.shader = &raster_two_targets_shader;
  b.definition.writes = {{.name = "a", .meaning = "m"}, {.name = "b", .meaning = "m"}};
  const std::vector<Image> images = b.draw({b.at(0, 0, 1.0f), b.at(8, 0, 2.0f), b.at(0, 8, 3.0f)});
  CHECK(images[1].at(1, 1, 0) == 3.0f);
  CHECK(images[1].at(1, 1, 2) == 1.0f);
  CHECK(images[0].at(1, 1, 0) == Approx(1.0 + 1.5 / 8.0 + 2.0 * 1.5 / 8.0));
}

TEST_CASE("depth: every comparison passes as its name says") {
  // Stored 0.5 (cleared); incoming 0.25, 0.5 and 0.75 in turn, without writing.
  struct Expected {
    Compare compare;
    unsigned passed[3];
  };
  for (const Expected& e : {Expected{Compare::Always, {4, 4, 4}}, Expected{Compare::Less, {4, 0, 0}},
                            Expected{Compare::LessEqual, {4, 4, 0}}, Expected{Compare::Greater, {0, 0, 4}},
                            Expected{Compare::GreaterEqual, {0, 4, 4}}, Expected{Compare::Equal, {0, 4, 0}},
                            Expected{Compare::Never, {0, 0, 0}}})
    for (int i = 0; i < 3; ++i) {
      RasterBench b = with_depth(e.compare, 0.5f, false);
      b.draw(layers(b, {1.0f}, {0.25f + 0.25f * static_cast<float>(i)}));
      CHECK(b.result.samples_passed == e.passed[i]);
    }
}

TEST_CASE("depth: the nearest wins in any order, the first of equals wins") {
  RasterBench b = with_depth(Compare::Less, 1.0f);
  CHECK(b.draw(layers(b, {1, 2, 3}, {0.5f, 0.25f, 0.75f}))[0].at(0, 0, 0) == 2.0f);
  CHECK(b.draw(layers(b, {1, 2}, {0.5f, 0.5f}))[0].at(0, 0, 0) == 1.0f);
  const std::vector<Image> images = b.draw(layers(b, {1, 2}, {0.5f, 0.25f}));
  CHECK(images[1].at(1, 1, 0) == 0.25f);
  CHECK(b.result.samples_passed == 8);
}

TEST_CASE("depth: a discarded fragment neither passes nor writes") {
  RasterBench b = with_depth(Compare::Less, 1.0f);
  b.definition.shader = &raster_discard_shader;
  const std::vector<Image> images = b.draw(layers(b, {0.0f, 3.0f}, {0.25f, 0.5f}));
  CHECK(images[0].at(0, 0, 0) == 3.0f);
  CHECK(images[1].at(0, 0, 0) == 0.5f);
  CHECK(b.result.samples_passed == 4);
}

TEST_CASE("blending: sums run in drawing order") {
  // 2^24 + 1 + 1 in single precision stays 2^24; 1 + 1 + 2^24 is 2^24 + 2.
  RasterBench b = with_format(Format::R32F, kAccumulate);
  CHECK(b.draw(layers(b, {16777216.0f, 1.0f, 1.0f}))[0].at(0, 0, 0) == 16777216.0f);
  CHECK(b.draw(layers(b, {1.0f, 1.0f, 16777216.0f}))[0].at(0, 0, 0) == 16777218.0f);
}

TEST_CASE("blending: min, max, multiply and alpha") {
  const auto blended = [](BlendState blend, float clear, float value) {
    RasterBench b = with_format(Format::RGBA32F, blend, {clear, clear, clear, clear});
    return b.draw(layers(b, {value}))[0].at(0, 0, 0);
  };
  CHECK(blended({true, BlendEquation::Min}, 2.0f, 3.0f) == 2.0f);
  CHECK(blended({true, BlendEquation::Max}, 2.0f, 3.0f) == 3.0f);
  CHECK(blended(kMultiply, 2.0f, 3.0f) == 6.0f);
  // source 0.25 with alpha 0.25 over 1: 0.25 * 0.25 + 1 * 0.75.
  CHECK(blended({true, BlendEquation::Add, BlendFactor::SourceAlpha, BlendFactor::OneMinusSourceAlpha}, 1.0f,
                0.25f) == 0.8125f);
  CHECK(blended(kReplace, 2.0f, 3.0f) == 3.0f);
}

TEST_CASE("blending: NaN poisons a sum and loses against a number in min and max") {
  const auto blended = [](BlendState blend) {
    RasterBench b = with_format(Format::R32F, blend, {0.0f, 0.0f, 0.0f, 0.0f});
    return b.draw(layers(b, {std::nanf("")}))[0].at(0, 0, 0);
  };
  CHECK(std::isnan(blended(kAccumulate)));
  CHECK(blended({true, BlendEquation::Add, BlendFactor::Zero, BlendFactor::One}) == 0.0f);
  CHECK(blended({true, BlendEquation::Min}) == 0.0f);
  CHECK(blended({true, BlendEquation::Max}) == 0.0f);
  // Nor does one that was there before stay.
  for (const BlendEquation equation : {BlendEquation::Min, BlendEquation::Max}) {
    RasterBench b = with_format(Format::R32F, {true, equation}, {std::nanf("")});
    CHECK(b.draw(layers(b, {2.0f}))[0].at(0, 0, 0) == 2.0f);
  }
}

TEST_CASE("formats: a half target rounds after every blend") {
  // Halves above 2048 are 2 apart: 2048 + 1 is a tie and stays 2048, again and again.
  RasterBench b = with_format(Format::RGBA16F, kAccumulate);
  CHECK(b.draw(layers(b, {2048.0f, 1.0f, 1.0f, 1.0f}))[0].at(0, 0, 0) == 2048.0f);
  CHECK(b.draw(layers(b, {1.0f, 1.0f, 2048.0f}))[0].at(0, 0, 0) == 2050.0f);
  CHECK(b.draw(layers(b, {60000.0f, 60000.0f}))[0].at(0, 0, 0) == 65504.0f);
}

TEST_CASE("formats: an 8-bit target clamps and rounds") {
  RasterBench b = with_format(Format::RGBA8, kReplace);
  CHECK(b.draw(layers(b, {0.5f}))[0].at(0, 0, 0) == 128.0f / 255.0f);
  CHECK(b.draw(layers(b, {7.0f}))[0].at(0, 0, 0) == 1.0f);
  CHECK(b.draw(layers(b, {-1.0f}))[0].at(0, 0, 0) == 0.0f);
  // Before it blends, too: an alpha of 2 counts as 1, so what was there stays as it was.
  RasterBench kept =
      with_format(Format::RGBA8, {true, BlendEquation::Add, BlendFactor::Zero, BlendFactor::SourceAlpha},
                  {0.5f, 0, 0, 0});
  CHECK(kept.draw(layers(kept, {2.0f}))[0].at(0, 0, 0) == 128.0f / 255.0f);
}

TEST_CASE("formats: bytes are rounded as stored_value has it, ties and their neighbours too") {
  const RasterBench b = with_format(Format::RGBA8, kReplace);
  for (int byte = 0; byte < 255; ++byte) {
    const float tie = (static_cast<float>(byte) + 0.5f) / 255.0f;
    for (const float value : {std::nextafter(tie, 0.0f), tie, std::nextafter(tie, 1.0f)})
      CHECK(RasterBench(b).draw(layers(b, {value}))[0].at(0, 0, 0) == stored_value(Format::RGBA8, value));
  }
}

TEST_CASE("targets: a colour mask keeps channels, and each target takes its own output") {
  RasterBench b;
  b.width = b.height = 1;
  b.definition.shader = &raster_two_targets_shader;
  b.definition.writes = {
      {.name = "a", .meaning = "m", .clear = {9, 9, 9, 9}, .mask = {true, false, false, true}},
      {.name = "b", .format = Format::RG32F, .meaning = "m"}};
  RasterVertex v = b.at(0, 0);
  v.red = 1, v.green = 2, v.blue = 3, v.alpha = 4;
  RasterVertex p = v, q = v;
  p.x = 3.0f, q.y = 3.0f;
  const std::vector<Image> images = b.draw({v, p, q});
  CHECK(images[0].values == std::vector<float>{1, 9, 9, 4});
  CHECK(images[1].values == std::vector<float>{1, 2});
}

TEST_CASE("targets: what is kept is drawn onto, what is not is cleared") {
  Image before(Format::R32F, 2, 2);
  before.values = {1, 2, 3, 4};
  RasterBench b = counting(2, 2);
  b.keep = {true};
  CHECK(b.draw(layers(b, {10.0f}), &before)[0].values == std::vector<float>{11, 12, 13, 14});
  b.keep = {false};
  b.definition.writes[0].clear = {5, 0, 0, 0};
  CHECK(b.draw(layers(b, {10.0f}), &before)[0].values == std::vector<float>{15, 15, 15, 15});
  // Without a fragment anywhere.
  CHECK(b.draw({b.at(0, 0), b.at(0, 0), b.at(0, 0)}, &before)[0].values == std::vector<float>{5, 5, 5, 5});
  // By what the format can hold.
  RasterBench half = with_format(Format::RGBA16F, kReplace, {0.1f, 0, 0, 0});
  CHECK(half.draw({half.at(0, 0), half.at(0, 0), half.at(0, 0)})[0].values[0] ==
        stored_value(Format::RGBA16F, 0.1f));
}

TEST_CASE("targets: what is drawn into one tile leaves all others as they were, however it is stored") {
  // Tiles of 32 pixels a side, the last ones partly: 3 x 2 of them.
  constexpr int kWidth = 70, kHeight = 40;
  for (const Format format : {Format::R32F, Format::RG32F, Format::RGBA32F, Format::RGBA16F, Format::RGBA8})
    for (const BlendState& blend : {kReplace, kAccumulate, kMultiply})
      for (int tile = 0; tile < 6; ++tile) {
        INFO(format_name(format) << ", tile " << tile);
        RasterBench b = with_format(format, blend);
        b.width = kWidth;
        b.height = kHeight;
        b.keep = {true};
        b.definition.topology = Topology::Points;
        const Image before = uneven(format, kWidth, kHeight);
        const int x = tile % 3 * 32 + 3, y = tile / 3 * 32 + 5;
        const Image after = b.draw({b.at(x + 0.5, y + 0.5, 0.505f)}, &before)[0];
        std::vector<int> changed;
        for (int i = 0; i < kWidth * kHeight; ++i)
          if (after.at(i % kWidth, i / kWidth, 0) != before.at(i % kWidth, i / kWidth, 0))
            changed.push_back(i);
        CHECK(changed == std::vector{y * kWidth + x});
      }
}

TEST_CASE(
    "targets: a large one into which nothing is drawn is cleared, and stays so around what comes later") {
  constexpr int kSide = 1024;  // 4 MB, in pages of its own
  for (const float clear : {0.0f, 0.5f}) {
    RasterBench b = counting(kSide, kSide);
    b.definition.topology = Topology::Points;
    b.definition.writes[0].clear = {clear, 0, 0, 0};
    const auto device = make_software_device({.threads = 2});
    PassRun run{.definition = &b.definition, .colors = {device->create_texture(Format::R32F, kSide, kSide)}};
    device->run(run);
    const double cleared = static_cast<double>(clear) * kSide * kSide;
    CHECK(RasterBench::sum(device->read_back(run.colors[0])) == cleared);
    MeshData point;
    point.layout = {{"position", 4}, {"color", 4}, {"size", 1}};
    point.vertices = {0.0f, 0.0f, 0.5f, 1.0f, 2.0f, 2.0f, 2.0f, 2.0f, 1.0f};
    run.draws = {Draw{.mesh = device->create_mesh(point)}};
    run.keep = {true};
    device->run(run);
    CHECK(RasterBench::sum(device->read_back(run.colors[0])) == cleared + 2.0);
  }
}

TEST_CASE("batches: what comes later is drawn onto what came before, batch after batch") {
  for (const std::size_t batch : {1u, 2u, 3u}) {
    INFO(batch << " primitives a batch");
    // As in "blending: sums run in drawing order"; as triangles and as points.
    RasterBench sum = with_format(Format::R32F, kAccumulate);
    sum.options.batch = batch;
    CHECK(sum.draw(layers(sum, {16777216.0f, 1.0f, 1.0f}))[0].values == std::vector{16777216.0f});
    CHECK(sum.draw(layers(sum, {1.0f, 1.0f, 16777216.0f}))[0].values == std::vector{16777218.0f});
    CHECK(sum.result.vertices == 9);
    CHECK(sum.result.primitives == 3);
    CHECK(sum.result.fragments == 3);
    sum.definition.topology = Topology::Points;
    const auto points = [&](std::vector<float> values) {
      std::vector<RasterVertex> v;
      for (const float value : values) v.push_back(sum.at(0.5, 0.5, value));
      return v;
    };
    CHECK(sum.draw(points({16777216.0f, 1.0f, 1.0f}))[0].values == std::vector{16777216.0f});
    CHECK(sum.draw(points({1.0f, 1.0f, 16777216.0f}))[0].values == std::vector{16777218.0f});
    sum.definition.writes[0].blend = kReplace;
    CHECK(sum.draw(points({7.0f, 8.0f, 9.0f}))[0].values == std::vector{9.0f});
  }
}

TEST_CASE("batches: depth is tested against that of earlier batches, early and late") {
  for (const std::size_t batch : {1u, 2u, 4u})
    for (const Shader* shader : {&raster_probe_shader, &raster_discard_shader}) {
      INFO(batch << " primitives a batch, " << shader->name);
      RasterBench b = with_depth(Compare::Less, 1.0f);
      b.options.batch = batch;
      b.definition.shader = shader;
      // The second lies behind the first, the third before it, the fourth behind the third: 4 pixels twice.
      const std::vector<Image> images = b.draw(layers(b, {1, 2, 3, 4}, {0.5f, 0.75f, 0.25f, 0.375f}));
      CHECK(images[0].values == std::vector{3.0f, 3.0f, 3.0f, 3.0f});
      CHECK(images[1].values == std::vector{0.25f, 0.25f, 0.25f, 0.25f});
      CHECK(b.result.samples_passed == 8);
    }
}

TEST_CASE("batches: tiles that no batch, the first or a later one draws into are cleared once") {
  // Four tiles of 32 pixels a side. The first point lies in the lower left, the second in the lower right,
  // the third on the first again; each is one pixel.
  RasterBench b = counting(64, 64);
  b.options.batch = 1;
  b.definition.topology = Topology::Points;
  b.definition.writes[0].clear = {5, 0, 0, 0};
  Image before(Format::R32F, 64, 64);
  for (float& value : before.values) value = 9.0f;
  const Image image = b.draw({b.at(3.5, 3.5, 1.0f), b.at(40.5, 3.5, 2.0f), b.at(3.5, 3.5, 4.0f)}, &before)[0];
  CHECK(image.at(3, 3, 0) == 10.0f);
  CHECK(image.at(40, 3, 0) == 7.0f);
  CHECK(RasterBench::sum(image) == 5.0 * 4096.0 + 7.0);
  // Nor without any primitive.
  CHECK(RasterBench::sum(b.draw({}, &before)[0]) == 5.0 * 4096.0);
}

TEST_CASE("batches: an index of any batch may be of any vertex") {
  // The pixels of a row, one point each, from the last to the first; the first three twice.
  RasterBench b = counting(8, 1);
  b.options.batch = 2;
  b.definition.topology = Topology::Points;
  b.indices = {7, 6, 5, 4, 3, 2, 1, 0, 0, 1, 2};
  std::vector<RasterVertex> row;
  for (int x = 0; x < 8; ++x) row.push_back(b.at(x + 0.5, 0.5, static_cast<float>(x + 1)));
  CHECK(b.draw(row)[0].values == std::vector<float>{2, 4, 6, 4, 5, 6, 7, 8});
  CHECK(b.result.vertices == 11);
}

TEST_CASE("batches: draws of a pass come in turn, whether they share a batch or take several") {
  // Each point leaves half of what was before it: the sum's binary digits are their order, the last first.
  RasterBench b = with_format(
      Format::R32F, {true, BlendEquation::Add, BlendFactor::SourceAlpha, BlendFactor::OneMinusSourceAlpha});
  b.definition.topology = Topology::Points;
  const auto points = [&](std::initializer_list<float> values) {
    std::vector<RasterVertex> v;
    for (const float value : values) {
      v.push_back(b.at(0.5, 0.5, value));
      v.back().alpha = 0.5f;
    }
    return v;
  };
  const float expected = (1.0f + (0.0f + (1.0f + (1.0f + (0.0f + 1.0f / 2) / 2) / 2) / 2) / 2) / 2;
  for (const std::size_t batch : {1u, 2u, 3u, 4u, 5u, 100u}) {
    INFO(batch << " primitives a batch");
    b.options.batch = batch;
    const auto images = b.draw_each({points({1}), points({0, 1, 1}), {}, points({0, 1})});
    CHECK(images[0].values == std::vector{expected});
    CHECK(b.result.primitives == 6);
    CHECK(b.result.fragments == 6);
  }
}

TEST_CASE("depth: what lies behind is not shaded, by a shader that may discard either") {
  for (const Compare compare : {Compare::Less, Compare::Greater}) {
    RasterBench b = with_depth(compare, compare == Compare::Less ? 1.0f : 0.0f);
    b.width = b.height = 16;
    b.definition.shader = &raster_discard_shader;
    const float first = compare == Compare::Less ? 0.25f : 0.75f;
    // A value of 0 is discarded: nothing hides what comes next.
    const auto images = b.draw(layers(b, {0, 1, 2}, {first, 0.5f, 1.0f - first}));
    CHECK(RasterBench::sum(images[0]) == 256.0);
    CHECK(b.result.fragments == 2 * 256);
    CHECK(b.result.samples_passed == 256);
  }
}

TEST_CASE("depth: rows of sixteen come behind the single fragments that were drawn before them") {
  for (const Shader* shader : {&raster_probe_shader, &raster_discard_shader}) {
    RasterBench b = with_depth(Compare::Always, 1.0f);
    b.width = b.height = 64;
    b.definition.shader = shader;
    // The second covers all of the first one's tile.
    const Image image = b.draw({b.at(3, 3, 1.0f), b.at(6, 3, 1.0f), b.at(3, 6, 1.0f), b.at(0, 0, 2.0f),
                                b.at(64, 0, 2.0f), b.at(0, 64, 2.0f)})[0];
    for (int y = 3; y < 6; ++y)
      for (int x = 3; x < 6; ++x) CHECK(image.at(x, y, 0) == 2.0f);
  }
}

TEST_CASE("queries: samples passed count covered texels, layer by layer") {
  RasterBench b = with_depth(Compare::Always, 1.0f, false);
  b.width = b.height = 64;
  b.draw({b.at(0, 0), b.at(64, 0), b.at(64, 64), b.at(0, 0), b.at(64, 64), b.at(0, 64)});
  CHECK(b.result.samples_passed == 4096);
  CHECK(b.result.primitives == 2);
  CHECK(b.result.vertices == 6);
}

TEST_CASE("occlusion query: where no sample passed, what depends on it is cleared and not drawn") {
  check_occlusion_queries(*make_software_device({.threads = 1}), true);
}

TEST_CASE("targets: what is written to an absent one goes nowhere, the others hold the same") {
  check_absent_targets(*make_software_device({.threads = 1}));
}
