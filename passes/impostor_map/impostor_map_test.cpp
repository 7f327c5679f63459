#include "passes/impostor_map/impostor_map.hpp"

#include <cmath>

#include "passes/receiver_map/receiver_map.hpp"
#include "pipeline/scene/cube_view.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/cube_map.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/run_pass.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A floor 1 m below the middle, much wider than a face sees, drawn into one face.
PassImages draw(int face) {
  View view = with_atlas(cube_view({0.0, 1.0, 0.0}, {1.0, 100.0}), 48);
  view.face = face;
  const glm::vec3 corners[4] = {{-50, 0, 50}, {50, 0, 50}, {50, 0, -50}, {-50, 0, -50}};
  return run_pass(definition_of(impostor_map_pass()),
                  {.width = 48,
                   .height = 48,
                   .uniforms = uniform_bytes(receiver_map_uniforms(view, Material{})),
                   .textures = {Image{}},
                   .mesh = quad(corners, {0.0f, 1.0f, 0.0f})});
}

}  // namespace

TEST_CASE("impostor_map: a face draws its own tile and nothing beside it") {
  // Tiles of 16 x 24 texels; face 3 looks along -y and lies at column 0, row 1. There every texel sees the
  // floor.
  const Image map = draw(3)["impostor_position"];
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 48; ++x) CHECK((map.at(x, y, 3) != 0.0f) == (x < 16 && y >= 24));
  // Face 0 looks along +x: the floor fills the half of its tile that looks down, and not its very edge.
  const Image side = draw(0)["impostor_position"];
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 48; ++x) CHECK((side.at(x, y, 3) != 0.0f) == (x < 16 && y < 12));
}

TEST_CASE("impostor_map: a texel holds the floor's point in its direction, and its distance") {
  const Image map = draw(3)["impostor_position"];
  const CubeAtlas atlas{.side = 48, .guard = kLeastGuard};
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 16; ++x) {
      // View axes: right +x, up +y, forward -z.
      const glm::dvec3 q = direction_of(atlas, 3, x, y);
      const glm::vec4 p = texel(map, x, 24 + y);
      CHECK(p.x == Approx(q.x).margin(1e-4));
      CHECK(p.y == Approx(0.0).margin(1e-4));
      CHECK(p.z == Approx(-q.z).margin(1e-4));
      CHECK(p.w == Approx(glm::length(q)).epsilon(1e-4));
    }
}

TEST_CASE("impostor_map: a room is seen all around the casters, and only the estimator asks for it") {
  Scene scene = sphere_scene(1.5f, 2);
  scene.meshes.push_back(box({-2.0, -1.0, -2.0}, {2.0, 3.0, 2.0}, 0));
  Settings settings = small_settings(48, 96, 16);
  settings.estimator = Estimator::Impostor;
  const Image map = render(scene, settings, {"impostor_position", kLanding})["impostor_position"];
  const CubeAtlas atlas{.side = 96, .guard = kLeastGuard};
  for (int face = 0; face < 6; ++face)
    for (int y = 0; y < atlas.tile_height(); ++y)
      for (int x = 0; x < atlas.tile_width(); ++x) {
        const glm::vec4 p = texel(map, face % 3 * atlas.tile_width() + x, face / 3 * atlas.tile_height() + y);
        const glm::dvec3 q = direction_of(atlas, face, x, y);
        const glm::dvec3 d{q.x, q.y, -q.z};
        // The floor of the scene, within 3 m, lies before that of the box.
        double t = 1e30;
        for (const auto& [axis, lower, upper] :
             {std::tuple{0, -2.0, 2.0}, std::tuple{1, -1.8, 2.2}, std::tuple{2, -2.0, 2.0}})
          t = std::min(t, d[axis] == 0.0 ? 1e30 : (d[axis] > 0.0 ? upper : lower) / d[axis]);
        if (d.y < 0.0 && -0.8 / d.y < t) t = -0.8 / d.y;
        CHECK(double(p.w) == Approx(t * glm::length(d)).epsilon(1e-4));
      }
  settings.estimator = Estimator::Secant;
  const Effects effects = effects_of(scene, settings);
  for (const PlannedPass& pass : make_plan(scene, effects, settings, pass_registry(), {}).passes)
    CHECK(pass.label != "impostor_map");
}
