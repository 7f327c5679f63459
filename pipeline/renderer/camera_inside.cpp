#include "pipeline/renderer/camera_inside.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/scene/exact.hpp"
#include "pipeline/scene/triangle_tree.hpp"
#include "pipeline/settings/settings.hpp"
#include "pipeline/views/framing.hpp"

namespace caustics {

namespace {

// The camera stands this share of the way to the wall, farther away than so many of the subject's radii, and
// sees at most this wide, radians.
constexpr double kBeforeWall = 0.9, kLeastRadii = 1.1, kWidestFov = 1.4;

// The walls' triangles that a camera shows which lies far off in this direction.
Scene walls_seen_from(const glm::dvec3& direction, const Scene& scene, const std::vector<bool>& around) {
  Scene seen;
  seen.meshes.resize(1);
  Mesh& walls = seen.meshes.front();
  for (std::size_t m = 0; m < around.size(); ++m) {
    const Mesh& mesh = scene.meshes[m];
    const Material& material = scene.materials[static_cast<std::size_t>(mesh.material)];
    if (!around[m] || material.alpha_mode != AlphaMode::Opaque) continue;
    const bool both_sides = material.double_sided || mesh.inside_out;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      const TriangleId triangle{static_cast<int>(m), static_cast<int>(i / 3)};
      if (!both_sides && !(exact::dot(plane_normal(scene, triangle), direction) > 0.0)) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        walls.indices.push_back(static_cast<std::uint32_t>(walls.vertices.size()));
        walls.vertices.push_back(mesh.vertices[mesh.indices[i + k]]);
      }
    }
  }
  return seen;
}

}  // namespace

bool come_inside(Camera& camera, const Scene& scene, const std::vector<bool>& around, const Bounds& subject,
                 const Settings& settings) {
  const glm::dvec3 middle = subject.centre(), way = camera.position - middle;
  const double whole = exact::length(way), radius = subject.radius();
  const Scene walls = walls_seen_from(way, scene, around);
  const auto wall = TriangleTree(walls, {0}).nearest(middle, way / whole);
  if (!wall || wall->distance > whole) return false;
  const double away = kBeforeWall * wall->distance;
  if (away < kLeastRadii * radius) return false;
  camera.position = middle + way * (away / whole);
  camera.near *= away / whole;
  if (settings.fov) return true;
  const double aspect = std::min(1.0, static_cast<double>(settings.width) / settings.height);
  const double slope = radius / std::sqrt(away * away - radius * radius) / (1.0 - kFramingMargin) / aspect;
  camera.vertical_fov = std::clamp(2.0 * exact::arctangent(slope), camera.vertical_fov, kWidestFov);
  return true;
}

}  // namespace caustics
