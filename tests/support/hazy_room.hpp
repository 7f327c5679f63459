// Haze 4 m high, for tests of the passes that draw a medium.
#pragma once
#include "tests/support/run_pass.hpp"
#include "tests/support/shapes.hpp"

namespace caustics::test {

// Between levels at heights 0 and 4; of what passes a metre 0.1 is scattered and 0.05 absorbed.
inline Scene hazy_room() {
  Scene scene;
  scene.materials = {diffuse(0.8f)};
  scene.meshes = {floor(4.0, 0.0, 0), floor(4.0, 4.0, 0)};
  scene.lights = {sun({0.0, -1.0, 0.0}, 2.0f)};
  scene.medium.scattering = glm::vec3(0.1f);
  scene.medium.absorption = glm::vec3(0.05f);
  return scene;
}
inline constexpr double kHaze = 0.15, kHeight = 4.0;

}  // namespace caustics::test
