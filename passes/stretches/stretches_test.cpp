#include "passes/stretches/stretches.hpp"

#include <algorithm>
#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

constexpr double kExtinction = 0.5;

// Two balls that bend and mirror nothing, one under the other, in haze over a floor at height 0. On their
// axis light passes the air from 0.75 m to 0.65 m, and from 0.15 m to the floor. The grid has 64 x 64
// vertices.
Rendering through_two_balls(int beams_a_side) {
  Scene scene = sphere_scene(1.0f);
  scene.medium.scattering = glm::vec3(static_cast<float>(kExtinction));
  scene.meshes = {floor(3.0, 0.0, 0), sphere({0.0, 1.0, 0.0}, 0.25, 5, 1),
                  sphere({0.0, 0.4, 0.0}, 0.25, 5, 1)};
  Settings settings = small_settings(64, 64, 8);
  settings.further_share = 0.0f;
  settings.shafts = beams_a_side;
  const Rendering r = render(scene, settings, {"stretch_start", "stretch_way", "stretch_flux"});
  REQUIRE(r.effects.further_surfaces.active);
  return r;
}

// Does the vertex' light go nearly along the balls' axis? Elsewhere their facets count.
bool is_near_axis(const Rendering& r, int x, int y) {
  const Image& entry = r["caster_position[0]"];
  return entry.at(x, y, 3) != 0.0f && std::hypot(entry.at(x, y, 0), entry.at(x, y, 2)) < 0.05f;
}

}  // namespace

TEST_CASE("stretches: of two on a vertex' way one is drawn, and stands for both") {
  const Rendering r = through_two_balls(64);
  const Image &start = r["stretch_start[0]"], &way = r["stretch_way[0]"], &flux = r["stretch_flux[0]"];
  const double cell = static_cast<double>(r["landing_fresnel[0]"].at(32, 32, 3));
  const double upper = cell * 0.1, lower = cell * std::exp(-kExtinction * 0.1) * 0.15;
  int uppers = 0, all = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      if (!is_near_axis(r, x, y)) continue;
      CHECK(way.at(x, y, 1) == Approx(-1.0));
      CHECK(way.at(x, y, 3) == 1.0f);
      const bool is_upper = start.at(x, y, 1) > 0.5f;
      CHECK(start.at(x, y, 1) == Approx(is_upper ? 0.75 : 0.15).margin(0.006));
      CHECK(start.at(x, y, 3) == Approx(is_upper ? 0.1 : 0.15).margin(0.012));
      CHECK(static_cast<double>(flux.at(x, y, 0)) * static_cast<double>(start.at(x, y, 3)) ==
            Approx(upper + lower).epsilon(0.08));
      uppers += is_upper ? 1 : 0;
      ++all;
    }
  REQUIRE(all > 100);
  CHECK(static_cast<double>(uppers) / all == Approx(upper / (upper + lower)).margin(0.06));
}

TEST_CASE("stretches: a beam's vertices draw alike") {
  const Rendering r = through_two_balls(16);  // 4 x 4 vertices a beam
  int alike = 0, pairs = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 63; ++x) {
      if (x % 4 == 3 || !is_near_axis(r, x, y) || !is_near_axis(r, x + 1, y)) continue;
      const Image& start = r["stretch_start[0]"];
      alike += (start.at(x, y, 1) > 0.5f) == (start.at(x + 1, y, 1) > 0.5f) ? 1 : 0;
      ++pairs;
    }
  REQUIRE(pairs > 50);
  CHECK(alike > 0.9 * pairs);
}

TEST_CASE("stretches: where no light comes there is none, and none within glass") {
  const Rendering r = through_two_balls(64);
  const Image &start = r["stretch_start[0]"], &way = r["stretch_way[0]"], &entry = r["caster_position[0]"];
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      if (entry.at(x, y, 3) == 0.0f) {
        CHECK(way.at(x, y, 3) == 0.0f);
      } else if (way.at(x, y, 3) != 0.0f) {
        // Behind the upper ball's lower half or the lower one's.
        const double height = static_cast<double>(start.at(x, y, 1));
        CHECK(std::min(std::fabs(height - 0.875), std::fabs(height - 0.275)) < 0.13);
      }
    }
}
