#include "pipeline/scene/visibility.hpp"

#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

Bounds cube_at(const glm::dvec3& centre, double half) {
  return {centre - glm::dvec3(half), centre + glm::dvec3(half)};
}

// From the origin along -z, 45 degrees to each side, from 1 m to 10 m.
View camera() {
  View view;
  view.perspective = true;
  view.near = 1.0;
  view.far = 10.0;
  return view;
}

}  // namespace

TEST_CASE("visibility: a box is seen unless it lies wholly beyond one of the view's planes") {
  CHECK(may_see(camera(), cube_at({0, 0, -5}, 1)));
  CHECK(may_see(camera(), cube_at({0, 0, 0}, 20)));             // the camera stands in it
  CHECK_FALSE(may_see(camera(), cube_at({0, 0, 5}, 1)));        // behind
  CHECK_FALSE(may_see(camera(), cube_at({0, 0, -12}, 1)));      // too far
  CHECK_FALSE(may_see(camera(), cube_at({0, 0, -0.5}, 0.25)));  // too near
  // The left plane is x = z: at z = -5 the corner nearest to it lies at x = -6.9 + 1 < -6, its own z.
  CHECK_FALSE(may_see(camera(), cube_at({-7.1, 0, -5}, 1)));
  CHECK(may_see(camera(), cube_at({-6.9, 0, -5}, 1)));
  CHECK_FALSE(may_see(camera(), cube_at({0, 7.1, -5}, 1)));
  CHECK(may_see(camera(), cube_at({0, 6.9, -5}, 1)));
}

TEST_CASE("visibility: nothing is seen of nothing") { CHECK_FALSE(may_see(camera(), Bounds{})); }

TEST_CASE("visibility: a light's view is seen where its column passes through the camera's") {
  View light = view_along({0, 10, -5}, {0, -1, 0});
  light.near = 0.0;
  light.far = 20.0;
  CHECK(may_see(camera(), light));
  light.origin.z = 5;
  CHECK_FALSE(may_see(camera(), light));
  // A cone from behind the camera that opens towards it: 8 m wide each way where the camera looks.
  light.perspective = true;
  light.near = 1.0;
  light.window_lower = glm::dvec2(-0.8);
  light.window_upper = glm::dvec2(0.8);
  CHECK(may_see(camera(), light));
}

TEST_CASE("visibility: a parallel light's column is as wide where it ends as its window") {
  // Straight down 5 m before the camera, 2 m wide and from 4 to 6 m away: the camera's right plane is x = z.
  for (const double x : {6.8, 7.2}) {
    View light = view_along({x, 10, -5}, {0, -1, 0});
    light.far = 20.0;
    CHECK(may_see(camera(), light) == (x < 7.0));
  }
}
