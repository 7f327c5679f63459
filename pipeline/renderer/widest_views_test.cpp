#include "pipeline/renderer/widest_views.hpp"

#include "pipeline/effects/drawn_sizes.hpp"
#include "pipeline/measure/light_paths.hpp"
#include "pipeline/scene/light_samples.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/pilot.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A lamp of radius `radius` that lights a ball of glass of radius 0.5 m from above; its middle is `above`
// metres over the ball's.
struct Bench {
  Scene scene = sphere_scene(1.5f, 3);
  Settings settings{};
  Effects effects;
  int drawn = -1;  // the sample that throws the caustic

  Bench(double radius, double above) {
    Light& lamp = scene.lights.front();
    lamp.type = LightType::Point;
    lamp.position = {0.0, 0.8 + above, 0.0};
    lamp.shape = LightShape::Sphere;
    lamp.radius = radius;
    sample_lights(scene, 16);
    effects = with_drawn_sizes(effects_of(scene, settings), scene, settings);
    for (int l = 0; l < 16; ++l)
      if (effects.lights[static_cast<std::size_t>(l)].size_is_drawn) drawn = l;
    if (drawn >= 0) effects.lights[static_cast<std::size_t>(drawn)].steps_back = 4.0;
  }
  LightViews views(int sample) const { return widest_views(scene, effects, settings, sample); }
  const Light& light(int sample) const { return scene.lights[static_cast<std::size_t>(sample)]; }
};

}  // namespace

TEST_CASE(
    "widest views: the casters of a wide light are seen from far behind it, and from nowhere before it") {
  const Bench bench(0.4, 2.0);
  REQUIRE(bench.drawn >= 0);
  const LightViews views = bench.views(bench.drawn);
  const glm::dvec3 light = bench.light(bench.drawn).position;
  const double back = glm::dot(light - views.caster.origin, views.caster.forward);
  CHECK(back > 6.0);
  CHECK(back < 12.0);
  CHECK(glm::length(views.caster.origin + views.caster.forward * back - light) < 1e-9);
  CHECK(views.caster.near == Approx(back));
  for (const View* view : {&views.shadow, &views.receiver, &views.caustic, &views.column})
    CHECK(view->origin == light);
  // All of the ball is in its window, and little else.
  double widest = 0.0;
  for (const Vertex& v : bench.scene.meshes[1].vertices) {
    const glm::dvec2 at = views.caster.window(views.caster.coordinates(glm::dvec3(v.position)));
    CHECK(glm::all(glm::lessThan(views.caster.window_lower, at)));
    CHECK(glm::all(glm::lessThan(at, views.caster.window_upper)));
    widest = std::max(widest, std::fabs(at.x));
  }
  CHECK(views.caster.window_upper.x < 1.1 * widest);
}

TEST_CASE("widest views: rays of a view from behind a light start at the light, and go where the view sees") {
  const Bench bench(0.4, 2.0);
  const View view = bench.views(bench.drawn).caster;
  const Light& light = bench.light(bench.drawn);
  for (const int x : {0, 7, 15}) {
    const LightRay ray = light_ray(light, view, 16, x, 3);
    CHECK(glm::dot(ray.origin - light.position, view.forward) == Approx(0.0).margin(1e-9));
    const glm::dvec2 at = view.window(view.coordinates(ray.origin + ray.direction));
    const glm::dvec2 share = (at - view.window_lower) / (view.window_upper - view.window_lower);
    CHECK(share.x == Approx((x + 0.5) / 16.0));
    CHECK(share.y == Approx(3.5 / 16.0));
  }
}

TEST_CASE(
    "widest views: a light that has casters beside it, or no caustic of its whole, looks from where it is") {
  const Bench beside(0.9, 1.2);
  REQUIRE(beside.drawn >= 0);
  CHECK(beside.views(beside.drawn).caster.origin == beside.light(beside.drawn).position);
  const Bench wide(0.4, 2.0);
  for (int l = 0; l < 16; ++l)
    if (l != wide.drawn) CHECK(wide.views(l).caster.origin == wide.light(l).position);
}
