// Which of a scene's triangles a ray meets first: a bounding-volume hierarchy over them, walked in double
// precision. Built and walked in a fixed order with + - * / only, so that it has the same bits everywhere.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "pipeline/scene/scene.hpp"

namespace caustics {

struct TriangleId {
  int mesh = -1, triangle = -1;  // of Scene::meshes, and of its indices three by three
  friend bool operator==(const TriangleId&, const TriangleId&) = default;
};

struct TriangleHit {
  TriangleId id;
  double distance = 0.0;    // along the ray, metres where its direction is a unit vector
  glm::dvec3 weights{0.0};  // of the triangle's three corners, adding up to 1
  bool front = true;        // the ray meets the side that its corners wind around counter-clockwise
};

class TriangleTree {
 public:
  // Over the triangles of these meshes, without degenerate ones. The scene must outlive the tree and keep its
  // vertices. Built on at most `threads` threads (pipeline/scene/in_pieces.hpp), into the same nodes on any
  // number.
  TriangleTree(const Scene& scene, const std::vector<int>& meshes, int threads = 0);
  // What building one of so many triangles takes at most, about: four nodes for five triangles.
  static std::size_t building_bytes(std::size_t triangles);

  // The nearest triangle at a distance of 0 or more: of several at the same distance the one that comes first
  // in the scene. `own`, which the ray starts on, is left out by its number, and so are the triangles of
  // `without`, a mesh. No ray slips between two triangles that share an edge: the edges' functions are each
  // other's negatives, and 0 counts as inside (Woop, Benthin, Wald 2013).
  std::optional<TriangleHit> nearest(const glm::dvec3& origin, const glm::dvec3& direction,
                                     const TriangleId& own = {}, int without = -1) const;

  bool empty() const { return triangles_.empty(); }

  // Of an inner node the left child follows it, and `first` is the right one; of a leaf `first` is the first
  // of `count` triangles.
  struct Node {
    glm::vec3 lower{0.0f}, upper{0.0f};
    std::uint32_t first = 0, count = 0;
  };
  // The first is the root. No leaf lies deeper than kDeepest nodes below it.
  static constexpr int kDeepest = 60;
  const std::vector<Node>& nodes() const { return nodes_; }
  // In the order of the leaves.
  const std::vector<TriangleId>& triangles() const { return triangles_; }

 private:
  struct Builder;
  struct Sheared;  // a ray as triangles meet it
  std::optional<TriangleHit> meet(const Sheared& ray, const TriangleId& id) const;
  glm::dvec3 corner(const TriangleId& id, int k) const;

  const Scene& scene_;
  std::vector<TriangleId> triangles_;
  std::vector<Node> nodes_;
};

// A triangle's unit normal; and a hit's place.
glm::dvec3 plane_normal(const Scene& scene, const TriangleId& id);
glm::dvec3 position_of(const Scene& scene, const TriangleHit& hit);

}  // namespace caustics
