#include "pipeline/scene/view.hpp"

#include <cmath>

#include "tests/support/catch.hpp"

using namespace caustics;

TEST_CASE("frame: axes are orthonormal and right-handed for every direction of view") {
  for (int i = 0; i < 200; ++i) {
    const double a = 0.7 * i, b = 0.31 * i;
    const glm::dvec3 forward{std::cos(a) * std::cos(b), std::sin(b), std::sin(a) * std::cos(b)};
    const View f = view_along({1.0, 2.0, 3.0}, forward);
    CHECK(glm::length(f.right) == Approx(1.0));
    CHECK(glm::length(f.up) == Approx(1.0));
    CHECK(std::fabs(glm::dot(f.right, f.up)) < 1e-12);
    CHECK(glm::length(glm::cross(f.right, f.up) + f.forward) < 1e-12);  // looks along -(right x up)
  }
}

TEST_CASE("frame: from above, up is -z and right is +x, as on a map") {
  const View f = view_along({0.0, 5.0, 0.0}, {0.0, -1.0, 0.0});
  CHECK(f.right == glm::dvec3(1.0, 0.0, 0.0));
  CHECK(f.up == glm::dvec3(0.0, 0.0, -1.0));
}

TEST_CASE("frame: a camera's window has the picture's shape, and its height the camera's angle") {
  Camera camera;
  camera.vertical_fov = 2.0 * std::atan(0.5);
  const View wide = view_of(camera, 200, 100, {});
  CHECK(wide.window_upper.y == Approx(0.5));
  CHECK(wide.window_upper.x == Approx(1.0));
  camera.orthographic = true;
  camera.half_height = 1.0;
  camera.half_width = 3.0;
  // What the camera asks for is all in the picture.
  CHECK(view_of(camera, 200, 100, {}).window_upper == glm::dvec2(3.0, 1.5));
}

TEST_CASE("frame: packed uniforms map the window's corners to 0 and 1") {
  View f = view_along({0.0, 5.0, 0.0}, {0.0, -1.0, 0.0});
  f.window_lower = {-1.0, -2.0};
  f.window_upper = {3.0, 2.0};
  const std140::View u = shader_view(f);
  CHECK(-1.0f * u.scale.x + u.offset.x == Approx(0.0f).margin(1e-6));
  CHECK(3.0f * u.scale.x + u.offset.x == Approx(1.0f));
  CHECK(2.0f * u.scale.y + u.offset.y == Approx(1.0f));
}
