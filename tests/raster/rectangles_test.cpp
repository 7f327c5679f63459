// Rectangles: a run of the vertex stage each, on both devices.
#include <limits>

#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/validate.hpp"
#include "tests/gl/gl_or_skip.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace caustics {
extern const Shader raster_rectangles_shader;
}

namespace {

// Lower and upper corner, in pixels of a target of this size.
struct Drawn {
  int width = 8, height = 8;
  std::vector<glm::vec4> rectangles{};

  PassImages on(Device& device) const {
    const PassDefinition definition{.name = "test",
                                    .purpose = "test",
                                    .reads = {{.name = "rectangles", .meaning = "m"}},
                                    .writes = {{.name = "numbers", .meaning = "m", .blend = kAccumulate}},
                                    .topology = Topology::Rectangles,
                                    .shader = &raster_rectangles_shader};
    Image corners(Format::RGBA32F, static_cast<int>(rectangles.size()), 1);
    for (std::size_t i = 0; i < rectangles.size(); ++i)
      for (int c = 0; c < 4; ++c)
        corners.at(static_cast<int>(i), 0, c) =
            rectangles[i][c] * 2.0f / static_cast<float>(c % 2 == 0 ? width : height) - 1.0f;
    return run_pass(device, definition,
                    {.width = width,
                     .height = height,
                     .textures = {corners},
                     .vertex_count = static_cast<int>(rectangles.size())});
  }
  Image drawn() const { return on(*make_software_device({.threads = 1}))["numbers"]; }
  double covered() const { return sum(drawn(), 1); }
};

}  // namespace

TEST_CASE("rectangles: pixels whose centres lie inside are covered once") {
  // Columns 2 to 4, rows 3 and 4.
  const Image image = Drawn{.rectangles = {{2.0f, 3.0f, 5.0f, 5.0f}}}.drawn();
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x)
      CHECK(image.at(x, y, 0) == (x >= 2 && x < 5 && y >= 3 && y < 5 ? 1.0f : 0.0f));
}

TEST_CASE("rectangles: centres on the left and the lower edge belong to them, on the others not") {
  const Image image = Drawn{.rectangles = {{2.5f, 3.5f, 4.5f, 5.5f}}}.drawn();
  CHECK(sum(image) == 4.0);
  CHECK(image.at(2, 3, 0) == 1.0f);
  CHECK(image.at(3, 4, 0) == 1.0f);
}

TEST_CASE("rectangles: those of later batches go on counting") {
  // One above the other: 1 + 2 + 3 + 4 + 5.
  const Drawn five{
      .width = 1, .height = 1, .rectangles = std::vector<glm::vec4>(5, {0.0f, 0.0f, 1.0f, 1.0f})};
  for (const std::size_t batch : {1u, 2u, 3u, 5u}) {
    const Image numbers = five.on(*make_software_device({.threads = 1, .batch = batch}))["numbers"];
    CHECK(numbers.at(0, 0, 0) == 15.0f);
    CHECK(numbers.at(0, 0, 1) == 5.0f);
  }
}

TEST_CASE("rectangles: they are cut at the target's edge, however large") {
  CHECK(Drawn{.rectangles = {{-3.0f, 6.0f, 2.0f, 40.0f}}}.covered() == 4.0);
  CHECK(Drawn{.rectangles = {{-1e30f, -1e30f, 1e30f, 1e30f}}}.covered() == 64.0);
  CHECK(Drawn{.width = 200, .height = 70, .rectangles = {{31.0f, 31.0f, 165.0f, 65.0f}}}.covered() ==
        134 * 34);
}

TEST_CASE("rectangles: none is drawn without extent, turned over, or of what is no number") {
  constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();
  for (const glm::vec4& corners : {glm::vec4(3.0f, 3.0f, 3.0f, 5.0f), glm::vec4(5.0f, 3.0f, 3.0f, 5.0f),
                                   glm::vec4(9.0f, 0.0f, 12.0f, 8.0f), glm::vec4(kNothing, 1.0f, 2.0f, 3.0f)})
    CHECK(Drawn{.rectangles = {corners}}.covered() == 0.0);
}

TEST_CASE("rectangles: both devices draw the same ones") {
  const auto gl = gl_or_skip();
  Drawn many{.width = 131, .height = 77};
  std::uint32_t state = 1;
  const auto next = [&](float lower, float upper) {
    state = state * 1664525u + 1013904223u;
    return lower + (upper - lower) * static_cast<float>(state >> 8) / 16777216.0f;
  };
  // With corners on pixels' corners, as passes have them, and beyond the target.
  for (int i = 0; i < 2000; ++i) {
    const float x = std::floor(next(-20.0f, 131.0f)), y = std::floor(next(-20.0f, 77.0f));
    many.rectangles.emplace_back(x, y, x + std::floor(next(0.0f, 30.0f)), y + std::floor(next(0.0f, 30.0f)));
  }
  CHECK(many.on(*gl)["numbers"].values == many.drawn().values);
}

TEST_CASE("rectangles: fragments that are no zeros somewhere may not be left out") {
  PassDefinition definition{.name = "test",
                            .purpose = "test",
                            .reads = {{.name = "rectangles", .meaning = "m"}},
                            .writes = {{.name = "numbers", .meaning = "m", .blend = kAccumulate}},
                            .topology = Topology::Rectangles,
                            .zero_outside_quad = 0,
                            .shader = &raster_rectangles_shader};
  CHECK_THROWS_AS(caustics::validate(definition), Error);  // one varying component
  definition.writes[0].blend = {};
  CHECK_THROWS_AS(caustics::validate(definition), Error);
}
