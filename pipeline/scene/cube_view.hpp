// Views that see in every direction: a cube around a point, and which of its faces see what.
#pragma once
#include <algorithm>
#include <limits>

#include "pipeline/scene/view.hpp"

namespace caustics {

// Distance of the nearest and the farthest point of the triangles that `counts(mesh index)` chooses, metres.
// Nearest is above farthest where there are none.
struct Distances {
  double nearest, farthest;
  bool empty() const { return nearest > farthest; }
};
template <class Counts>
Distances distances_from(const glm::dvec3& point, const Scene& scene, Counts counts);
Distances distances_from(const glm::dvec3& point, const Mesh& mesh);

// A cube view around `origin`, its axes the scene's, for what lies between these distances; without an atlas
// yet.
View cube_view(const glm::dvec3& origin, const Distances& distances);
// The same with the tiles of a map of this size.
View with_atlas(View view, int side, int guard = kLeastGuard);

// Can a face of a cube view see a mesh? True where in doubt.
bool face_sees(const View& view, int face, const Mesh& mesh);

template <class Counts>
Distances distances_from(const glm::dvec3& point, const Scene& scene, Counts counts) {
  Distances all{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    if (!counts(i)) continue;
    const Distances one = distances_from(point, scene.meshes[i]);
    all.nearest = std::min(all.nearest, one.nearest);
    all.farthest = std::max(all.farthest, one.farthest);
  }
  return all;
}

}  // namespace caustics
