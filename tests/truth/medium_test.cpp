// A medium around scenes with known answers: attenuation, single scattering, flux on planes, the place of a
// focus.
#include <algorithm>
#include <cmath>
#include <utility>

#include "tests/support/catch.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

constexpr double kPi = 3.14159265358979323846;

Scene with_medium(Scene scene, const glm::vec3& scattering, const glm::vec3& absorption,
                  float anisotropy = 0.0f) {
  scene.medium = {scattering, absorption, anisotropy};
  return scene;
}

// A camera 1 m above the floor that looks along -z over it, 1 x 1 m, from its edge at z = 3.
Scene side_view() {
  Scene scene = without_casters(sphere_scene(1.5f));
  Camera& camera = scene.cameras[0];
  camera.position = {0.0, 1.0, 3.0};
  camera.up = {0.0, 1.0, 0.0};
  camera.forward = {0.0, 0.0, -1.0};
  camera.half_width = camera.half_height = 0.5;
  return scene;
}

// Light left of a vertical unit irradiance under a sphere of radius 0.5 that bends and takes nothing and is
// no medium itself: integral of exp(-s (h - 2 c)) 2 pi r dr, c = sqrt(R^2 - r^2), h the way without the
// sphere.
double under_clear_sphere(double s, double h) {
  return 2.0 * kPi * std::exp(-s * h) * (std::exp(s) * (s - 1.0) + 1.0) / (4.0 * s * s);
}

// The same light through `bodies` of radius r in a row, all with their centres on its way.
double under_clear_spheres(double s, double h, double r, int bodies) {
  const double k = 2.0 * bodies * s;
  return 2.0 * kPi * std::exp(-s * h) * (std::exp(k * r) * (k * r - 1.0) + 1.0) / (k * k);
}

Settings without_highlights(int grid, int map, int picture) {
  Settings settings = small_settings(grid, map, picture);
  settings.highlights = false;
  return settings;
}

}  // namespace

TEST_CASE("medium: one that only absorbs dims a floor by Beer's and Lambert's law") {
  // The medium reaches up to the camera, 0.2 m: the light goes through it down and up again.
  const glm::vec3 absorption{0.5f, 1.0f, 2.0f};
  const Scene scene = with_medium(without_casters(sphere_scene(1.5f)), glm::vec3(0.0f), absorption);
  const Rendering r = render(scene, without_highlights(8, 8, 9), {"beauty", "aov_direct"});
  for (int c = 0; c < 3; ++c) {
    CHECK(r["aov_direct"].at(4, 4, c) == Approx(std::exp(-0.2 * absorption[c])).epsilon(1e-5));
    CHECK(r["beauty"].at(4, 4, c) == Approx(0.8 / kPi * std::exp(-0.4 * absorption[c])).epsilon(1e-5));
  }
  CHECK(r.images.count("haze") == 0);
}

TEST_CASE("medium: light that reaches all of a ray alike scatters as the closed form says") {
  // Rays of 6 m across a vertical light of 1 lux, which has come 1 - y metres through the medium. Henyey and
  // Greenstein across: (1 - g^2) / (4 pi (1 + g^2)^1.5). No surface is seen, and there is no sky.
  const glm::vec3 scattering{0.1f, 0.3f, 1.0f}, absorption{0.05f, 0.0f, 0.2f};
  Scene scene = with_medium(side_view(), scattering, absorption, 0.5f);
  const Rendering r = render(scene, small_settings(8, 8, 8), {"beauty"});
  const double phase = 0.75 / (4.0 * kPi * std::pow(1.25, 1.5));
  for (int row = 0; row < 4; ++row) {
    const double y = 0.5 + (row + 0.5) / 8.0;
    for (int c = 0; c < 3; ++c) {
      const double s = double(scattering[c]) + double(absorption[c]);
      const double expected =
          scattering[c] * phase * std::exp(-s * (1.0 - y)) * (1.0 - std::exp(-6.0 * s)) / s;
      CHECK(r["beauty"].at(3, row, c) == Approx(expected).epsilon(1e-5));
    }
  }
  // Above the medium's box there is nothing.
  CHECK(r["beauty"].at(3, 6, 0) == 0.0f);
}

TEST_CASE("medium: towards the light both ways count") {
  // Straight down on the floor from 0.2 m, light from behind the camera: it has come as far as it goes back.
  // The steps follow the sum of both ways exactly.
  Scene scene = with_medium(without_casters(sphere_scene(1.5f)), glm::vec3(2.0f), glm::vec3(1.0f));
  scene.materials[0].base_color = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
  const Rendering r = render(scene, without_highlights(8, 8, 9), {"beauty"});
  CHECK(r["beauty"].at(4, 4, 0) == Approx(2.0 / (4.0 * kPi) * (1.0 - std::exp(-1.2)) / 6.0).epsilon(1e-5));
}

TEST_CASE("medium: a lamp's light scatters by the inverse square, also along rays that pass near it") {
  // A ray of 6 m in a thin medium, which passes the lamp at its middle at 0.1 m: the integral of I / r^2 is
  // 2 atan(3 / 0.1) / 0.1 candela per metre.
  Scene scene = with_medium(side_view(), glm::vec3(1e-4f), glm::vec3(0.0f));
  scene.lights = {Light{.name = "lamp", .type = LightType::Point, .intensity = 5.0f}};
  // Row 3's middle lies at y = 0.9375, column 4's at x = 0.0625.
  scene.lights[0].position = {0.0625, 0.8375, 0.0};
  const Rendering r = render(scene, small_settings(8, 8, 8), {"beauty"});
  CHECK(r["beauty"].at(4, 3, 0) == Approx(1e-4 * 5.0 / (4.0 * kPi) * 20.0 * std::atan(30.0)).epsilon(1e-3));
}

TEST_CASE("medium: a spot's beam is as bright as its chord says, however narrow it is") {
  // The lamp is 2 m beside a ray, which crosses its axis: the light sees the ray's chord under the cone's
  // angle, so that the integral of I / r^2 is that angle over the distance, across and at a slant alike. The
  // cone's edge is a thousandth of it wide.
  for (const double half_angle : {0.001, 0.005, 0.05, 0.3})
    for (const double slant : {0.0, 0.5}) {
      INFO("half angle " << half_angle << ", slant " << slant);
      Scene scene = with_medium(side_view(), glm::vec3(1e-5f), glm::vec3(0.0f));
      scene.lights = {Light{.name = "spot", .type = LightType::Spot, .intensity = 5.0f}};
      // Row 3's middle lies at y = 0.9375, column 4's at x = 0.0625.
      scene.lights[0].position = {0.0625 - 2.0, 0.9375, 0.1};
      scene.lights[0].direction = {std::cos(slant), 0.0, std::sin(slant)};
      scene.lights[0].inner_cone = scene.lights[0].outer_cone = static_cast<float>(half_angle);
      const float haze = render(scene, small_settings(8, 8, 8), {"haze"})["haze"].at(4, 3, 0);
      CHECK(haze / (1e-5 / (4.0 * kPi) * 5.0 * 2.0 * half_angle / 2.0) == Approx(1.0).epsilon(2e-3));
    }
}

TEST_CASE("medium: a narrow beam loses on its way what the medium takes") {
  // A spot of 8000 cd/m^2 times its square distance of 4 m^2, 31 mm of beam, 0.3 per metre over 2 m from the
  // lamp and 3 m on to where the camera's ray enters.
  Scene scene = with_medium(side_view(), glm::vec3(0.3f), glm::vec3(0.0f));
  scene.lights = {Light{.name = "spot", .type = LightType::Spot, .intensity = 32000.0f}};
  scene.lights[0].position = {0.0625 - 2.0, 0.9375, 0.0};
  scene.lights[0].direction = {1.0, 0.0, 0.0};
  scene.lights[0].inner_cone = scene.lights[0].outer_cone = static_cast<float>(0.0155 / 2.0);
  const float haze = render(scene, small_settings(8, 8, 8), {"haze"})["haze"].at(4, 3, 0);
  CHECK(haze == Approx(0.3 / (4.0 * kPi) * 8000.0 * 0.031 * std::exp(-0.3 * 5.0)).epsilon(2e-3));
}

TEST_CASE("medium: light between the boards of a fence is found, with 16 steps as with 256") {
  // The sun shines along x through 5 gaps of 4 cm and one of 12 cm. What is between them is dark. Texels of
  // the shadow map are 6 m / 2048.
  Scene scene = with_medium(side_view(), glm::vec3(1e-3f), glm::vec3(0.0f));
  scene.lights = {sun({1.0, 0.0, 0.0}, 1.0f)};
  const std::pair<double, double> gaps[] = {{-2.4, 0.04},  {-1.57, 0.04}, {-0.7, 0.04},
                                            {0.333, 0.04}, {1.1, 0.12},   {2.2, 0.04}};
  double start = -3.0, gap_width = 0.0;
  for (const auto& [z, width] : gaps) {
    scene.meshes.push_back(box({-1.0, 0.1, start}, {-0.95, 1.9, z}, 0));
    start = z + width;
    gap_width += width;
  }
  scene.meshes.push_back(box({-1.0, 0.1, start}, {-0.95, 1.9, 3.0}, 0));
  Settings settings = small_settings(8, 8, 8);
  settings.shadow = 2048;
  for (const int steps : {16, 32, 256}) {
    INFO(steps << " steps");
    settings.medium_steps = steps;
    const float haze = render(scene, settings, {"haze"})["haze"].at(4, 3, 0);
    CHECK(haze == Approx(1e-3 / (4.0 * kPi) * gap_width).epsilon(0.03));
  }
}

TEST_CASE("medium: several lights' beams add up along one ray") {
  Scene scene = with_medium(side_view(), glm::vec3(1e-5f), glm::vec3(0.0f));
  scene.lights.clear();
  double expected = 0.0;
  for (const double z : {-2.0, -0.5, 1.5}) {
    Light spot{.name = "spot", .type = LightType::Spot, .intensity = 5.0f};
    spot.position = {0.0625 - 1.0, 0.9375, z};
    spot.direction = {1.0, 0.0, 0.0};
    spot.inner_cone = spot.outer_cone = 0.004f;
    scene.lights.push_back(spot);
    expected += 1e-5 / (4.0 * kPi) * 5.0 * 0.008 / 1.0;
  }
  const float haze = render(scene, small_settings(8, 8, 8), {"haze"})["haze"].at(4, 3, 0);
  CHECK(haze / expected == Approx(1.0).epsilon(2e-3));
}

TEST_CASE("medium: looked along, a beam is as bright as the angle says under which the lamp sees it") {
  // The ray is 1 cm beside the axis of a lamp at z = 2.9: it enters the cone 0.01 / tan(0.02) m after the
  // lamp, and ends at a wall 2 m after it.
  Scene scene = with_medium(side_view(), glm::vec3(1e-5f), glm::vec3(0.0f));
  scene.meshes.push_back(box({-3.0, 0.0, 0.8}, {3.0, 1.8, 0.9}, 0));
  scene.lights = {Light{.name = "spot", .type = LightType::Spot, .intensity = 5.0f}};
  scene.lights[0].position = {0.0725, 0.9375, 2.9};
  scene.lights[0].direction = {0.0, 0.0, -1.0};
  scene.lights[0].inner_cone = scene.lights[0].outer_cone = 0.02f;
  const double angle = 0.02 - std::atan(0.01 / 2.0);
  const float haze = render(scene, small_settings(8, 8, 8), {"haze"})["haze"].at(4, 3, 0);
  CHECK(haze / (1e-5 / (4.0 * kPi) * 5.0 * angle / 0.01) == Approx(1.0).epsilon(2e-3));
}

TEST_CASE("medium: an opaque surface's shadow is dark in the haze") {
  // A lid over the floor shadows 2 of the 6 m of each ray below it.
  Scene scene = with_medium(side_view(), glm::vec3(1e-3f), glm::vec3(0.0f));
  scene.meshes.push_back(box({-3.0, 1.2, -1.0}, {3.0, 1.3, 1.0}, 0));
  Settings settings = small_settings(128, 64, 8);
  settings.shadow = 1024;
  const float haze = render(scene, settings, {"haze"})["haze"].at(3, 2, 0);
  // The medium takes up to 0.6 % on the way, a texel of the shadow map is 0.1 % of the light's way.
  CHECK(haze == Approx(1e-3 / (4.0 * kPi) * 4.0).epsilon(0.008));
}

TEST_CASE("medium: the flux on every plane is the photons' alive, less what the medium took") {
  const double s = 0.7;
  const Scene scene = with_medium(sphere_scene(1.0f), glm::vec3(0.4f), glm::vec3(0.3f));
  const Settings settings = through_two_surfaces(small_settings(128, 128, 16));
  const Rendering r =
      render(scene, settings, {kCausticMap, kLandingFresnel, kLandingAbsorbed, kLandingMedium});
  const Image &start = r["stretch_start[0]"], &way = r["stretch_way[0]"], &flux = r["stretch_flux[0]"];
  for (const double height : {0.25, 0.1, 0.0}) {
    double sum = 0.0;
    for (int y = 0; y < start.height(); ++y)
      for (int x = 0; x < start.width(); ++x) {
        if (way.at(x, y, 3) == 0.0f) continue;
        const double distance = (double(start.at(x, y, 1)) - height) / -double(way.at(x, y, 1));
        if (distance < 0.0 || distance > double(start.at(x, y, 3)) + 1e-4) continue;
        sum += double(flux.at(x, y, 0)) * std::exp(-s * distance);
      }
    // The light enters at the sphere's top, 1.3 m up. Coverage of the grid and the sphere's facets: 2e-3.
    CHECK(sum == Approx(under_clear_sphere(s, 1.3 - height)).epsilon(3e-3));
  }
  const Ledger ledger = ledger_of(r, settings);
  CHECK(ledger.in_map[0] == Approx(under_clear_sphere(s, 1.3)).epsilon(3e-3));
  CHECK(ledger.medium[0] == Approx(0.25 * kPi - under_clear_sphere(s, 1.3)).epsilon(3e-3));
  CHECK(ledger.residual() < 1e-5);
}

TEST_CASE("medium: followed light loses what lies outside of all bodies, and a stretch stands for all") {
  const double s = 0.7, r = 0.25;
  Scene scene = with_medium(sphere_scene(1.0f), glm::vec3(0.4f), glm::vec3(0.3f));
  scene.meshes = {floor(3.0, 0.0, 0), sphere({0.0, 1.0, 0.0}, r, 5, 1), sphere({0.0, 0.4, 0.0}, r, 5, 1)};
  Settings settings = small_settings(128, 128, 16);
  settings.further_share = 0.0f;
  const Rendering rendered = render(
      scene, settings,
      {kCausticMap, kLandingFresnel, kLandingAbsorbed, kLandingMedium, "stretch_start", "stretch_flux"});
  REQUIRE(rendered.effects.further_surfaces.active);
  const Ledger ledger = ledger_of(rendered, settings);
  CHECK(ledger.in_map[0] == Approx(under_clear_spheres(s, 1.25, r, 2)).epsilon(3e-3));
  CHECK(ledger.medium[0] == Approx(kPi * r * r - under_clear_spheres(s, 1.25, r, 2)).epsilon(3e-3));
  CHECK(ledger.residual() < 1e-5);
  // Each vertex draws one of two stretches: between the spheres, or below them.
  const Image &start = rendered["stretch_start[0]"], &flux = rendered["stretch_flux[0]"];
  for (const auto& [height, bodies] : {std::pair(0.7, 1), std::pair(0.05, 2)}) {
    double sum = 0.0;
    for (int y = 0; y < start.height(); ++y)
      for (int x = 0; x < start.width(); ++x) {
        const double distance = static_cast<double>(start.at(x, y, 1)) - height;
        if (distance < 0.0 || distance > static_cast<double>(start.at(x, y, 3)) + 1e-4) continue;
        sum += static_cast<double>(flux.at(x, y, 0)) * std::exp(-s * distance);
      }
    CHECK(sum == Approx(under_clear_spheres(s, 1.25 - height, r, bodies)).epsilon(0.02));
  }
}

TEST_CASE("medium: the ledger closes with every branch") {
  Scene scene = with_medium(sphere_scene(1.5f), {0.3f, 0.5f, 0.7f}, glm::vec3(0.1f));
  scene.materials[1].dispersion = 0.5f;
  Settings settings = small_settings(64, 64, 16);
  settings.reflections = true;
  const Rendering r =
      render(scene, settings, {kCausticMap, kLandingFresnel, kLandingAbsorbed, kLandingMedium});
  const Ledger ledger = ledger_of(r, settings);
  CHECK(ledger.residual() < 1e-5);
  for (std::size_t c = 0; c < 3; ++c) {
    CHECK(ledger.medium[c] > 0.0);
    CHECK(ledger.fresnel[c] > 0.0);
  }
  CHECK(ledger.medium[0] < ledger.medium[2]);
}

TEST_CASE("medium: behind clear glass beams fill in what it takes out of the direct haze") {
  // IOR 1 bends and takes nothing, so below the sphere the haze is as bright, all in all, as without it. Seen
  // from the side; a lid of 2 cm keeps the medium as high. With one grid vertex a beam, and with four by
  // four.
  Scene scene = with_medium(sphere_scene(1.0f), glm::vec3(1e-3f), glm::vec3(0.0f));
  Camera& camera = scene.cameras[0];
  camera.position = {0.0, 0.6, 3.0};
  camera.up = {0.0, 1.0, 0.0};
  camera.forward = {0.0, 0.0, -1.0};
  camera.half_width = camera.half_height = 0.8;
  Scene bare = without_casters(scene);
  bare.meshes.push_back(floor(0.01, 1.3, 0));
  Settings settings = small_settings(64, 64, 96);
  // Rows 0 to 23 of 96 are those up to 0.2 m, columns 18 to 77 those beside the axis up to 0.5 m.
  const auto below_sphere = [](const Image& haze) {
    double sum = 0.0;
    for (int y = 0; y < 24; ++y)
      for (int x = 18; x < 78; ++x) sum += double(haze.at(x, y, 0));
    return sum;
  };
  const double without = below_sphere(render(bare, settings, {"haze"})["haze"]);
  REQUIRE(without > 0.0);
  for (const int shafts : {64, 16}) {
    settings.shafts = shafts;
    CHECK(below_sphere(render(scene, settings, {"haze"})["haze"]) == Approx(without).epsilon(2e-3));
  }
}

TEST_CASE("medium: a sphere's beams cross its axis where a ray of their height does") {
  // R sin i / sin 2(i - t) from the centre, sin i = b / R = n sin t (0.75 m for b towards 0). Interpolated
  // normals and the exit map's texels scatter single rays; the mean over a ring is held to half a per cent.
  const Scene scene = with_medium(sphere_scene(1.5f, 6), glm::vec3(0.1f), glm::vec3(0.0f));
  const float further_share = GENERATE(0.0f, 1.0f);
  Settings settings = small_settings(256, 64, 16);
  settings.further_share = further_share;
  const Rendering r = render(scene, settings, {"stretch_start", "stretch_way"});
  const Image &start = r["stretch_start[0]"], &way = r["stretch_way[0]"], &entry = r["caster_position[0]"];
  for (const double ring : {0.05, 0.1, 0.2, 0.3}) {
    double sum = 0.0;
    int count = 0;
    for (int y = 0; y < 256; ++y)
      for (int x = 0; x < 256; ++x) {
        const double b = std::hypot(double(entry.at(x, y, 0)), double(entry.at(x, y, 2)));
        if (way.at(x, y, 3) == 0.0f || std::fabs(b - ring) > 0.01) continue;
        const double i = std::asin(b / 0.5), t = std::asin(b / 0.75);
        const double expected = b / std::sin(2.0 * (i - t));
        const double radius = std::hypot(double(start.at(x, y, 0)), double(start.at(x, y, 2)));
        const double across = std::hypot(double(way.at(x, y, 0)), double(way.at(x, y, 2)));
        sum += (0.8 - double(start.at(x, y, 1)) - double(way.at(x, y, 1)) * radius / across) / expected;
        ++count;
      }
    REQUIRE(count > 100);
    CHECK(sum / count == Approx(1.0).epsilon(0.005));
  }
}

TEST_CASE("medium: clear air has no pass, texture or number of its own") {
  const Scene scene = sphere_scene(1.5f);
  const Settings settings = small_settings(16, 16, 8);
  const FramePlan plan = make_plan(scene, effects_of(scene, settings), settings, pass_registry());
  for (const char* name : {"haze", "view_range", "landing_medium[0]", "stretch_start[0]", "beam_start[0]"})
    CHECK(plan.find(name) < 0);
  for (const PlannedPass& pass : plan.passes) CHECK(pass.label.find("medium") == std::string::npos);
}

TEST_CASE("medium: rays along an axis that pass by it are left alone, also where a light has a position") {
  Scene scene = with_medium(without_casters(sphere_scene(1.5f)), glm::vec3(0.2f), glm::vec3(0.1f));
  scene.cameras = {camera_down(0.2, 5.0)};  // the floor, and with it the medium, ends at 3 m
  scene.lights[0].type = LightType::Point;
  scene.lights[0].position = {0.3, 2.0, 0.2};
  const Rendering r = render(scene, small_settings(8, 8, 8), {"beauty", "haze"});
  for (const auto& [name, image] : r.images) {
    INFO(name);
    CHECK(count_non_finite(image) == 0);
  }
  CHECK(r["haze"].at(0, 4, 0) == 0.0f);
  CHECK(r["beauty"].at(0, 4, 0) == 0.0f);
  CHECK(r["haze"].at(4, 4, 0) > 0.0f);
}
