// Smooth-shaded meshes of few triangles: their shadows end where their normals say.
#include <algorithm>
#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/run_pass.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A diffuse ball of radius 0.5 m seen from above over 2 x 2 m, the light from the side, 10 degrees above the
// horizon.
Scene ball_lit_from_the_side(int levels) {
  Scene scene;
  scene.materials = {diffuse(0.8f)};
  scene.meshes = {sphere({0.0, 0.0, 0.0}, 0.5, levels, 0)};
  scene.lights = {sun({-std::cos(0.1745), -std::sin(0.1745), 0.0}, 100.0f)};
  scene.cameras = {camera_down(2.0, 1.0)};
  return scene;
}

// By how much the ball's irradiance is at most away from the cosine's.
double worst_against_cosine(const Scene& scene) {
  const Rendering r = render(scene, small_settings(16, 16, 96), {"aov_direct", "aov_normal", "aov_position"});
  double worst = 0.0;
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 96; ++x) {
      if (r["aov_position"].at(x, y, 3) == 0.0f) continue;
      const glm::dvec3 normal(texel(r["aov_normal"], x, y));
      const double expected = 100.0 * std::max(-glm::dot(normal, scene.lights[0].direction), 0.0);
      worst = std::max(worst, std::fabs(r["aov_direct"].at(x, y, 0) - expected));
    }
  return worst;
}

}  // namespace

TEST_CASE("smooth shading: no triangle of a coarse ball shadows what its normals turn to the light") {
  CHECK(worst_against_cosine(ball_lit_from_the_side(1)) < 1e-3);  // 80 triangles
  CHECK(worst_against_cosine(ball_lit_from_the_side(3)) < 1e-3);
}

TEST_CASE("smooth shading: what is flat ends its shadow by its triangles") {
  Scene scene = ball_lit_from_the_side(1);
  Mesh& ball = scene.meshes[0];
  Mesh flat = ball;
  flat.vertices.clear();
  for (std::size_t i = 0; i < ball.indices.size(); i += 3) {
    Vertex corners[3];
    for (std::size_t k = 0; k < 3; ++k) corners[k] = ball.vertices[ball.indices[i + k]];
    const glm::vec3 normal = glm::normalize(
        glm::cross(corners[1].position - corners[0].position, corners[2].position - corners[0].position));
    for (Vertex& v : corners) {
      v.normal = normal;
      flat.vertices.push_back(v);
    }
  }
  for (std::size_t i = 0; i < flat.vertices.size(); ++i) flat.indices[i] = static_cast<std::uint32_t>(i);
  scene.meshes = {flat};
  CHECK_FALSE(effects_of(scene, Settings{}).smooth_shading.active);
  CHECK(worst_against_cosine(scene) < 1e-3);
}
