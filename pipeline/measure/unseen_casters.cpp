#include "pipeline/measure/unseen_casters.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "pipeline/scene/exact.hpp"

namespace caustics {

namespace {

constexpr int kWaysToCasters = 1024;

struct CasterPlace {
  glm::dvec3 position{0.0}, normal{0.0};  // of its triangle
};

// All triangles of the casters, drawn by area.
class CasterAreas {
 public:
  CasterAreas(const Scene& scene, const std::set<int>& casters) : scene_(scene) {
    for (const int mesh : casters) {
      const std::size_t count = scene.meshes[static_cast<std::size_t>(mesh)].indices.size() / 3;
      for (std::size_t t = 0; t < count; ++t) {
        const TriangleId id{mesh, static_cast<int>(t)};
        const double area = 0.5 * exact::length(exact::cross(edge(id, 1), edge(id, 2)));
        if (!(area > 0.0)) continue;
        ids_.push_back(id);
        sums_.push_back((sums_.empty() ? 0.0 : sums_.back()) + area);
      }
    }
  }

  bool empty() const { return ids_.empty(); }

  // `along`, u and v: 0..1.
  CasterPlace place(double along, double u, double v) const {
    const auto found = std::upper_bound(sums_.begin(), sums_.end(), along * sums_.back());
    const auto last = static_cast<std::ptrdiff_t>(ids_.size()) - 1;
    const TriangleId& id = ids_[static_cast<std::size_t>(std::min(found - sums_.begin(), last))];
    const double root = std::sqrt(u);
    return {corner(id, 0) + edge(id, 1) * (root * (1.0 - v)) + edge(id, 2) * (root * v),
            plane_normal(scene_, id)};
  }

 private:
  glm::dvec3 corner(const TriangleId& id, int k) const {
    const Mesh& mesh = scene_.meshes[static_cast<std::size_t>(id.mesh)];
    return glm::dvec3(
        mesh.vertices[mesh.indices[3 * static_cast<std::size_t>(id.triangle) + static_cast<std::size_t>(k)]]
            .position);
  }
  glm::dvec3 edge(const TriangleId& id, int k) const { return corner(id, k) - corner(id, 0); }

  const Scene& scene_;
  std::vector<TriangleId> ids_;
  std::vector<double> sums_;  // of areas, up to and with each
};

// Does light between `from` and the place meet it from outside, past all casters?
bool meets(const LightPaths& paths, const CasterPlace& place, const glm::dvec3& from) {
  const glm::dvec3 way = from - place.position;
  const double distance = exact::length(way);
  if (!(distance > 0.0) || !(exact::dot(way, place.normal) > 0.0)) return false;
  return !paths.casters_block(place.position, way / distance, distance);
}

double part_of_1(double x) { return x - std::floor(x); }

}  // namespace

double unseen_share(const Scene& scene, const std::set<int>& casters, const LightPaths& paths,
                    const DrawnPoints& points, const glm::dvec3& eye) {
  const CasterAreas areas(scene, casters);
  if (areas.empty()) return 0.0;
  double all = 0.0, unseen = 0.0;
  for (int i = 0; i < kWaysToCasters; ++i) {
    // Roberts' sequence of low discrepancy in two dimensions.
    const CasterPlace place = areas.place((i + 0.5) / kWaysToCasters, part_of_1(0.7548776662466927 * i),
                                          part_of_1(0.5698402909980532 * i));
    const LightRay ray = points.ray({}, place.position, i, 0);
    if (!meets(paths, place, ray.origin)) continue;
    const glm::dvec3 way = place.position - ray.origin;
    const double light =
        -exact::dot(ray.direction, place.normal) * points.toward(ray, i, 0) / exact::dot(way, way);
    all += light;
    if (!meets(paths, place, eye)) unseen += light;
  }
  return all > 0.0 ? unseen / all : 0.0;
}

}  // namespace caustics
