#include "passes/ambient_occlusion/ambient_occlusion.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// Texel (x, y) shows the point (x, height, -y) of a level floor.
Image floor_points(int side, float share) {
  Image image(Format::RGBA32F, side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      image.at(x, y, 0) = static_cast<float>(x);
      image.at(x, y, 2) = -static_cast<float>(y);
      image.at(x, y, 3) = 1.0f + share;
    }
  return image;
}

Image smoothed(const Image& rays) {
  return run_pass(definition_of(ambient_occlusion_pass()),
                  {.width = rays.width(),
                   .height = rays.height(),
                   .textures = {rays, filled(4 * rays.width(), 4 * rays.height(),
                                             {0.0f, 1.0f, 0.0f, 1.0f})}})["ambient_occlusion"];
}

}  // namespace

TEST_CASE("ambient_occlusion: a texel is the mean over 4 x 4 of its surface, and keeps its point") {
  Image rays = floor_points(8, 0.5f);
  rays.at(3, 3, 3) = 1.0f;  // closed
  const Image out = smoothed(rays);
  // From two texels before to one behind, but within the picture: columns 0 to 3 of the first three.
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      const bool near = x <= 5 && y <= 5;
      CHECK(out.at(x, y, 3) == Approx(1.0 + 0.5 * (near ? 15.0 / 16.0 : 1.0)).epsilon(1e-6));
    }
  CHECK(texel(out, 4, 2) == glm::vec4(4.0f, 0.0f, -2.0f, out.at(4, 2, 3)));
}

TEST_CASE("ambient_occlusion: what lies over the surface's plane hardly counts") {
  Image rays = floor_points(8, 1.0f);
  for (int y = 0; y < 8; ++y)
    for (int x = 4; x < 8; ++x) {
      rays.at(x, y, 1) = 3.0f;  // a table
      rays.at(x, y, 3) = 1.25f;
    }
  const Image out = smoothed(rays);
  CHECK(out.at(3, 4, 3) == Approx(2.0).epsilon(1e-3));
  CHECK(out.at(4, 4, 3) == Approx(1.25).epsilon(1e-3));
}

TEST_CASE("ambient_occlusion: texels without a surface stay empty and do not count") {
  Image rays = floor_points(4, 0.5f);
  for (int c = 0; c < 4; ++c) rays.at(1, 1, c) = 0.0f;
  const Image out = smoothed(rays);
  CHECK(texel(out, 1, 1) == glm::vec4(0.0f));
  CHECK(out.at(2, 2, 3) == Approx(1.5).epsilon(1e-6));
}
