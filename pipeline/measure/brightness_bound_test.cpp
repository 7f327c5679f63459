#include "pipeline/measure/brightness_bound.hpp"

#include <cmath>

#include "pipeline/scene/light_samples.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

constexpr double kPi = 3.14159265358979323846;

BrightnessBound bound_of(const Scene& scene, const Settings& settings, const Rendering* drawn = nullptr) {
  const Effects effects = effects_of(scene, settings);
  return brightness_bound(scene, effects, settings, drawn ? drawn->views : std::vector<LightViews>{},
                          BoundBy::Triangles);
}

// A floor, 4 x 4 m, of albedo 1 under a lamp of 2 candela, `height` above it.
Scene under_lamp(double height) {
  Scene scene;
  scene.materials = {diffuse(1.0f)};
  scene.meshes = {floor(2.0, 0.0, 0)};
  Light lamp{.name = "lamp", .type = LightType::Point, .intensity = 2.0f};
  lamp.position = {0.0, height, 0.0};
  scene.lights = {lamp};
  return scene;
}

}  // namespace

TEST_CASE("brightness bound: a lamp gives what it does at the nearest surface, four times over") {
  const Scene scene = under_lamp(0.5);
  const BrightnessBound bound = bound_of(scene, Settings{});
  CHECK(bound.direct == Approx(4.0 * 2.0 / 0.25));
  CHECK(bound.caustic == 0.0);
  // As a white surface, and mirrored by the smoothest: 1 / (pi alpha^3) of it, alpha being 0.2 squared.
  CHECK(bound.radiance == Approx(32.0 / kPi * (1.0 + 1.0 / (0.04 * 0.04 * 0.04))).epsilon(1e-9));
}

TEST_CASE("brightness bound: a lamp on a surface has one too, by the lamp's own radius") {
  Scene scene = under_lamp(0.0);
  sample_lights(scene, 1);
  const double radius = 1e-4 * std::sqrt(8.0);
  CHECK(bound_of(scene, Settings{}).direct == Approx(4.0 * 2.0 / (radius * radius)));
}

TEST_CASE("brightness bound: the sharpest focus stays below it, what is 1e5 times as bright does not") {
  // A sphere of glass in the sun.
  Scene scene = sphere_scene(1.5f);
  const Settings settings = small_settings(192, 192, 128);
  const Rendering r = render(scene, settings, {"aov_direct", "aov_caustic", "beauty"});
  const BrightnessBound bound = bound_of(scene, settings, &r);
  double most = 0.0, radiance = 0.0;
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 128; ++x) {
      CHECK(double(r["aov_direct"].at(x, y, 0)) <= bound.direct);
      most = std::max(most, double(r["aov_caustic"].at(x, y, 0)));
      radiance = std::max(radiance, double(r["beauty"].at(x, y, 0)));
    }
  }
  INFO("caustic " << most << " of " << bound.caustic << " lux, " << radiance << " of " << bound.radiance);
  CHECK(most > 5.0);
  CHECK(most <= bound.caustic);
  CHECK(radiance <= bound.radiance);
  CHECK(bound.caustic < 1e5 * most);
  CHECK(bound.radiance < 1e12);
}

TEST_CASE("brightness bound: all that a caustic's lamp sends may lie in the smallest texel, in a corner") {
  const Scene scene = sphere_scene(1.5f);
  Settings settings;
  settings.map = 100;
  LightViews views;
  views.caster.window_lower = glm::dvec2(-0.5);
  views.caster.window_upper = glm::dvec2(0.5);
  views.caustic.window_lower = glm::dvec2(-1.0);
  views.caustic.window_upper = glm::dvec2(1.0);
  const auto times_direct = [&] {
    const BrightnessBound bound =
        brightness_bound(scene, effects_of(scene, settings), settings, {views}, BoundBy::Triangles);
    return bound.caustic / bound.direct;
  };
  // A window of 1 in one of 100 x 100 texels of 4.
  views.caustic.perspective = false;
  CHECK(times_direct() == Approx(2500.0));
  // In the corner (1, 1) of a perspective window a texel is seen under 3^(-3/2) of the middle's angle.
  views.caustic.perspective = true;
  CHECK(times_direct() == Approx(2500.0 * 3.0 * std::sqrt(3.0)));
  views.cascade = views.caustic;
  views.cascade->window_upper = glm::dvec2(0.0);
  CHECK(times_direct() == Approx(10000.0 * 3.0 * std::sqrt(3.0)));
}

TEST_CASE("brightness bound: what shines and what is around count, a studio by what the lights give") {
  Scene scene = under_lamp(10.0);
  scene.lights[0].intensity = 1e-6f;
  scene.materials[0].emissive = {100.0f, 2.0f, 1.0f};
  scene.environment.zenith = glm::vec3(7.0f);
  // A studio of 7 nit is no work of this lamp.
  CHECK(bound_of(scene, Settings{}).radiance == Approx(4.0 * 100.0).epsilon(0.01));
  scene.environment.image = Image(Format::RGBA32F, 2, 1);
  scene.environment.image->at(1, 0, 1) = 7.0f;
  CHECK(bound_of(scene, Settings{}).radiance == Approx(4.0 * (100.0 + 3.0 * 7.0)).epsilon(0.01));
}
