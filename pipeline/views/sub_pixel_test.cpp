#include "pipeline/views/sub_pixel.hpp"

#include <set>

#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

// A picture of 8 by 4 pixels, each a half wide and a quarter high.
View view_of_pixels() {
  View view;
  view.window_lower = {-2.0, -0.5};
  view.window_upper = {2.0, 0.5};
  return view;
}

}  // namespace

TEST_CASE("sub-pixel: a shifted view has at a pixel's middle what lies beside it, and is as large") {
  const View moved = shifted(view_of_pixels(), {8, -4}, 8, 4);
  CHECK(moved.window_lower == glm::dvec2(-1.75, -0.5625));
  CHECK(moved.window_upper == glm::dvec2(2.25, 0.4375));
}

TEST_CASE("sub-pixel: samples share no row and no column, and lie within their pixel") {
  for (const int samples : {4, 8, 16}) {
    std::set<int> columns, rows;
    for (const SubPixel& at : sub_pixels(samples)) {
      CHECK((at.x >= -8 && at.x < 8 && at.y >= -8 && at.y < 8));
      columns.insert(at.x);
      rows.insert(at.y);
    }
    CHECK(columns.size() == static_cast<std::size_t>(samples));
    CHECK(rows.size() == static_cast<std::size_t>(samples));
  }
  CHECK(sub_pixels(1).size() == 1);
}

TEST_CASE(
    "sub-pixel: what samples may see beyond the picture is a pixel wide, and nothing where there is one") {
  const View around = around_samples(view_of_pixels(), 4, 8, 4);
  CHECK(around.window_lower == glm::dvec2(-2.5, -0.75));
  CHECK(around.window_upper == glm::dvec2(2.5, 0.75));
  CHECK(around_samples(view_of_pixels(), 1, 8, 4).window_upper == glm::dvec2(2.0, 0.5));
}
