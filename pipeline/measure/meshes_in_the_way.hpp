// What keeps light from a caster, by name instead of as "something".
#pragma once
#include <vector>

#include "pipeline/effects/effects.hpp"
#include "pipeline/scene/scene.hpp"
#include "pipeline/scene/triangle_tree.hpp"

namespace caustics {

// Centres of triangles from all over a mesh, so many at most.
std::vector<glm::dvec3> some_points(const Mesh& mesh, std::size_t most);

class MeshesInTheWay {
 public:
  // The scene must outlive it and keep its vertices.
  explicit MeshesInTheWay(const Scene& scene);

  // Of the straight ways from these lights (indices into Scene::lights) to some points of a mesh, what most
  // of them meet before it: an index into Scene::meshes, -1 where nothing stands before it.
  int before(int caster, const std::vector<int>& lights) const;

  // Does a diffuse surface hide the point from the light?
  bool stands_opaque(const Effects& effects, const Light& light, const glm::dvec3& point) const;

 private:
  glm::dvec3 origin(const Light& light, const glm::dvec3& point) const;

  const Scene& scene_;
  TriangleTree tree_;
  double beyond_;  // metres that lie behind all of the scene, seen from any point of it
};

}  // namespace caustics
