#include "pipeline/effects/ray_tables.hpp"

#include "pipeline/settings/settings.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/pilot.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

TEST_CASE("ray tables: a mesh that shines has its points there while it is neither ball nor rectangle") {
  Scene scene = sphere_scene(1.5f, 2);
  Light lamp;
  lamp.shape = LightShape::Mesh;
  lamp.emitter = 0;
  lamp.radius = 1.0;
  scene.sources = {Light{}, lamp};
  RayTables tables(scene, effects_of(scene, Settings{}), pilot().device);
  CHECK(tables.first_point(1) == -1);
  // Something has come into the ball.
  scene.sources[1].radius = 0.0;
  tables.renew();
  CHECK(tables.first_point(0) == -1);
  CHECK(tables.first_point(1) > 0);
  scene.sources[1].radius = 1.0;
  tables.renew();
  CHECK(tables.first_point(1) == -1);
}
