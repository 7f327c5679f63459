// What the light tracer holds to: the same bits, states that go on, books that close, and single laws of
// light.
#include <algorithm>
#include <array>
#include <cmath>

#include "lab/reference/closed_forms.hpp"
#include "lab/reference/tracer/direct.hpp"
#include "tests/truth/tracer_run.hpp"

namespace caustics::tracer {

TEST_CASE("tracer: the picture has the same bits for one thread and for three") {
  test::need_ray_queries();
  for (const Physics physics : {Physics::Single, Physics::Full}) {
    const Run one(test::sphere_scene(1.5f, 4), 24, 200, 3, physics, {}, 1);
    const Run three(test::sphere_scene(1.5f, 4), 24, 200, 3, physics, {}, 3);
    CHECK(one.tracer->state().sum == three.tracer->state().sum);
    CHECK(one.tracer->state().squares == three.tracer->state().squares);
    CHECK(to_bytes(one.tracer->state(), "") == to_bytes(three.tracer->state(), ""));
    check_closed(one.account());
  }
}

TEST_CASE("tracer: a run that was broken off goes on to the same bits") {
  test::need_ray_queries();
  const Run whole(test::sphere_scene(1.5f, 4), 24, 64, 5);
  const Run first(test::sphere_scene(1.5f, 4), 24, 64, 2);
  Run then(test::sphere_scene(1.5f, 4), 24, 64, 0);
  const std::string kept = to_bytes(first.tracer->state(), first.request());
  then.tracer->restore(from_bytes(kept, then.request(), then.tracer->state()));
  // A batch that is broken off leaves nothing.
  CHECK_FALSE(then.tracer->run_batch([] { return true; }));
  for (int i = 0; i < 3; ++i) REQUIRE(then.tracer->run_batch());
  CHECK(to_bytes(then.tracer->state(), "") == to_bytes(whole.tracer->state(), ""));
}

TEST_CASE("tracer: the state of another request is refused, and says what differs") {
  test::need_ray_queries();
  const Run run(test::sphere_scene(1.5f, 3), 8, 8, 1);
  const std::string kept = to_bytes(run.tracer->state(), run.request());
  const auto refused = [&](const Run& other, const std::string& why) {
    const std::string line = refusal([&] { from_bytes(kept, other.request(), other.tracer->state()); });
    INFO(line);
    CHECK(says(line, why));
  };
  refused(Run(test::sphere_scene(1.5f, 3), 9, 8, 0), "size: 8x8 there, size: 9x9 here");
  refused(Run(test::sphere_scene(1.5f, 3), 8, 9, 0), "rays: 8 there, rays: 9 here");
  refused(Run(test::sphere_scene(1.5f, 3), 8, 8, 0, Physics::Full), "physics: single there");
  refused(Run(test::sphere_scene(1.6f, 3), 8, 8, 0), "scene: ");
  const auto of = [&](const std::string& bytes) {
    return refusal([&] { from_bytes(bytes, run.request(), run.tracer->state()); });
  };
  CHECK(of(kept).empty());
  CHECK(says(of(kept.substr(0, kept.size() - 1)), "damaged"));
  CHECK(says(of("nonsense"), "no state"));
}

TEST_CASE("tracer: what glass mirrors lands where that is asked for, and the ledger closes") {
  test::need_ray_queries();
  Settings with;
  with.reflections = true;
  const Run off(test::sphere_scene(1.5f, 4), 8, 128, 2),
      on(test::sphere_scene(1.5f, 4), 8, 128, 2, Physics::Single, with);
  check_closed(on.account());
  // What is followed now is no longer lost to Fresnel.
  const auto reached = [](const Account& a) { return a.landed.x + a.missed.x; };
  CHECK(off.account().fresnel.x - on.account().fresnel.x ==
        Approx(reached(on.account()) - reached(off.account())).epsilon(1e-9));
  // That is what the first surface mirrors, in the mean over a sphere's disc; the second's is not followed.
  CHECK((off.account().fresnel.x - on.account().fresnel.x) / on.account().entered.x ==
        Approx(0.09178).epsilon(5e-3));
}

TEST_CASE("tracer: a tinted solid absorbs as Beer and Lambert say") {
  test::need_ray_queries();
  Scene scene = test::sphere_scene(1.0f, 6);
  scene.materials[1].attenuation_color = {0.5f, 1.0f, 0.25f};
  scene.materials[1].attenuation_distance = 1.0f;
  const Run run(std::move(scene), 8, 256, 2);
  // With n = 1 the chords are straight; no interface takes anything.
  const GlassSphere sphere{.radius = 0.5, .index = 1.0, .distance = 0.8, .absorption = std::log(2.0)};
  CHECK(run.account().landed.x / run.account().entered.x == Approx(mean_absorption(sphere)).epsilon(2e-3));
  CHECK(run.account().landed.y == Approx(run.account().entered.y).epsilon(1e-9));
  check_closed(run.account());
}

TEST_CASE("tracer: a body's colour tints light once, from outside and from within") {
  test::need_ray_queries();
  Scene scene = slab_scene(0.0);
  scene.materials[1] = test::glass(1.0f);  // so that nothing else takes any
  scene.materials[1].base_color = {0.5f, 1.0f, 0.25f, 1.0f};
  Light lamp{.name = "lamp", .type = LightType::Point, .intensity = 1.0f};
  lamp.position = {0.1, 0.6, 0.2};  // between the slab's faces
  for (const Light& light : {scene.lights[0], lamp}) {
    scene.lights = {light};
    for (const Physics physics : {Physics::Single, Physics::Full}) {
      const Run run(scene, 4, 32, 2, physics);
      const Account& a = run.account();
      REQUIRE(a.entered.x > 0.0);
      const glm::dvec3 left = (a.landed + a.missed) / a.entered;
      INFO(light.name << " " << int(physics));
      CHECK(left.x == Approx(0.5).epsilon(1e-9));
      CHECK(left.y == Approx(1.0).epsilon(1e-9));
      CHECK(left.z == Approx(0.25).epsilon(1e-9));
      check_closed(a);
    }
  }
}

TEST_CASE("tracer truth: a long panel lights the floor by its form factor") {
  test::need_ray_queries();
  // 4 m x 0.5 m, a metre above the floor, of luminance 1.
  const Light panel = panel_above(1.0, 2.0f, 4.0, 0.5);
  Scene scene;
  scene.materials = {test::diffuse(0.8f), test::glass(1.5f)};
  scene.meshes = {test::floor(9.0, 0.0, 0), test::sphere({8.0, 0.2, 8.0}, 0.1, 2, 1)};
  scene.lights = {panel};
  scene.cameras = {test::camera_down(0.5, 1e-3)};
  const Run run(std::move(scene), 5, 8, 0);
  // A quarter of it from beneath a corner, a by b at a distance of 1 (Siegel and Howell's configuration 3).
  const double a = 2.0, b = 0.25, x = std::hypot(1.0, a), y = std::hypot(1.0, b);
  const double expected = 4.0 * 0.5 * (a / x * std::atan(b / x) + b / y * std::atan(a / y));
  double sum = 0.0;
  for (const double value : red(direct_light(run.tracer->world(), run.tracer->film(), 0)))
    sum += value / 25.0;
  CHECK(sum == Approx(expected).epsilon(5e-3));
}

TEST_CASE("tracer: what stands before a caster keeps its light away") {
  if (!has_ray_queries()) return;
  // A board over the half of the sphere that lies at x > 0.
  Scene scene = test::sphere_scene(1.5f, 4);
  scene.meshes.push_back(test::box({0.0, 2.0, -1.0}, {1.0, 2.1, 1.0}, 0));
  const Run half(std::move(scene), 8, 128, 2), whole(test::sphere_scene(1.5f, 4), 8, 128, 2);
  CHECK(half.account().entered.x == Approx(0.5 * whole.account().entered.x).epsilon(5e-3));
}

TEST_CASE("tracer: a spot light falls off by the square of a ramp of the cosine") {
  Light spot{.name = "spot", .type = LightType::Spot};
  spot.inner_cone = 0.2f;
  spot.outer_cone = 0.6f;
  const auto at = [&](double cosine) {
    return Falloff(spot).at({std::sqrt(1.0 - cosine * cosine), 0.0, -cosine}, {0.0, 0.0, -1.0});
  };
  CHECK(at(std::cos(0.1)) == 1.0);
  CHECK(at(0.5 * (std::cos(0.2) + std::cos(0.6))) == Approx(0.25));
  CHECK(at(std::cos(0.7)) == 0.0);
}

TEST_CASE("tracer: a thin pane passes direct light less what both its faces mirror") {
  if (!has_ray_queries()) return;
  Scene scene;
  scene.materials = {test::diffuse(0.8f), test::glass(1.5f)};
  scene.materials[1].thickness = 0.0f;
  scene.meshes = {test::floor(3.0, 0.0, 0), test::floor(2.0, 1.0, 1)};
  scene.lights = {test::sun({0.0, -1.0, 0.0}, 1.0f)};
  scene.cameras = {test::camera_down(0.3, 0.3)};
  const Run run(std::move(scene), 4, 8, 1);
  // R = 0.04 at either face: (1 - R) / (1 + R).
  for (const double value : red(direct_light(run.tracer->world(), run.tracer->film(), 0)))
    CHECK(value == Approx(0.96 / 1.04).epsilon(1e-6));
}

TEST_CASE("tracer: a pane tints what a caster sends on, before it and behind it") {
  test::need_ray_queries();
  const auto landed = [](double height) {
    Scene scene;
    scene.materials = {test::diffuse(0.8f), test::glass(1.5f), test::glass(1.5f)};
    scene.materials[2].thickness = 0.0f;
    scene.materials[2].base_color = {1.0f, 0.5f, 0.0f, 1.0f};
    scene.meshes = {test::floor(3.0, 0.0, 0), test::box({-1, 0.5, -1}, {1, 0.6, 1}, 1),
                    test::floor(1.5, height, 2)};
    scene.lights = {test::sun({0.0, -1.0, 0.0}, 1.0f)};
    scene.cameras = {test::camera_down(0.2, 1.0)};
    const Run run(scene, 8, 300, 2, Physics::Full);
    check_closed(run.account());
    return run.account().landed / (4.0 * run.batches());
  };
  // (1 - R) / (1 + R) with R = 0.04 for each, and what goes to and fro between them.
  constexpr double through = 0.96 / 1.04, back = 1.0 - through,
                   both = through * through / (1.0 - back * back);
  for (const double height : {0.8, 0.45}) {
    const glm::dvec3 light = landed(height);
    CHECK(light.x == Approx(both).margin(3e-3));
    CHECK(light.y == Approx(0.5 * both).margin(3e-3));
    CHECK(light.z == 0.0);
  }
}

TEST_CASE("tracer: a pane that is there in part passes all that meets no part of it") {
  test::need_ray_queries();
  // (1 - R) / (1 + R) with R = 0.04 of the slab and of what is there of the pane.
  constexpr double through = 0.96 / 1.04, back = 1.0 - through;
  for (const double there : {0.25, 0.5, 0.75})
    for (const double height : {0.8, 0.45}) {
      Scene scene;
      scene.materials = {test::diffuse(0.8f), test::glass(1.5f), test::glass(1.5f)};
      scene.materials[2].thickness = 0.0f;
      scene.materials[2].alpha_mode = AlphaMode::Blend;
      scene.materials[2].base_color = {1.0f, 0.5f, 0.0f, static_cast<float>(there)};
      scene.meshes = {test::floor(3.0, 0.0, 0), test::box({-1, 0.5, -1}, {1, 0.6, 1}, 1),
                      test::floor(1.5, height, 2)};
      scene.lights = {test::sun({0.0, -1.0, 0.0}, 1.0f)};
      scene.cameras = {test::camera_down(0.2, 1.0)};
      const Run run(scene, 8, 150, 2, Physics::Full);
      check_closed(run.account());
      const glm::dvec3 landed = run.account().landed / (4.0 * run.batches());
      INFO(there << " " << height);
      for (int c = 0; c < 3; ++c) {
        const double passed = 1.0 - there + there * through * glm::dvec3(1.0, 0.5, 0.0)[c];
        CHECK(landed[c] == Approx(through * passed / (1.0 - back * there * back)).margin(6e-3));
      }
    }
}

TEST_CASE("tracer: each blended sheet takes of direct light by its own coverage") {
  test::need_ray_queries();
  const std::array<float, 3> alphas = {0.25f, 0.5f, 0.75f};
  Scene scene;
  scene.materials = {test::diffuse(0.8f), test::glass(1.5f)};
  // Over the floor's left, its right, and all of it; the floor comes after them, a ball that nobody sees
  // last.
  for (std::size_t i = 0; i < 3; ++i) {
    Material material = test::diffuse(0.0f);
    material.base_color.a = alphas[i];
    material.alpha_mode = AlphaMode::Blend;
    Mesh sheet = test::floor(2.0, 1.0 + 0.25 * static_cast<double>(i), static_cast<int>(i) + 2);
    if (i < 2)
      for (Vertex& v : sheet.vertices) v.position.x += i == 0 ? -2.0f : 2.0f;
    test::finish(sheet, sheet.closedness);
    scene.materials.push_back(material);
    scene.meshes.push_back(sheet);
  }
  scene.meshes.push_back(test::floor(3.0, 0.0, 0));
  scene.meshes.push_back(test::sphere({8.0, 0.2, 8.0}, 0.1, 2, 1));
  scene.lights = {test::sun({0.0, -1.0, 0.0}, 1.0f)};
  scene.cameras = {test::camera_down(0.5, 0.4)};
  const Run run(std::move(scene), 4, 8, 0);
  const std::vector<double> light = red(direct_light(run.tracer->world(), run.tracer->film(), 0));
  REQUIRE(light.size() == 16);
  for (std::size_t i = 0; i < light.size(); ++i)
    CHECK(light[i] == Approx((i % 4 < 2 ? 0.75 : 0.5) * 0.25).epsilon(1e-6));
}

TEST_CASE("tracer: a pixel sees a caster that lies before its receiver, and none behind it or at its depth") {
  test::need_ray_queries();
  for (const double above : {-1.0, -0.3, -0.01, 0.0, 0.01, 0.3}) {
    Scene scene = slab_scene(0.0);
    scene.meshes[1] = test::box({-1.5, above - 0.1, -1.5}, {1.5, above, 1.5}, 1);
    scene.cameras = {test::camera_down(2.0, 0.3)};
    const Run run(std::move(scene), 4, 8, 0);
    const Film& film = run.tracer->film();
    for (std::size_t i = 0; i < film.pixels(); ++i) {
      INFO(above);
      CHECK(film.seen(i).caster == (above > 0.0));
      CHECK(film.seen(i).mesh == (above > 0.0 ? 1 : 0));
      CHECK(film.seen(i).depth == Approx(2.0 - std::max(above, 0.0)).epsilon(1e-6));
    }
  }
}

TEST_CASE("tracer: a medium takes its part of light outside of glass") {
  test::need_ray_queries();
  Scene hazy = test::sphere_scene(1.0f);
  hazy.medium.scattering = glm::vec3(0.7f);
  const Run run(hazy, 8, 400, 2, Physics::Full);
  check_closed(run.account());
  // The light's way to the sphere and beyond it, over its disk: integrals of exp(-s (0.5 - c)) 2 pi r dr
  // and of exp(-s (1.3 - 2 c)) 2 pi r dr, c = sqrt(R^2 - r^2), R = 0.5.
  const double s = 0.7, before = std::exp(-0.5 * s) * (std::exp(0.5 * s) * (0.5 * s - 1.0) + 1.0) / (s * s);
  const double whole = std::exp(-1.3 * s) * (std::exp(s) * (s - 1.0) + 1.0) / (4.0 * s * s);
  CHECK(run.account().landed.x / run.account().entered.x == Approx(whole / before).epsilon(2e-3));
}

TEST_CASE("tracer: what an alpha mask cuts out of a caster is not there") {
  test::need_ray_queries();
  Scene cut_out = test::sphere_scene(1.5f, 2);
  CHECK(Run(cut_out, 8, 8, 1).account().hits > 0.0);
  cut_out.materials[1].alpha_mode = AlphaMode::Mask;
  cut_out.materials[1].base_color.a = 0.0f;
  CHECK(Run(cut_out, 8, 8, 1).account().hits == 0.0);
}

TEST_CASE("tracer: bodies of the same glass that touch are one, stacked or one within the other") {
  test::need_ray_queries();
  const auto passed = [](std::vector<Mesh> bodies) {
    Scene scene;
    scene.materials = {test::diffuse(0.8f), test::glass(1.5f), test::glass(1.5f)};
    scene.meshes = std::move(bodies);
    scene.meshes.insert(scene.meshes.begin(), test::floor(3.0, 0.0, 0));
    scene.lights = {test::sun({0.0, -1.0, 0.0}, 1.0f)};
    scene.cameras = {test::camera_down(0.2, 1.0)};
    const Run run(scene, 8, 400, 2, Physics::Full);
    check_closed(run.account());
    return run.account().landed.x / run.account().entered.x;
  };
  // (1 - R) / (1 + R) with R = 0.04; some thousand draws of what is mirrored twice. Sides take a little.
  CHECK(passed({test::box({-1, 0.5, -1}, {1, 0.65, 1}, 1), test::box({-1, 0.65, -1}, {1, 0.8, 1}, 2)}) ==
        Approx(0.96 / 1.04).margin(3e-3));
  CHECK(passed({test::box({-1, 0.5, -1}, {1, 0.8, 1}, 1), test::box({-1, 0.65, -1}, {1, 0.8, 1}, 2)}) ==
        Approx(0.96 / 1.04).margin(3e-3));
}

}  // namespace caustics::tracer
