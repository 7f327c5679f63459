#include "pipeline/views/framing.hpp"

#include <cmath>

#include "tests/support/catch.hpp"

using namespace caustics;

TEST_CASE("framing: a square seen straight on fills the picture's height but for the margin") {
  const std::vector<glm::dvec3> square = {{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}};
  // tan(fov / 2) = 1/2: from distance d the picture's half height is d / 2.
  const Camera camera = framing_camera(square, {0, 0, -1}, 2.0 * std::atan(0.5), 2.0, 0.1);
  CHECK(camera.position.x == Approx(0).margin(1e-12));
  CHECK(camera.position.y == Approx(0).margin(1e-12));
  CHECK(camera.position.z == Approx(2.0 / (1.0 - kFramingMargin)));
}

TEST_CASE("framing: the camera stands where the width asks for more than the height") {
  const std::vector<glm::dvec3> bar = {{-3, 0, 0}, {5, 0, 0}};
  const Camera camera = framing_camera(bar, {0, 0, -1}, 2.0 * std::atan(0.5), 2.0, 0.1);
  CHECK(camera.position.x == Approx(1.0));
  CHECK(camera.position.z == Approx(4.0 / (1.0 - kFramingMargin)));
}

TEST_CASE("framing: one point, and none, are seen from a distance of the least extent's") {
  for (const std::vector<glm::dvec3>& points :
       {std::vector<glm::dvec3>{{0, 0, 0}}, std::vector<glm::dvec3>{}}) {
    const Camera camera = framing_camera(points, {0, 0, -1}, 2.0 * std::atan(0.5), 1.0, 0.2);
    CHECK(camera.position.z == Approx(0.2 / (1.0 - kFramingMargin)));
  }
}

TEST_CASE("framing: the near plane lies before every point, at a hundredth of the nearest one's distance") {
  const std::vector<glm::dvec3> points = {{0, 0, 3}, {1, 0, -2}, {-1, 2, -40}};
  for (const double fov : {0.3, 0.8, 1.5}) {
    const Camera camera = framing_camera(points, {0, 0, -1}, fov, 1.5, 0.1);
    CHECK(camera.near == Approx(0.01 * (camera.position.z - 3.0)));
  }
}

TEST_CASE("framing: zoom makes the middle of the picture larger, the field of view is set in degrees") {
  Camera camera;
  camera.half_width = 2.0;
  camera.half_height = 3.0;
  const Camera closer = with_lens(camera, 90.0f, 2.0f);
  CHECK(std::tan(0.5 * closer.vertical_fov) == Approx(0.5));
  CHECK(closer.half_width == 1.0);
  CHECK(closer.half_height == 1.5);
  CHECK(with_lens(camera, {}, 1.0f).vertical_fov == camera.vertical_fov);
}
