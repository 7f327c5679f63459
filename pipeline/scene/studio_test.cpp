#include "pipeline/scene/studio.hpp"

#include "pipeline/scene/environment.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;

TEST_CASE("studio: what a small soft box gives is its solid angle, its edges' mean and the cosine") {
  // Each edge is 1 over 0.7 of the half side and 1/2 in the mean over the rest: 0.85.
  SoftBox box{.half_width = 0.01, .half_height = 0.02};
  CHECK(upward_irradiance(box) == Approx(4.0 * 0.01 * 0.02 * 0.85 * 0.85).epsilon(2e-3));
  box.middle = {0.0, 0.5, -0.8660254};
  box.upward = {0.0, 0.8660254, 0.5};
  CHECK(upward_irradiance(box) == Approx(0.5 * 4.0 * 0.01 * 0.02 * 0.85 * 0.85).epsilon(2e-3));
}

TEST_CASE("studio: gradient and boxes together give a surface that faces up the mean") {
  const Environment sky = studio(3.0);
  double boxes = 0.0;
  for (const SoftBox& box : sky.boxes) boxes += double(box.radiance) * upward_irradiance(box);
  CHECK((double(sky.horizon.x) + 2.0 * double(sky.zenith.x)) / 3.0 + boxes / 3.14159265358979 == Approx(3.0));
  CHECK(boxes / 3.14159265358979 == Approx(sky.boxes_mean));
}

TEST_CASE(
    "studio: soft boxes turn with the environment, anticlockwise from above, and grow with its strength") {
  Environment sky = studio(1.0);
  const SoftBox before = sky.boxes[0];
  adjust(sky, 2.0, 90.0);
  const SoftBox& after = sky.boxes[0];
  CHECK(after.radiance == 2.0f * before.radiance);
  CHECK(after.middle.x == Approx(before.middle.z));
  CHECK(after.middle.y == before.middle.y);
  CHECK(after.middle.z == Approx(-before.middle.x));
}
