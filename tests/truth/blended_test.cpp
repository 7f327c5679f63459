// Blended surfaces in whole frames, against what their coverage alone gives; and what partly clear glass
// scatters.
#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/run_pass.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

struct Sheet {
  double height, middle;  // metres; it spans 1 m along x
  float albedo, alpha;
};

// A floor of albedo 0.8 under sun at 45 degrees, which travels along +x, and level sheets, seen from above
// over 2 x 2 m. The sky is black, and nothing mirrors.
Scene sheets_over_floor(const std::vector<Sheet>& sheets) {
  Scene scene;
  scene.materials = {diffuse(0.8f)};
  scene.meshes = {floor(6.0, 0.0, 0)};
  for (const Sheet& sheet : sheets) {
    Material material = diffuse(sheet.albedo);
    material.base_color.a = sheet.alpha;
    material.alpha_mode = AlphaMode::Blend;
    Mesh mesh = floor(0.5, sheet.height, static_cast<int>(scene.materials.size()));
    for (Vertex& v : mesh.vertices) {
      v.position.x += static_cast<float>(sheet.middle);
      v.position.z *= 4.0f;
    }
    mesh.lower = {sheet.middle - 0.5, sheet.height, -2.0};
    mesh.upper = {sheet.middle + 0.5, sheet.height, 2.0};
    scene.materials.push_back(material);
    scene.meshes.push_back(mesh);
  }
  scene.lights = {sun({1.0, -1.0, 0.0}, 3.14159265f)};
  scene.environment.zenith = scene.environment.horizon = scene.environment.ground = glm::vec3(0.0f);
  scene.cameras = {camera_down(3.0, 1.0)};
  return scene;
}

// At x, metres: the radiance over that of albedo 1 under the same light.
double seen_at(const std::vector<Sheet>& sheets, double x) {
  Settings settings = small_settings(16, 16, 64);
  settings.highlights = false;
  const Rendering r = render(sheets_over_floor(sheets), settings, {"beauty"});
  const int column = static_cast<int>((x + 1.0) * 32.0);
  return static_cast<double>(r["beauty"].at(column, 32, 0)) / std::sqrt(0.5);
}

// Likewise at x = -0.8, through a plate of index 1 high above, whose light falls elsewhere.
double seen_through_glass(const std::vector<Sheet>& sheets) {
  Scene scene = sheets_over_floor(sheets);
  scene.meshes.push_back(box({-1.0, 2.0, -2.0}, {-0.6, 2.1, 2.0}, static_cast<int>(scene.materials.size())));
  scene.materials.push_back(glass(1.0f));
  Settings settings = small_settings(16, 16, 64);
  settings.highlights = false;
  return static_cast<double>(render(scene, settings, {"beauty"})["beauty"].at(6, 32, 0)) / std::sqrt(0.5);
}

}  // namespace

TEST_CASE("blended surfaces: a black sheet of alpha 0.25 leaves 0.75 of view and of light, two 0.5625") {
  // A sheet at height 1 over x in -1.5..-0.5 throws its shadow onto -0.5..0.5.
  const Sheet one{1.0, -1.0, 0.0f, 0.25f}, other{1.05, -1.0, 0.0f, 0.25f};
  CHECK(seen_at({one}, 0.8) == Approx(0.8).epsilon(1e-5));
  CHECK(seen_at({one}, 0.0) == Approx(0.8 * 0.75).epsilon(1e-5));
  CHECK(seen_at({one}, -0.8) == Approx(0.8 * 0.75).epsilon(1e-5));
  CHECK(seen_at({one, other}, 0.0) == Approx(0.8 * 0.5625).epsilon(1e-5));
  CHECK(seen_at({one, other}, -0.8) == Approx(0.8 * 0.5625).epsilon(1e-5));
}

TEST_CASE("blended surfaces: the nearer lies over the farther, in whatever order they come") {
  const Sheet white{1.05, -1.0, 1.0f, 0.5f}, black{1.0, -1.0, 0.0f, 0.25f};
  const double white_over_black = 0.5 * 1.0 + 0.5 * (0.25 * 0.0 + 0.75 * 0.8);
  CHECK(seen_at({white, black}, -0.8) == Approx(white_over_black).epsilon(1e-5));
  CHECK(seen_at({black, white}, -0.8) == Approx(white_over_black).epsilon(1e-5));
  const Sheet below{0.95, -1.0, 1.0f, 0.5f};
  const double black_over_white = 0.75 * (0.5 * 1.0 + 0.5 * 0.8);
  CHECK(seen_at({below, black}, -0.8) == Approx(black_over_white).epsilon(1e-5));
}

TEST_CASE("blended surfaces: behind clear glass they are seen as without it") {
  const Sheet white{1.05, -1.0, 1.0f, 0.5f}, other{1.0, -1.0, 1.0f, 0.5f};
  CHECK(seen_through_glass({}) == Approx(0.8).epsilon(1e-4));
  CHECK(seen_through_glass({white}) == Approx(0.5 + 0.5 * 0.8).epsilon(1e-4));
  CHECK(seen_through_glass({white, other}) == Approx(0.75 + 0.25 * 0.8).epsilon(1e-4));
  // Far apart, they do not darken each other's pixels.
  const Sheet above{1.4, -1.0, 1.0f, 0.5f};
  CHECK(seen_through_glass({above, other}) == Approx(0.75 + 0.25 * 0.8).epsilon(5e-3));
}

TEST_CASE("blended surfaces: of many in one place the nearest four are shown") {
  std::vector<Sheet> sheets;
  for (int i = 0; i < 12; ++i) sheets.push_back({1.0 + 0.01 * i, -1.0, 0.0f, 0.25f});
  CHECK(seen_at(sheets, -0.8) == Approx(0.8 * 0.31640625).epsilon(1e-5));
}

TEST_CASE("blended surfaces: the light of a caustic comes through the sheet before its caster") {
  Scene scene = sphere_scene(1.5f, 3);
  const Settings settings = small_settings(32, 32, 32);
  const std::string map = light_texture(kCausticMap, 0);
  const double whole = sum(render(scene, settings, {map})[map]);
  Material sheet = diffuse(0.0f);
  sheet.base_color.a = 0.25f;
  sheet.alpha_mode = AlphaMode::Blend;
  scene.materials.push_back(sheet);
  scene.meshes.push_back(floor(1.0, 2.0, 2));
  CHECK(whole > 0.1);
  CHECK(sum(render(scene, settings, {map})[map]) == Approx(0.75 * whole).epsilon(1e-5));
}

TEST_CASE(
    "partly clear glass: a ball is shaded by the cosine, without a shadow of its own on what it scatters") {
  // It bends nothing, mirrors nothing, and scatters 0.75 of pi lux from 45 degrees.
  Scene scene;
  scene.materials = {diffuse(0.0f), glass(1.0f)};
  scene.materials[1].transmission = 0.25f;
  scene.meshes = {floor(3.0, -1.5, 0), sphere({0.0, 0.0, 0.0}, 1.0, 5, 1)};
  scene.lights = {sun({1.0, -1.0, 0.0}, 3.14159265f)};
  scene.environment.zenith = scene.environment.horizon = scene.environment.ground = glm::vec3(0.0f);
  scene.cameras = {camera_down(4.0, 1.05)};
  const int side = 48;
  const Image beauty = render(scene, small_settings(64, 64, side), {"beauty"})["beauty"];
  double least = 2.0, most = 0.0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const double u = 1.05 * (2.0 * (x + 0.5) / side - 1.0), v = 1.05 * (2.0 * (y + 0.5) / side - 1.0);
      if (u * u + v * v > 0.9 * 0.9) continue;
      const double cosine = (std::sqrt(1.0 - u * u - v * v) - u) / std::sqrt(2.0);
      if (cosine < 0.3) continue;
      const double share = static_cast<double>(beauty.at(x, y, 0)) / (0.75 * cosine);
      least = std::min(least, share);
      most = std::max(most, share);
    }
  CHECK(least > 0.97);
  CHECK(most < 1.03);
}
