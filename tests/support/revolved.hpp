// Surfaces of revolution round the y axis, for tests that need exact geometry.
#pragma once
#include <functional>
#include <vector>

#include "tests/support/shapes.hpp"

namespace caustics::test {

// A point of a profile and its outward normal, which need not be unit length.
struct ProfilePoint {
  double r = 0.0, y = 0.0;
  double normal_r = 0.0, normal_y = 1.0;
};

// Points at equal steps of r, the last at `outer`; `at` gives each.
inline std::vector<ProfilePoint> profile(double inner, double outer, int rings,
                                         const std::function<ProfilePoint(double)>& at) {
  std::vector<ProfilePoint> points;
  for (int i = 0; i <= rings; ++i) points.push_back(at(inner + (outer - inner) * i / rings));
  return points;
}

// Adds the surface that the profile sweeps; triangles wind counter-clockwise seen from its normals'
// side.
inline void revolve(Mesh& mesh, const std::vector<ProfilePoint>& points, int sectors) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const ProfilePoint& p : points)
    for (int j = 0; j <= sectors; ++j) {
      const double angle = 2.0 * 3.14159265358979323846 * (j % sectors) / sectors;
      const glm::dvec3 out(std::cos(angle), 0.0, std::sin(angle));
      const glm::dvec3 normal = glm::normalize(p.normal_r * out + glm::dvec3(0.0, p.normal_y, 0.0));
      mesh.vertices.push_back(
          {.position = glm::vec3(p.r * out + glm::dvec3(0.0, p.y, 0.0)), .normal = glm::vec3(normal)});
    }
  const auto at = [&](std::size_t i, int j) {
    return first + static_cast<std::uint32_t>(i) * static_cast<std::uint32_t>(sectors + 1) +
           static_cast<std::uint32_t>(j);
  };
  const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Vertex &va = mesh.vertices[a], &vb = mesh.vertices[b], &vc = mesh.vertices[c];
    const glm::vec3 across = glm::cross(vb.position - va.position, vc.position - va.position);
    if (glm::length(across) < 1e-12f) return;  // on the axis a quad is one triangle
    if (glm::dot(across, va.normal + vb.normal + vc.normal) < 0.0f) std::swap(b, c);
    for (const std::uint32_t v : {a, b, c}) mesh.indices.push_back(v);
  };
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    for (int j = 0; j < sectors; ++j) {
      triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
}

}  // namespace caustics::test
