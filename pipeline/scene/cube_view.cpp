#include "pipeline/scene/cube_view.hpp"

#include "pipeline/scene/exact.hpp"

namespace caustics {

namespace {

// The point of a triangle nearest to the origin (Ericson, Real-Time Collision Detection, 5.1.5).
glm::dvec3 nearest_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 ab = b - a, ac = c - a;
  const double d1 = -exact::dot(ab, a), d2 = -exact::dot(ac, a);
  if (d1 <= 0.0 && d2 <= 0.0) return a;
  const double d3 = -exact::dot(ab, b), d4 = -exact::dot(ac, b);
  if (d3 >= 0.0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + ab * (d1 / std::max(d1 - d3, 1e-300));
  const double d5 = -exact::dot(ab, c), d6 = -exact::dot(ac, c);
  if (d6 >= 0.0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + ac * (d2 / std::max(d2 - d6, 1e-300));
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
    return b + (c - b) * ((d4 - d3) / std::max((d4 - d3) + (d5 - d6), 1e-300));
  const double sum = std::max(va + vb + vc, 1e-300);
  return a + ab * (vb / sum) + ac * (vc / sum);
}

}  // namespace

Distances distances_from(const glm::dvec3& point, const Mesh& mesh) {
  Distances result{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  const auto corner = [&](std::size_t i) {
    return glm::dvec3(mesh.vertices[mesh.indices[i]].position) - point;
  };
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const glm::dvec3 a = corner(i), b = corner(i + 1), c = corner(i + 2);
    result.nearest = std::min(result.nearest, exact::length(nearest_of(a, b, c)));
    result.farthest = std::max({result.farthest, exact::length(a), exact::length(b), exact::length(c)});
  }
  return result;
}

View cube_view(const glm::dvec3& origin, const Distances& distances) {
  View view;
  view.origin = origin;
  view.perspective = true;
  view.cube = CubeAtlas{};
  if (distances.empty()) return view;
  view.far = std::max(distances.farthest * 1.001, 1e-9);
  // In its face's direction a point is at least its distance over sqrt 3 away, a little less in the guard.
  view.near = std::clamp(0.5 * distances.nearest, view.far * 1e-5, view.far * 0.5);
  return view;
}

View with_atlas(View view, int side, int guard) {
  view.cube = CubeAtlas{.side = side, .guard = guard};
  return view;
}

bool face_sees(const View& view, int face, const Mesh& mesh) {
  const CubeAtlas& atlas = *view.cube;
  const double wide = static_cast<double>(atlas.tile_width()) / atlas.face_width();
  const double high = static_cast<double>(atlas.tile_height()) / atlas.face_height();
  bool right = true, left = true, above = true, below = true;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p{corner & 1 ? mesh.upper.x : mesh.lower.x, corner & 2 ? mesh.upper.y : mesh.lower.y,
                       corner & 4 ? mesh.upper.z : mesh.lower.z};
    const glm::dvec3 q = turned_to_face(view.coordinates(p), face);
    right &= q.x > q.z * wide;
    left &= q.x < -q.z * wide;
    above &= q.y > q.z * high;
    below &= q.y < -q.z * high;
  }
  return !(right || left || above || below);
}

}  // namespace caustics
