// The flux ledger end to end: what enters is in the map or in a named loss, on whole frames.
#include <algorithm>
#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

Ledger ledger(const Scene& scene, const Settings& settings) {
  return ledger_of(render(scene, settings, {kCausticMap, kLandingFresnel, kLandingAbsorbed}), settings);
}

constexpr double kPi = 3.14159265358979323846;

}  // namespace

TEST_CASE("ledger: everything that entered a sphere is in the map or in a named loss") {
  for (const Splat splat : {Splat::Point, Splat::Gaussian, Splat::Cell}) {
    Settings settings = through_two_surfaces(small_settings(128, 128, 16));
    settings.splat = splat;
    CHECK(ledger(sphere_scene(1.5f), settings).residual() < 1e-5);
  }
}

TEST_CASE("ledger: it closes where ways are drawn, and they add up to what other branches leave behind") {
  Scene scene = sphere_scene(1.5f);
  scene.meshes.push_back(box({-0.6, 0.3, -0.6}, {0.6, 0.35, 0.6}, 1));
  Settings settings = small_settings(128, 128, 16);
  settings.further_share = 0.0f;
  settings.splits = 0;
  const Ledger l = ledger(scene, settings);
  CHECK(l.residual() < 1e-5);
  CHECK(std::fabs(l.fresnel[0]) < 0.005 * l.entered[0]);
}

TEST_CASE("ledger: it closes over all wavelengths, and they enter as white") {
  Scene scene = sphere_scene(1.5f);
  scene.materials[1].dispersion = 0.7f;
  for (const int wavelengths : {3, 8}) {
    Settings settings = through_two_surfaces(small_settings(64, 64, 16));
    settings.wavelengths = wavelengths;
    const Ledger l = ledger(scene, settings);
    CHECK(l.residual() < 1e-5);
    for (const std::size_t c : {0u, 1u, 2u}) CHECK(l.entered[c] == Approx(kPi * 0.25).epsilon(4e-3));
  }
}

TEST_CASE("ledger: where all wavelengths bend alike the map is that of one") {
  // Dispersion moves landings only, so without it eight wavelengths are one, but for the rounding of sums.
  Scene scene = sphere_scene(1.5f);
  scene.materials[1].dispersion = 1e-9f;
  Settings settings = through_two_surfaces(small_settings(64, 64, 16));
  settings.wavelengths = 8;
  const Rendering many = render(scene, settings, {kCausticMap});
  REQUIRE(many.branches.size() == 8);
  settings.wavelengths = 1;
  const Rendering one = render(scene, settings, {kCausticMap});
  const Image &a = many[light_texture(kCausticMap, 0)], &b = one[light_texture(kCausticMap, 0)];
  REQUIRE(b.channels() == 1);  // nothing tints it
  double worst = 0.0, largest = 0.0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      largest = std::max(largest, double(b.at(x, y, 0)));
      for (int c = 0; c < 3; ++c)
        worst = std::max(worst, std::fabs(double(a.at(x, y, c)) - double(b.at(x, y, 0))));
    }
  CHECK(worst < 1e-5 * largest);
}

TEST_CASE("ledger: what glass mirrors moves from Fresnel's account into the map") {
  // A sheet of water above a wall-less floor sends its share upwards: missed or outside. A sphere's first
  // surface mirrors 0.09178 of the light; half of that goes up, the rest can land.
  Settings settings = through_two_surfaces(small_settings(128, 128, 16));
  const Ledger without = ledger(sphere_scene(1.5f), settings);
  settings.reflections = true;
  const Ledger with = ledger(sphere_scene(1.5f), settings);
  CHECK(with.residual() < 1e-5);
  CHECK((without.fresnel[0] - with.fresnel[0]) / with.entered[0] == Approx(0.09178).epsilon(0.01));
}

TEST_CASE("ledger: what entered is the light's irradiance times the silhouette's area") {
  // pi r^2 = 0.785398 m^2; centre-sampled coverage of a 128 x 128 grid is right to about 4e-4.
  const Ledger l = ledger(sphere_scene(1.5f), through_two_surfaces(small_settings(128, 128, 16)));
  CHECK(l.entered[0] == Approx(kPi * 0.25).epsilon(2e-3));
}

TEST_CASE("ledger: a glass sphere passes 0.8355 of the light and reflects 0.1644 once or twice") {
  // Area-weighted mean of the squared unpolarised transmittance for n = 1.5: 0.83554. (First surface
  // 0.09178, second 0.07268.)
  const Ledger l = ledger(sphere_scene(1.5f), through_two_surfaces(small_settings(256, 256, 16)));
  CHECK(l.fresnel[0] / l.entered[0] == Approx(1.0 - 0.83554).epsilon(0.01));
  CHECK((l.in_map[0] + l.missed[0] + l.outside[0] + l.exit_not_found[0]) / l.entered[0] ==
        Approx(0.83554).epsilon(0.003));
}

TEST_CASE("ledger: nearly all of what passes a sphere lands in the map") {
  const Ledger l = ledger(sphere_scene(1.5f), through_two_surfaces(small_settings(256, 256, 16)));
  CHECK(l.in_map[0] / l.entered[0] > 0.83);
  CHECK((l.not_converged[0] + l.exit_not_found[0]) / l.entered[0] < 2e-3);
}

TEST_CASE("ledger: the paper's weights add up to two thirds on a sphere") {
  Settings settings = through_two_surfaces(small_settings(256, 256, 16));
  settings.weights = Weights::Paper;
  const Ledger l = ledger(sphere_scene(1.5f), settings);
  CHECK(l.fresnel[0] == 0.0);
  CHECK(l.entered[0] == Approx(2.0 / 3.0 * kPi * 0.25).epsilon(3e-3));
}

TEST_CASE("ledger: where Fresnel is left out nothing is booked as mirrored, and more lands") {
  const auto booked = [](float factor) {
    Scene scene = sphere_scene(1.5f, 4);
    for (Material& material : scene.materials) material.fresnel_factor = factor;
    return ledger(scene, through_two_surfaces(small_settings(64, 64, 16)));
  };
  const Ledger with = booked(1.0f), without = booked(0.0f);
  CHECK(without.fresnel[0] == 0.0);
  CHECK(with.fresnel[0] > 0.15 * with.entered[0]);
  CHECK(without.in_map[0] > 1.15 * with.in_map[0]);
  CHECK(without.entered[0] == with.entered[0]);
}

TEST_CASE("ledger: absorption takes what Beer and Lambert say of a sphere") {
  // <exp(-a 2R cos b)> over the disc for n = 1.5, a R = 0.8, without Fresnel: 0.246768 (n^2 / 2 (F(L0) -
  // F(Lm)), verified numerically); the paper's weights leave Fresnel out but weigh with N.L, so the
  // physical ones are used and compared by ratio with a clear sphere's transmitted flux: the Fresnel factor
  // changes the weights of the chords by under 2 %.
  Scene scene = sphere_scene(1.5f);
  scene.materials[1].attenuation_distance = 1.0f;
  scene.materials[1].attenuation_color = glm::vec3(static_cast<float>(std::exp(-1.6)), 1.0f, 1.0f);
  const Ledger l = ledger(scene, through_two_surfaces(small_settings(256, 256, 16)));
  CHECK(l.in_map[0] / l.in_map[1] == Approx(0.246768).epsilon(0.02));
  CHECK(l.absorbed[1] == Approx(0.0).margin(1e-9));
  CHECK(l.residual() < 1e-5);
}

TEST_CASE("ledger: a caster that the light cannot see makes no caustic passes and no error") {
  Scene scene = sphere_scene(1.5f);
  scene.lights[0].intensity = 0.0f;
  const Rendering r = render(scene, through_two_surfaces(small_settings(32, 32, 16)), {"picture"});
  CHECK(r.images.count(light_texture(kCausticMap, 0)) == 0);
}

TEST_CASE("ledger: a caster in an opaque shadow throws no caustic") {
  Scene scene = sphere_scene(1.5f);
  Mesh lid = floor(1.0, 2.0, 0);
  scene.meshes.push_back(lid);
  const Ledger l = ledger(scene, through_two_surfaces(small_settings(64, 64, 16)));
  REQUIRE(l.vertices.size() == kLandingStatuses);
  CHECK(l.entered[0] == 0.0);
  CHECK(l.vertices[static_cast<std::size_t>(LandingStatus::Empty)] == 64u * 64u);
}
