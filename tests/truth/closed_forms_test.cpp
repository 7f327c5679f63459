// Whole frames against closed forms that share no code with the passes (lab/reference/closed_forms.hpp).
#include "lab/reference/closed_forms.hpp"
#include "lab/reference/sphere_floor.hpp"

#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/scenes.hpp"
#include "tests/truth/prism.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// Irradiance in lux that reaches each pixel of the orthographic picture, rows from -z (up) reversed to
// match row 0 at the bottom: x to the right, y = -z upwards.
std::vector<double> floor_irradiance(const Rendering& r, const Settings& settings) {
  std::vector<double> values;
  for (int y = 0; y < settings.height; ++y)
    for (int x = 0; x < settings.width; ++x)
      values.push_back(double(r["aov_direct"].at(x, y, 0)) + double(r["aov_caustic"].at(x, y, 0)));
  return values;
}

std::vector<double> floor_irradiance(const Scene& scene, const Settings& settings) {
  return floor_irradiance(render_alone(scene, settings, {"aov_direct", "aov_caustic"}), settings);
}

// What the passes of these names took together, whatever light they ran for.
double milliseconds(const Rendering& r, const std::vector<std::string>& passes) {
  double sum = 0.0;
  for (const PassReport& report : r.passes)
    for (const std::string& pass : passes)
      if (report.label.substr(0, report.label.find('[')) == pass) sum += report.result.milliseconds;
  return sum;
}

// The sphere scene's floor against the closed form, direct light included.
SphereFloorError compare_sphere(const std::vector<double>& picture) {
  return compare_with_sphere(picture, {.radius = 0.5, .index = 1.5, .distance = 0.8}, 2.0);
}

}  // namespace

TEST_CASE("truth: the caustic of a glass sphere, by points, Gaussians and cells") {
  // The bounds are what is reached at this size with some room; at grid and map 512 see
  // docs/accuracy.md.
  const int pixels = 128;
  Settings settings = through_two_surfaces(small_settings(256, 256, pixels));
  for (const auto& [splat, bound] :
       {std::pair{Splat::Gaussian, 0.11}, std::pair{Splat::Point, 0.07}, std::pair{Splat::Cell, 0.05}}) {
    settings.splat = splat;
    const SphereFloorError error = compare_sphere(floor_irradiance(sphere_scene(1.5f), settings));
    INFO(name_of(splat) << ": relative L1 " << error.relative_l1_in_shadow << ", flux " << error.flux_ratio);
    CHECK(error.relative_l1_in_shadow < bound);
    CHECK(error.flux_ratio == Approx(1.0).epsilon(0.01));
  }
}

TEST_CASE("truth: figures of the glass sphere at full size", "[.figures]") {
  // Not part of a run by default: caustics_tests "[.figures]" prints the figures of docs/accuracy.md.
  const int pixels = 512;
  for (const int map : {256, 512})
    for (const int grid : {64, 128, 256, 512, 1024})
      for (const Splat splat : {Splat::Point, Splat::Gaussian, Splat::Cell}) {
        Settings settings = small_settings(grid, map, pixels);
        settings.splat = splat;
        const Rendering r = render(sphere_scene(1.5f, 6), settings, {"aov_direct", "aov_caustic"});
        const SphereFloorError c = compare_sphere(floor_irradiance(r, settings));
        WARN("map " << map << ", grid " << grid << ", " << name_of(splat) << ": relative L1 "
                    << c.relative_l1_in_shadow << ", flux ratio " << c.flux_ratio << ", "
                    << milliseconds(r, {"landing", "cells", "caustic_cells", "caustic_map"})
                    << " ms from the landings to the map");
      }
}

TEST_CASE("truth: distance impostors find the landings on a floor as the secant does") {
  // All of the floor is one plane, on which both are exact; the maps of positions differ.
  const int pixels = 128;
  Settings settings = small_settings(256, 256, pixels);
  settings.iterations = 3;
  settings.estimator = Estimator::Impostor;
  const SphereFloorError impostor = compare_sphere(floor_irradiance(sphere_scene(1.5f), settings));
  INFO("impostor: relative L1 " << impostor.relative_l1_in_shadow << ", flux " << impostor.flux_ratio);
  CHECK(impostor.relative_l1_in_shadow < 0.06);
  CHECK(impostor.flux_ratio == Approx(1.0).epsilon(0.01));
}

TEST_CASE("truth: figures of the estimators at three steps", "[.figures]") {
  // Shah et al. 2007, figure 6: three iterations each.
  const int pixels = 512;
  for (const Estimator estimator :
       {Estimator::Paper, Estimator::Newton, Estimator::Impostor, Estimator::Secant}) {
    Settings settings = small_settings(512, 512, pixels);
    settings.iterations = 3;
    settings.estimator = estimator;
    const Rendering r = render(sphere_scene(1.5f, 6), settings, {"aov_direct", "aov_caustic"});
    const SphereFloorError c = compare_sphere(floor_irradiance(r, settings));
    WARN(name_of(estimator) << ": relative L1 " << c.relative_l1_in_shadow << ", flux ratio " << c.flux_ratio
                            << ", impostor map " << milliseconds(r, {"impostor_map"}) << " ms, landing "
                            << milliseconds(r, {"landing"}) << " ms");
  }
}

TEST_CASE("truth: a slab of glass shifts slanting light and dims it") {
  // Thickness 0.3 m, its lower face 0.5 m above the floor, 2 m wide; light at 40 degrees. On the floor the
  // light through the slab is shifted back by t (tan 40 - tan theta_t) and dimmed by T(40)^2.
  const double angle = 40.0 * 3.14159265358979323846 / 180.0, thickness = 0.3, n = 1.5;
  Scene scene;
  scene.materials = {diffuse(0.8f), glass(1.5f)};
  scene.meshes = {floor(4.0, 0.0, 0), box({-1.0, 0.5, -1.0}, {1.0, 0.8, 1.0}, 1)};
  scene.lights = {sun({std::sin(angle), -std::cos(angle), 0.0}, 1.0f)};
  scene.cameras = {camera_down(0.4, 2.0)};
  constexpr int kPicture = 1024;
  Settings settings = small_settings(512, 512, kPicture);
  const std::vector<double> picture = floor_irradiance(scene, settings);
  const double side = 4.0 / kPicture, shift = slab_floor_shift(angle, n, thickness);
  // Along the floor's middle line, at pixel centres.
  const auto at = [&](int x) { return picture[static_cast<std::size_t>(kPicture / 2 * kPicture + x)]; };
  // The middle of the lit patch, in which light that entered the top and left the bottom lands.
  const double passes = std::cos(angle) * slab_transmittance(angle, n, thickness);
  const int middle = static_cast<int>((0.5 * std::tan(angle) + 2.0) / side);
  CHECK(at(middle) == Approx(passes).epsilon(0.005));
  // The patch's left end: the top's left edge at x = -1, y = 0.8 lands at -1 + 0.8 tan - shift. Light that
  // met the left face lies elsewhere. From the middle of the patch leftwards, where it falls to half.
  const double expected = -1.0 + 0.8 * std::tan(angle) - shift;
  int x = middle;
  while (at(x - 1) > 0.5 * passes) --x;
  const double part = (at(x) - 0.5 * passes) / (at(x) - at(x - 1));
  const double found = (x + 0.5 - part) * side - 2.0;
  // A texel of the caustic map: the patch's extent of at least 2 m over 512 texels.
  const double texel = 2.0 / 512;
  INFO("edge off by " << (found - expected) / texel << " texels");
  CHECK(std::fabs(found - expected) < texel);
}

TEST_CASE("truth: a sine wave of water focuses as its closed form says") {
  // a k = 0.3, floor at 0.6 of the first focus' depth: one branch everywhere.
  const double k = 2.0 * 3.14159265358979323846 / 0.5, amplitude = 0.3 / k;
  WaterWave wave{.amplitude = amplitude, .wave_number = k, .index = 1.33, .depth = 1.0};
  wave.depth = 0.6 * wave.first_focus();
  Scene scene;
  scene.materials = {diffuse(0.8f), glass(1.33f)};
  scene.meshes = {floor(2.0, 0.0, 0), wave_sheet(1.0, wave.depth, amplitude, k, 200, 1)};
  scene.lights = {sun({0.0, -1.0, 0.0}, 1.0f)};
  scene.cameras = {camera_down(0.5 * wave.depth, 0.5)};
  Settings settings = small_settings(512, 512, 64);
  const std::vector<double> picture = floor_irradiance(scene, settings);
  const std::vector<double> truth = irradiance_average(wave, -0.5, 0.5, 64, 1.0);
  double difference = 0.0, total = 0.0, brightest = 0.0;
  for (std::size_t x = 0; x < 64; ++x) {
    difference += std::fabs(picture[32 * 64 + x] - truth[x]);
    total += truth[x];
    brightest = std::max(brightest, truth[x]);
  }
  INFO("relative L1 " << difference / total);
  CHECK(brightest > 1.5);
  CHECK(difference / total < 0.03);
}

TEST_CASE("truth: a prism turns light by its deviation") {
  const Prism prism(glass(1.5f));
  const Rendering r = render(prism.scene, small_settings(128, 128, 8), {kLanding, kCausticMap});
  int compared = 0;
  const double worst = worst_landing(prism, r, light_texture(kLanding, 0), 1.5, compared);
  CHECK(compared > 10);
  // Interpolated between receiver texels a plane is exact: what is left is single precision over 0.6 m.
  CHECK(worst < 2e-6);
}

TEST_CASE("truth: a dispersing prism fans light out by its closed form") {
  // BK7: n_d = 1.5168, Abbe number 64.17. With Cauchy's n_F - n_C = 0.008054 the F and C lines leave 0.70
  // degrees apart (0.7026 by Sellmeier's formula), and each lands where light of its own index does.
  Material bk7 = glass(1.5168f);
  bk7.dispersion = static_cast<float>(20.0 / 64.17);
  const Prism prism(bk7);
  const Rendering r =
      render(prism.scene, through_two_surfaces(small_settings(128, 128, 8)), {kLanding, kCausticMap});
  REQUIRE(r.branches.size() == 3);
  double deviation[3];
  for (std::size_t i = 0; i < 3; ++i) {
    const double n = 1.5168 + 0.5168 / 64.17 * r.branches[i].bend;
    deviation[i] = *prism_deviation(60.0 * Prism::kDegree, n, prism.incidence) / Prism::kDegree;
    int compared = 0;
    CHECK(worst_landing(prism, r, branch_texture(kLanding, 0, r.branches[i]), n, compared) < 2e-6);
    CHECK(compared > 10);
  }
  CHECK(deviation[2] - deviation[0] == Approx(0.7026).epsilon(0.005));
}

TEST_CASE("truth: a half ring of metal concentrates light as its closed form says") {
  // Radius 1 m, wall 0.3 m high, light at 45 degrees along +x: light that falls s metres on before
  // it meets the floor is concentrated by cos t / |cos t - 2 s|. On the axis, t = 0, it lands at x
  // = 1 - s, and the band ends with the wall at s = 0.3.
  const double elevation = 45.0 * 3.14159265358979323846 / 180.0;
  Scene scene;
  scene.materials = {diffuse(0.8f), metal({1.0f, 1.0f, 1.0f})};
  scene.meshes = {floor(3.0, 0.0, 0), half_ring(1.0, 0.3, 512, 1)};
  scene.lights = {sun({std::cos(elevation), -std::sin(elevation), 0.0}, 1.0f)};
  scene.cameras = {camera_down(2.0, 1.28)};
  const int pixels = 256;
  Settings settings = small_settings(1024, 1024, pixels);
  const Rendering r = render(scene, settings, {"aov_caustic"});
  // The mean over 5 x 5 pixels of 1 cm: single ones show how grid and map beat.
  const auto caustic = [&](double x) {
    const int column = static_cast<int>((x + 1.28) / 2.56 * pixels);
    double sum = 0.0;
    for (int dy = -2; dy <= 2; ++dy)
      for (int dx = -2; dx <= 2; ++dx)
        sum += static_cast<double>(r["aov_caustic"].at(column + dx, pixels / 2 + dy, 0));
    return sum / 25.0;
  };
  for (const double s : {0.05, 0.1, 0.15, 0.2, 0.25}) {
    const double expected = std::sin(elevation) * ring_irradiance(1.0, 0.0, s);
    INFO("s = " << s << ": " << caustic(1.0 - s) << ", expected " << expected);
    CHECK(caustic(1.0 - s) == Approx(expected).epsilon(0.05));
  }
  CHECK(caustic(1.0 - 0.35) == Approx(0.0).margin(0.01));
}
