#include "passes/beams/beams.hpp"

#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

PassImages join(int grid, int vertices, int beams, const Image& start, const Image& way, const Image& flux,
                int draws = 0) {
  return run_pass(definition_of(beams_pass()),
                  {.width = beams,
                   .height = beams,
                   .uniforms = uniform_bytes(
                       std140::Beams{.grid_side = grid, .vertices_per_beam = vertices, .draws = draws}),
                   .textures = {start, way, flux}});
}

}  // namespace

TEST_CASE("beams: one grid vertex a beam is the vertex itself") {
  const PassImages out =
      join(1, 1, 1, filled(1, 1, {1, 2, 3, 4}), filled(1, 1, {0, -1, 0, 1}), filled(1, 1, {2, 4, 6, 0}));
  CHECK(texel(out["beam_start"], 0, 0) == glm::vec4(1, 2, 3, 4));
  CHECK(texel(out["beam_way"], 0, 0) == glm::vec4(0, -1, 0, 1));
  CHECK(texel(out["beam_flux"], 0, 0) == glm::vec4(2, 4, 6, 0));
}

TEST_CASE("beams: flux adds up, and places are its mean") {
  // Of four vertices two send light, 1 and 3 in all channels together: the mean lies at three quarters.
  Image start = filled(2, 2, glm::vec4(9.0f)), way = filled(2, 2, glm::vec4(0.0f)), flux = way;
  for (int c = 0; c < 4; ++c) {
    start.at(0, 0, c) = 0.0f;
    start.at(1, 0, c) = 4.0f;
    way.at(0, 0, c) = way.at(1, 0, c) = c == 1 ? -1.0f : c == 3 ? 1.0f : 0.0f;
  }
  flux.at(0, 0, 0) = 1.0f;
  flux.at(1, 0, 1) = 3.0f;
  const PassImages out = join(2, 2, 1, start, way, flux);
  CHECK(texel(out["beam_start"], 0, 0) == glm::vec4(3.0f));
  CHECK(texel(out["beam_way"], 0, 0) == glm::vec4(0, -1, 0, 1));
  CHECK(texel(out["beam_flux"], 0, 0) == glm::vec4(1, 3, 0, 0));
  // Directions count by their flux, too: (0, -1, 0) once and (1, 0, 0) three times.
  way.at(1, 0, 0) = 1.0f;
  way.at(1, 0, 1) = 0.0f;
  const glm::vec4 mean = texel(join(2, 2, 1, start, way, flux)["beam_way"], 0, 0);
  CHECK(mean.x == Approx(3.0 / std::sqrt(10.0)));
  CHECK(mean.y == Approx(-1.0 / std::sqrt(10.0)));
}

TEST_CASE("beams: of vertices that go ways of their own one is drawn, with the flux of all") {
  // 32 x 32 beams of two by two vertices. Each row of vertices goes its own way, the second with three times
  // the light.
  Image start = filled(64, 64, glm::vec4(0.0f)), way = start, flux = start;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const bool second = y % 2 == 1;
      start.at(x, y, 0) = second ? 5.0f : -5.0f;
      way.at(x, y, second ? 0 : 1) = 1.0f;
      way.at(x, y, 3) = 1.0f;
      flux.at(x, y, 0) = second ? 3.0f : 1.0f;
    }
  const PassImages out = join(64, 2, 32, start, way, flux, 1);
  int seconds = 0;
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      const float at = out["beam_start"].at(x, y, 0);
      CHECK(std::fabs(at) == 5.0f);
      CHECK(texel(out["beam_way"], x, y) == (at > 0.0f ? glm::vec4(1, 0, 0, 1) : glm::vec4(0, 1, 0, 1)));
      CHECK(out["beam_flux"].at(x, y, 0) == 8.0f);
      seconds += at > 0.0f ? 1 : 0;
    }
  CHECK(seconds / 1024.0 == Approx(0.75).margin(0.03));
}

TEST_CASE("beams: where no light leaves there is no beam, and the grid's edge is not repeated") {
  const Image none = filled(1, 1, glm::vec4(0.0f));
  CHECK(texel(join(1, 1, 1, none, none, none)["beam_way"], 0, 0) == glm::vec4(0.0f));
  // A grid of 3 in beams of 2 x 2: the last beam has one vertex.
  const PassImages out =
      join(3, 2, 2, filled(3, 3, {1, 1, 1, 1}), filled(3, 3, {0, 0, 1, 1}), filled(3, 3, {1, 0, 0, 0}));
  CHECK(out["beam_flux"].at(0, 0, 0) == 4.0f);
  CHECK(out["beam_flux"].at(1, 0, 0) == 2.0f);
  CHECK(out["beam_flux"].at(1, 1, 0) == 1.0f);
}
