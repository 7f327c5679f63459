// A half ring of metal against the counted closed form of its reflections.
#include <cmath>

#include "lab/reference/half_ring.hpp"
#include "tests/support/catch.hpp"
#include "tests/truth/rows.hpp"

namespace caustics::test {

namespace {

constexpr double kElevation = 45.0 * 3.14159265358979323846 / 180.0;

// Radius 1 m; the wall is so high that light reaches 0.8 m far, past the cusp. Along +x.
Scene ring_scene() {
  Scene scene;
  scene.materials = {diffuse(0.8f), metal({1.0f, 1.0f, 1.0f})};
  scene.meshes = {floor(3.0, 0.0, 0), half_ring(1.0, 0.8, 1024, 1)};
  scene.lights = {sun({std::cos(kElevation), -std::sin(kElevation), 0.0}, 1.0f)};
  scene.cameras = {camera_down(2.0, 1.0)};
  return scene;
}

// The pixels that lie well inside the ring, of the whole square picture.
std::vector<double> inside_ring(const std::vector<double>& picture, int pixels) {
  std::vector<double> inside;
  for (int y = 0; y < pixels; ++y)
    for (int x = 0; x < pixels; ++x) {
      const glm::dvec2 p = 2.0 * (glm::dvec2(x, y) + 0.5) / double(pixels) - 1.0;
      if (glm::length(p) < 0.95) inside.push_back(picture[static_cast<std::size_t>(y * pixels + x)]);
    }
  return inside;
}

// Middle of the brightest pixel of the two rows along the axis, metres.
double brightest_on_axis(const std::vector<double>& picture, int pixels) {
  int best = 0;
  const auto at = [&](int x) {
    const int i = pixels / 2 * pixels + x;
    return picture[static_cast<std::size_t>(i)] + picture[static_cast<std::size_t>(i - pixels)];
  };
  for (int x = 0; x < pixels * 9 / 10; ++x)
    if (at(x) > at(best)) best = x;
  return 2.0 * (best + 0.5) / pixels - 1.0;
}

// Before the cusp one ray alone meets the axis, E = 1 / (2 s - 1) at x = 1 - s: the line through 1
// / E at x = 0.25 and 0.33 m is 0 at the cusp. Nearer to it E bends too much over a texel.
double cusp_by_extrapolation(const std::vector<double>& picture, int pixels) {
  double place[2], inverse[2];
  for (int i = 0; i < 2; ++i) {
    const int column = static_cast<int>((i == 0 ? 1.25 : 1.33) / 2.0 * pixels);
    const auto at = [&](int row) { return picture[static_cast<std::size_t>(row * pixels + column)]; };
    place[i] = 2.0 * (column + 0.5) / pixels - 1.0;
    inverse[i] = 2.0 / (at(pixels / 2) + at(pixels / 2 - 1));
  }
  return place[0] + inverse[0] * (place[1] - place[0]) / (inverse[0] - inverse[1]);
}

}  // namespace

Rows ring_rows(const Bench& bench) {
  const Scene scene = ring_scene();
  const Settings settings = bench.settings();
  const int pixels = settings.width;
  const Rendering r = bench.render(scene, settings, {"aov_caustic"});
  std::vector<double> picture;
  for (int y = 0; y < pixels; ++y)
    for (int x = 0; x < pixels; ++x) picture.push_back(double(r["aov_caustic"].at(x, y, 0)));
  const HalfRing ring{.radius = 1.0, .reach = 0.8 / std::tan(kElevation)};
  const auto truth = [&](double shift) {
    std::vector<double> values =
        irradiance_average(ring, {.lower = {-1.0 + shift, -1.0}, .side = 2.0, .pixels = pixels}, 16);
    for (double& value : values) value *= std::sin(kElevation);
    return values;
  };
  const double texel = texel_on_floor(scene, r, settings);
  const std::vector<double> exact = truth(0.0);
  const std::vector<double> inside = inside_ring(exact, pixels);
  const double by_a_texel = relative_l1(inside_ring(truth(texel), pixels), inside);
  const double brightest = brightest_on_axis(picture, pixels) - brightest_on_axis(exact, pixels);
  return {{"half ring", "irradiance inside the ring, relative L1",
           relative_l1(inside_ring(picture, pixels), inside), by_a_texel, text_of(settings)},
          {"half ring", "brightest pixel of the axis, against the closed form's means, m",
           std::fabs(brightest), texel + 2.0 / pixels, text_of(settings)},
          {"half ring", "cusp from R / 2, by 1 / E along the axis before it, m",
           std::fabs(cusp_by_extrapolation(picture, pixels) - 0.5), texel, text_of(settings)}};
}

}  // namespace caustics::test

TEST_CASE("truth: a half ring fills its nephroid, whose cusp lies at half the radius") {
  // Irradiance: less than what a shift by one texel of the map would make. Cusp: to a texel and a
  // pixel.
  caustics::test::check_rows(caustics::test::ring_rows);
}
