#include "pipeline/scene/cube_atlas.hpp"

#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/cube_map.hpp"

using namespace caustics;
using namespace caustics::test;

TEST_CASE("cube_atlas: every direction has one face, and is at most 45 degrees from its axis") {
  for (int x = -3; x <= 3; ++x)
    for (int y = -3; y <= 3; ++y)
      for (int z = -3; z <= 3; ++z) {
        if (x == 0 && y == 0 && z == 0) continue;
        const glm::dvec3 q(x, y, z);
        const glm::dvec3 t = turned_to_face(q, face_of(q));
        CHECK(t.z > 0.0);
        CHECK(std::max(std::fabs(t.x), std::fabs(t.y)) <= t.z);
      }
}

TEST_CASE("cube_atlas: of equal components z wins over x, and x over y") {
  CHECK(face_of({1.0, 1.0, 1.0}) == 4);
  CHECK(face_of({1.0, 1.0, -1.0}) == 5);
  CHECK(face_of({1.0, 1.0, 0.0}) == 0);
  CHECK(face_of({-1.0, -1.0, 0.5}) == 1);
  CHECK(face_of({0.0, 2.0, 1.0}) == 2);
  CHECK(face_of({0.0, -2.0, 1.0}) == 3);
}

TEST_CASE("cube_atlas: every turn is a rotation, which keeps front faces in front") {
  for (int face = 0; face < 6; ++face) {
    const glm::dvec3 a = turned_to_face({1, 0, 0}, face), b = turned_to_face({0, 1, 0}, face),
                     c = turned_to_face({0, 0, 1}, face);
    CHECK(glm::dot(glm::cross(a, b), c) == 1.0);
  }
}

TEST_CASE("cube_atlas: the texels of the faces' own cover the whole sphere") {
  // Solid angle of a texel by the midpoint form, whose error is 6e-5 in all at 64 texels a face.
  const CubeAtlas atlas{.side = 300, .guard = 5};
  double sum = 0.0;
  for (int y = atlas.guard; y < atlas.tile_height() - atlas.guard; ++y)
    for (int x = atlas.guard; x < atlas.tile_width() - atlas.guard; ++x) {
      const double squared = glm::dot(direction_of(atlas, 0, x, y), direction_of(atlas, 0, x, y));
      sum += 6.0 * atlas.texel_area() / (squared * std::sqrt(squared));
    }
  CHECK(sum == Approx(4.0 * 3.14159265358979).epsilon(1e-4));
}
