#include "pipeline/measure/leaning_normals.hpp"

#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/shapes.hpp"

using namespace caustics;
using namespace caustics::test;

TEST_CASE("leaning normals: none on flat sides, half the angle of the edges where a cube is shaded smooth") {
  Mesh cube = box({-1, -1, -1}, {1, 1, 1}, 0);
  CHECK(mean_lean(cube) == Approx(0.0).margin(1e-6));
  // Each corner's normal is its diagonal: cos = 1 / sqrt 3.
  for (Vertex& v : cube.vertices) v.normal = v.position / std::sqrt(3.0f);
  CHECK(mean_lean(cube) == Approx(std::acos(1.0 / std::sqrt(3.0))).epsilon(1e-6));
}

TEST_CASE("leaning normals: little on a finely tessellated sphere, and nothing is said of no triangle") {
  CHECK(mean_lean(sphere({0, 0, 0}, 1.0, 4, 0)) < 0.05);
  CHECK(mean_lean(Mesh{}) == 0.0);
}
