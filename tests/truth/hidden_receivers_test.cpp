// Light lands on what other receivers hide from the light.
#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

const std::vector<std::string> kTextures = [] {
  std::vector<std::string> textures{"aov_caustic",
                                    far_texture(kLanding),
                                    far_texture(kLandingFlux),
                                    far_texture(kLandingFresnel),
                                    far_texture(kLandingAbsorbed),
                                    far_texture(kCellFlux),
                                    far_texture(kCausticMap)};
  textures.insert(textures.end(), kEstimateTextures.begin(), kEstimateTextures.end());
  return textures;
}();

// Below the focus of a sphere of glass light goes outwards. A board beside the axis, 0.12 m above the floor,
// hides the floor below it from the light's own view, but light goes in under its inner edge at x = 0.15 m.
// The camera is below the board.
Scene sphere_above(bool board) {
  Scene scene = sphere_scene(1.5f);
  scene.cameras = {camera_down(0.1, 1.0)};
  if (!board) return scene;
  Mesh mesh = floor(0.05, 0.12, 0);
  for (Vertex& v : mesh.vertices) v.position.x += 0.2f;
  finish(mesh, 0.0f);
  scene.meshes.push_back(mesh);
  return scene;
}

// Flux on the floor just behind the edge.
double behind_edge(const Rendering& r, int pixels) {
  double sum = 0.0;
  for (int y = 0; y < pixels; ++y)
    for (int x = 0; x < pixels; ++x) {
      const glm::dvec2 p = 2.0 * (glm::dvec2(x, y) + 0.5) / double(pixels) - 1.0;
      if (p.x > 0.155 && p.x < 0.185 && std::fabs(p.y) < 0.04) sum += double(r["aov_caustic"].at(x, y, 0));
    }
  return sum * 4.0 / (double(pixels) * double(pixels));
}

}  // namespace

TEST_CASE("far receivers: light lands on what a receiver hides from the light") {
  Settings settings = small_settings(256, 512, 256);
  const Rendering open = render(sphere_above(false), settings, kTextures);
  const Rendering with = render(sphere_above(true), settings, kTextures);
  settings.hidden_receivers = false;
  const Rendering without = render(sphere_above(true), settings, kTextures);
  // The board takes nothing of what lands there; a texel of 4 mm at its edge is shared by both sides, of 30
  // mm that are counted.
  CHECK(behind_edge(with, 256) == Approx(behind_edge(open, 256)).epsilon(0.1));
  CHECK(behind_edge(without, 256) < 0.1 * behind_edge(open, 256));
  const Ledger ledger = ledger_of(with, settings);
  CHECK(ledger.residual() < 1e-5);
  CHECK(ledger.not_converged[0] < 0.1 * ledger_of(without, settings).not_converged[0]);
}

TEST_CASE("far receivers: only what has not landed before is followed again") {
  const Settings settings = through_two_surfaces(small_settings(128, 128, 16));
  const Rendering r = render(sphere_above(true), settings, kTextures);
  const Image &near = r[light_texture(kLanding, 0)], &far = r[light_texture(far_texture(kLanding), 0)];
  int again = 0;
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x) {
      const bool lost = near.at(x, y, 3) == float(LandingStatus::NotConverged);
      CHECK((far.at(x, y, 3) != 0.0f) == lost);
      again += lost ? 1 : 0;
    }
  CHECK(again > 20);
}

TEST_CASE("far receivers: receivers in one plane, and impostors, do without") {
  Settings settings;
  CHECK_FALSE(effects_of(sphere_above(false), settings).hidden_receivers.active);
  CHECK(effects_of(sphere_above(true), settings).hidden_receivers.active);
  settings.estimator = Estimator::Impostor;
  CHECK_FALSE(effects_of(sphere_above(true), settings).hidden_receivers.active);
}
