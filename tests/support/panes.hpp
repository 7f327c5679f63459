// A pane of glass and what it does to light, for tests of the passes that draw panes.
#pragma once
#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

namespace caustics::test {

// At normal incidence a face of index 1.5 mirrors (0.5 / 2.5)^2 = 0.04: a pane passes 0.96 / 1.04 and
// mirrors 0.08 / 1.04.
inline constexpr float kPasses = 0.96f / 1.04f, kMirrors = 0.08f / 1.04f;

inline Material pane_material() {
  Material m;
  m.base_color = {1.0f, 0.5f, 0.25f, 1.0f};
  m.metallic = 0.0f;
  m.transmission = 1.0f;
  m.ior = 1.5f;
  return m;
}

inline void check_color(const glm::vec3& found, const glm::vec3& expected) {
  for (int c = 0; c < 3; ++c) CHECK(found[c] == Approx(expected[c]).epsilon(1e-5));
}

}  // namespace caustics::test
