// A square of glass seen by a light or the camera, for tests of the passes that draw casters.
#pragma once
#include "tests/support/run_pass.hpp"

namespace caustics::test {

// A square of 1 m at height 1. Seen from above, the corners in this order wind counter-clockwise: the front.
inline constexpr glm::vec3 kFront[4] = {{-0.5, 1, 0.5}, {0.5, 1, 0.5}, {0.5, 1, -0.5}, {-0.5, 1, -0.5}};
inline constexpr glm::vec3 kBack[4] = {{-0.5, 1, -0.5}, {0.5, 1, -0.5}, {0.5, 1, 0.5}, {-0.5, 1, 0.5}};

// By a light straight down on a window of 2 m, 8 x 8 texels; the material's row is 3.
inline PassImages seen_by_light(const Pass& pass, const glm::vec3 (&corners)[4]) {
  LightViews views;
  views.caster = down(1.0, 4.0, 8.0);
  const Effects effects;
  return run_pass(definition_of(pass),
                  {.width = 8,
                   .height = 8,
                   .uniforms = pass.uniforms(
                       {.effects = &effects, .views = &views, .material_row = 3, .width = 8, .height = 8}),
                   .mesh = quad(corners, {0.0f, 2.0f, 0.0f})});
}

// By a camera straight down on a window of 2 m, 4 x 4 pixels.
inline PassImages seen_by_camera(const Pass& pass, const MeshData& mesh) {
  const View view = down(1.0, 10.0, 20.0);
  const Effects effects;
  return run_pass(definition_of(pass, {}, kCamera),
                  {.width = 4,
                   .height = 4,
                   .uniforms = pass.uniforms({.effects = &effects, .camera = &view, .material_row = 3}),
                   .mesh = mesh});
}

}  // namespace caustics::test
