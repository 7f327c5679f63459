#include "pipeline/renderer/lit_receivers.hpp"

#include "pipeline/renderer/widest_views.hpp"
#include "pipeline/settings/settings.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/pilot.hpp"
#include "tests/support/shapes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// What vertical light lands on that has come so far.
LitReceivers lit(const Scene& scene, const std::vector<LightRay>& rays) {
  const Effects effects = effects_of(scene, Settings{});
  const RayTables tables(scene, effects, pilot().device);
  const Settings settings;
  const LightPaths paths(tables, effects, settings, pilot().registry);
  std::vector<LightLanding> landings;
  paths.follow(rays, landings);
  const LightViews views = widest_views(scene, effects, settings, 0);
  return lit_receivers(landings, seen_by_light({paths, tables, scene.lights[0], views}, landings),
                       scene.meshes.size());
}

// A mirror that slants at 45 degrees sends light level to a wall; or lies level and sends it back up.
Scene scene_of(std::vector<Mesh> meshes) {
  Scene scene;
  scene.materials = {diffuse(0.8f), metal(glm::vec3(1.0f))};
  scene.meshes = std::move(meshes);
  scene.lights = {sun({0.0, -1.0, 0.0}, 1.0f)};
  return scene;
}

const std::vector<LightRay> kDown{{.origin = {0.1, 5.0, 0.2}, .direction = {0.0, -1.0, 0.0}}};

}  // namespace

TEST_CASE("lit receivers: light that lands where its light shines needs no map of the farthest") {
  Scene scene = scene_of({floor(10.0, 0.0, 0), box({-1, 0.5, -1}, {1, 0.8, 1}, 1)});
  scene.materials[1] = glass(1.5f);
  const LitReceivers found = lit(scene, kDown);
  CHECK(found.hidden.empty());
  CHECK(found.behind == LitFromBehind::No);
}

TEST_CASE("lit receivers: a thin ceiling that a mirror lights from below is in the nearest receivers' map") {
  // Its light passes the ceiling on its way down: what stands before casters is left out.
  const LitReceivers found = lit(scene_of({floor(10.0, 3.0, 0), box({-1, 0.5, -1}, {1, 0.8, 1}, 1)}), kDown);
  CHECK(found.behind == LitFromBehind::InNearest);
  CHECK(found.hidden.empty());
}

TEST_CASE("lit receivers: of a thick ceiling the side that faces away is looked for, and no other mesh") {
  // Beside the light's way: what it passes on its way to the casters is left out of maps.
  Scene scene =
      scene_of({floor(10.0, 0.0, 0), box({-1, 0.5, -1}, {1, 0.8, 1}, 1), box({1, 3.0, -5}, {5, 3.5, 5}, 0)});
  scene.lights = {sun({0.6, -0.8, 0.0}, 1.0f)};
  const LitReceivers found = lit(scene, {{.origin = {-3.0, 4.8, 0.2}, .direction = {0.6, -0.8, 0.0}}});
  CHECK(found.behind == LitFromBehind::InNearest);
  CHECK(found.hidden == std::vector<bool>{false, false, true});
  CHECK(found.hidden_sides == OutwardSides::Away);
}

TEST_CASE("lit receivers: what is lit from both sides has the light from behind in the farthest's map") {
  // A sheet at 3 m: half of the light comes from below, the rest passes a glass plate above it.
  Scene scene =
      scene_of({floor(10.0, 3.0, 0), box({-1, 0.5, -1}, {1, 0.8, 1}, 1), box({-1, 4.0, -1}, {1, 4.2, 1}, 2)});
  scene.materials.push_back(glass(1.5f));
  std::vector<LightRay> rays = kDown;
  rays.push_back({.origin = {0.1, 2.5, 0.2}, .direction = {0.0, -1.0, 0.0}});
  const LitReceivers found = lit(scene, rays);
  CHECK(found.behind == LitFromBehind::InFarthest);
  REQUIRE(found.hidden.size() == 3);
  CHECK(found.hidden[0]);
}

TEST_CASE("ray tables: a point is in the bodies that it leaves on its way up, the innermost first") {
  Scene scene = scene_of({floor(10.0, 0.0, 0), box({-3, 0.5, -3}, {3, 4.0, 3}, 1),
                          box({-1, 1.0, -1}, {1, 2.0, 1}, 2), box({-1, 2.5, -1}, {1, 3.0, 1}, 3)});
  scene.materials[1] = glass(1.33f);
  scene.materials.push_back(glass(1.5f));
  scene.materials.push_back(metal(glm::vec3(1.0f)));
  const RayTables tables(scene, effects_of(scene, Settings{}), pilot().device);
  const auto row = [&](int mesh) { return static_cast<float>(tables.material_row(mesh) + 1); };
  CHECK(tables.bodies_around({0, 1.5, 0}) == glm::vec4(row(2), row(1), 0.0f, 0.0f));
  CHECK(tables.bodies_around({2, 1.5, 0}) == glm::vec4(row(1), 0.0f, 0.0f, 0.0f));
  CHECK(tables.bodies_around({0, 2.2, 0}) == glm::vec4(row(1), 0.0f, 0.0f, 0.0f));
  CHECK(tables.bodies_around({0, 0.2, 0}) == glm::vec4(0.0f));
  CHECK(tables.bodies_around({0, 5.0, 0}) == glm::vec4(0.0f));
}
