#include "passes/view_range/view_range.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/hazy_room.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A camera 10 m up looks straight down through the haze below 4 m, at a surface at this height.
glm::vec4 range_down_to(float height) {
  const Scene scene = hazy_room();
  const View view = down(1.0, 10.0, 20.0);
  const Pass pass = view_range_pass();
  const float depth = 10.0f - height;
  const PassImages out =
      run_pass(definition_of(pass),
               {.uniforms = pass.uniforms({.scene = &scene, .camera = &view, .width = 1, .height = 1}),
                .textures = {filled(1, 1, {0.0f, height, 0.0f, 1.0f}),
                             filled(1, 1, {0.0f, 1.0f, 0.0f, depth}), Image{}}});
  return texel(out["view_range"], 0, 0);
}

}  // namespace

TEST_CASE("view_range: a ray is in the haze from the plane where it enters to the surface where it ends") {
  CHECK(range_down_to(0.0f) == glm::vec4(10.0f, 6.0f, 10.0f, 0.0f));
  CHECK(range_down_to(3.0f) == glm::vec4(7.0f, 6.0f, 7.0f, 0.0f));
}

TEST_CASE("view_range: a ray that ends before the haze has no way in it") {
  CHECK(range_down_to(5.0f) == glm::vec4(5.0f, 0.0f, 0.0f, 0.0f));
}

TEST_CASE("view_range: a steep ray leaves the haze where it leaves its side") {
  // From 10 m up and 2.5 m beside the axis outwards by 9 in 40: into the haze after 6 * 41/40 m, out of its
  // side at 4 m after 1.5 * 41/9 m, down on the floor after 10 * 41/40 m.
  for (const double side : {1.0, -1.0}) {
    const glm::dvec3 way(side * 9.0 / 41.0, -40.0 / 41.0, 0.0);
    View view = view_along({side * 2.5, 10.0, 0.0}, way);
    view.far = 20.0;
    const Scene scene = hazy_room();
    const Pass pass = view_range_pass();
    const glm::vec3 end(view.origin + way * 10.25);
    const PassImages out =
        run_pass(definition_of(pass),
                 {.uniforms = pass.uniforms({.scene = &scene, .camera = &view, .width = 1, .height = 1}),
                  .textures = {filled(1, 1, glm::vec4(end, 1.0f)), filled(1, 1, {0.0f, 1.0f, 0.0f, 10.25f}),
                               Image{}}});
    const glm::vec4 range = texel(out["view_range"], 0, 0);
    CHECK(range.y == Approx(6.15).epsilon(1e-5));
    CHECK(range.z == Approx(1.5 * 41.0 / 9.0).epsilon(1e-5));
  }
}
