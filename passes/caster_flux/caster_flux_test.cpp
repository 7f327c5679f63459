#include "passes/caster_flux/caster_flux.hpp"

#include <cmath>

#include "pipeline/scene/view.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A light straight down from 10 m on a grid of 2 x 2 vertices.
glm::vec4 flux_on(const View& view, const glm::vec3& light, const Image& vertices) {
  std140::CasterFlux u{};
  u.caster = shader_view(view);
  u.cone.axis = {0.0f, -1.0f, 0.0f};
  u.light = light;
  u.cell_area = 1.0f;
  u.grid_side = vertices.height();
  const PassImages out = run_pass(definition_of(caster_flux_pass()), {.width = 1,
                                                                      .height = 1,
                                                                      .uniforms = uniform_bytes(u),
                                                                      .textures = {vertices},
                                                                      .vertex_count = vertices.width()});
  return texel(out["caster_flux"], 0, 0);
}

}  // namespace

TEST_CASE("caster_flux: parallel light counts a cell for each covered vertex") {
  Image vertices = filled(2, 2, {0.0f, 1.0f, 0.0f, 1.0f});
  vertices.at(1, 0, 3) = 0.0f;
  CHECK(flux_on(down(4.0, 10.0, 20.0), {0.0f, -1.0f, 0.0f}, vertices) == glm::vec4(3.0f, 3.0f, 0.0f, 0.0f));
}

TEST_CASE("caster_flux: from a point, a cell has its solid angle") {
  // Vertices 8 m below the light, two straight below, two 45 degrees aside, where (1 + x^2)^(-3/2) = 1 /
  // sqrt 8.
  View view = down(2.0, 10.0, 20.0);
  view.perspective = true;
  Image vertices = filled(2, 2, {0.0f, 2.0f, 0.0f, 1.0f});
  vertices.at(1, 0, 0) = vertices.at(1, 1, 0) = 8.0f;
  const glm::vec4 sums = flux_on(view, {0.0f, 10.0f, 0.0f}, vertices);
  CHECK(sums.x == Approx(2.0 + 2.0 / std::sqrt(8.0)).epsilon(1e-6));
  CHECK(sums.y == 4.0f);
}
