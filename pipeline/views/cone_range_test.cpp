// Where a cone lies in a window, against tangents of angles.
#include "pipeline/views/cone_range.hpp"

#include <cmath>

#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

// Looks down -y, right along x.
View down() {
  View view;
  view.right = {1.0, 0.0, 0.0};
  view.up = {0.0, 0.0, -1.0};
  view.forward = {0.0, -1.0, 0.0};
  view.perspective = true;
  return view;
}

}  // namespace

TEST_CASE("cone range: a cone along the view reaches its half angle's tangent to both sides") {
  for (const int axis : {0, 1}) {
    const auto range = cone_range(down(), axis, {0.0, -1.0, 0.0}, 0.3);
    REQUIRE(range);
    CHECK(range->x == Approx(-std::tan(0.3)).epsilon(1e-12));
    CHECK(range->y == Approx(std::tan(0.3)).epsilon(1e-12));
  }
}

TEST_CASE("cone range: a slanted cone lies between the tangents of its angle less and plus its half angle") {
  const double slant = 0.5;
  const glm::dvec3 direction(std::sin(slant), -std::cos(slant), 0.0);
  const auto along = cone_range(down(), 0, direction, 0.2);
  REQUIRE(along);
  CHECK(along->x == Approx(std::tan(0.3)).epsilon(1e-12));
  CHECK(along->y == Approx(std::tan(0.7)).epsilon(1e-12));
  // Across the slant the cone is met nearer to its tip: wider than the tangent of 0.2.
  const auto across = cone_range(down(), 1, direction, 0.2);
  REQUIRE(across);
  CHECK(across->y == Approx(-across->x).epsilon(1e-12));
  CHECK(across->y > std::tan(0.2));
  for (int i = 0; i < 360; ++i) {  // every line on the cone's side is inside, and one touches
    const double angle = i * 3.14159265358979323846 / 180.0;
    const glm::dvec3 u(std::cos(slant), std::sin(slant), 0.0), v(0.0, 0.0, -1.0);
    const glm::dvec3 side =
        direction * std::cos(0.2) + (u * std::cos(angle) + v * std::sin(angle)) * std::sin(0.2);
    CHECK(-side.z / -side.y <= across->y + 1e-12);
    CHECK(side.x / -side.y <= along->y + 1e-12);
    CHECK(side.x / -side.y >= along->x - 1e-12);
  }
}

TEST_CASE("cone range: a half space, a cone that shines away and one past a right angle have none") {
  CHECK_FALSE(cone_range(down(), 0, {0.0, -1.0, 0.0}, 1.5707964));
  CHECK_FALSE(cone_range(down(), 0, {0.0, 1.0, 0.0}, 0.1));
  CHECK_FALSE(cone_range(down(), 0, {std::sin(1.4), -std::cos(1.4), 0.0}, 0.3));
}
