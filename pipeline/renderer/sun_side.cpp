#include "pipeline/renderer/sun_side.hpp"

#include <algorithm>
#include <vector>

#include "pipeline/renderer/landed_light.hpp"
#include "pipeline/scene/defaults.hpp"
#include "pipeline/scene/exact.hpp"
#include "pipeline/scene/triangle_tree.hpp"

namespace caustics {

namespace {

// Fronts are bright enough when so much of them is lit, or so much of those that catch most of the casters'
// light: a backdrop is not to darken itself; and a surface is lit where the sun's light meets it less flatly
// than this cosine.
constexpr double kLitFronts = 0.4, kLitCatchers = 0.9, kLeastCosine = 0.15;
constexpr std::size_t kTriangles = 2000;  // that are looked at, about
constexpr int kStep = 2;                  // a quarter of the rays tells shares well enough

// Light that travels towards the camera, to its right and down.
struct Way {
  double onward, right, down;
  const char* where;
};
constexpr Way kWays[] = {
    {0.4, 0.3, 0.86602540378443865, "behind"},  // 60 degrees high
    {0.0, 0.70710678118654752, 0.70710678118654752, "beside"},
    {-0.5, 0.5, 0.70710678118654752, "before"},
};

// Without an added ground.
std::vector<int> opaque_meshes(const Scene& scene) {
  std::vector<int> meshes;
  for (std::size_t m = 0; m < scene.meshes.size(); ++m)
    if (is_receiver(scene.materials[static_cast<std::size_t>(scene.meshes[m].material)]) &&
        scene.meshes[m].name != kGroundName)
      meshes.push_back(static_cast<int>(m));
  return meshes;
}

// Do the scene's own surfaces catch most of the casters' light?
bool catches_light(const Scene& scene, LandedLight& landed) {
  double all = 0.0, caught = 0.0;
  for (const Landed& each : landed.find(kStep)) {
    all += each.share;
    if (scene.meshes[static_cast<std::size_t>(each.mesh)].name != kGroundName) caught += each.share;
  }
  return caught > 0.5 * all;
}

// The share of the casters' landed light that no receiver hides from the camera; 1 where none lands at all.
double shown_share(const Scene& scene, LandedLight& landed, const TriangleTree& receivers,
                   const glm::dvec3& toward_camera) {
  const double up = 1e-4 * widest(subject_of(scene));
  double all = 0.0, shown = 0.0;
  for (const Landed& each : landed.find(kStep)) {
    all += each.share;
    if (!receivers.nearest(each.position + toward_camera * up, toward_camera)) shown += each.share;
  }
  return all > 0.0 ? shown / all : 1.0;
}

// Of the meshes' surfaces that turn to the camera, as large as it sees them: what share the sun shines on; 1
// where there are none.
double lit_share(const Scene& scene, const std::vector<int>& meshes, const TriangleTree& tree,
                 const glm::dvec3& toward_camera, const glm::dvec3& direction) {
  std::size_t triangles = 0, number = 0;
  for (const int m : meshes) triangles += scene.meshes[static_cast<std::size_t>(m)].indices.size() / 3;
  const std::size_t step = triangles / kTriangles + 1;
  double all = 0.0, lit = 0.0;
  for (const int m : meshes) {
    const Mesh& mesh = scene.meshes[static_cast<std::size_t>(m)];
    for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) {
      if (number++ % step != 0) continue;
      const auto corner = [&](std::size_t k) {
        return glm::dvec3(mesh.vertices[mesh.indices[3 * t + k]].position);
      };
      const glm::dvec3 a = corner(0), b = corner(1), c = corner(2), n = exact::cross(b - a, c - a);
      const double seen = exact::dot(n, toward_camera), cosine = -exact::dot(n, direction);
      if (!(seen > 0.0)) continue;
      all += seen;
      const bool shines = cosine > kLeastCosine * exact::length(n) &&
                          !tree.nearest((a + b + c) / 3.0, -direction, {m, static_cast<int>(t)});
      if (shines) lit += seen;
    }
  }
  return all > 0.0 ? lit / all : 1.0;
}

}  // namespace

SunSide sun_side(Scene& scene, LandedLight& landed, const glm::dvec3& toward_camera,
                 const glm::dvec3& front) {
  const glm::dvec3 right{front.z, 0.0, -front.x};
  const auto side_of = [&](const Way& way) {
    return SunSide{front * way.onward + right * way.right - glm::dvec3(0.0, way.down, 0.0), way.where};
  };
  const auto turn_to = [&](const SunSide& side) {
    set_sun(scene, side.direction, scene.lights.front().intensity);
  };
  SunSide best = side_of(kWays[0]);
  const std::vector<int> own = opaque_meshes(scene);
  if (own.empty()) return best;
  const TriangleTree tree(scene, own);
  const double behind = lit_share(scene, own, tree, toward_camera, best.direction);
  if (behind >= kLitCatchers) return best;
  turn_to(best);
  const double enough = catches_light(scene, landed) ? kLitCatchers : kLitFronts;
  if (behind >= enough) return best;
  double most = 0.0;
  for (const Way& way : kWays) {
    const SunSide side = side_of(way);
    turn_to(side);
    const double lit = lit_share(scene, own, tree, toward_camera, side.direction);
    const double worth = std::min(lit, enough) * shown_share(scene, landed, tree, toward_camera);
    if (!(worth > most)) continue;
    most = worth;
    best = side;
  }
  return best;
}

}  // namespace caustics
