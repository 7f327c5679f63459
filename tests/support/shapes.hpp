// Shapes and scenes made in memory, for tests that need exact geometry.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <map>
#include <utility>

#include "pipeline/scene/scene.hpp"

namespace caustics::test {

inline void finish(Mesh& mesh, float closedness) {
  mesh.closedness = closedness;
  mesh.lower = glm::vec3(std::numeric_limits<float>::max());
  mesh.upper = -mesh.lower;
  for (const Vertex& v : mesh.vertices) {
    mesh.lower = glm::min(mesh.lower, v.position);
    mesh.upper = glm::max(mesh.upper, v.position);
  }
}

// A sphere of 20 * 4^levels triangles with exact normals.
inline Mesh sphere(const glm::dvec3& centre, double radius, int levels, int material) {
  const double g = (1.0 + std::sqrt(5.0)) / 2.0;
  std::vector<glm::dvec3> points = {{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                                    {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                                    {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
  std::vector<std::uint32_t> faces = {0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                                      4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                                      6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1};
  for (glm::dvec3& p : points) p = glm::normalize(p);
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto key = std::minmax(a, b);
      const auto [found, fresh] =
          middles.try_emplace({key.first, key.second}, static_cast<std::uint32_t>(points.size()));
      if (fresh) points.push_back(glm::normalize(points[a] + points[b]));
      return found->second;
    };
    std::vector<std::uint32_t> finer;
    for (std::size_t f = 0; f < faces.size(); f += 3) {
      const std::uint32_t a = faces[f], b = faces[f + 1], c = faces[f + 2];
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const std::uint32_t i : {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca}) finer.push_back(i);
    }
    faces = std::move(finer);
  }
  Mesh mesh;
  mesh.name = "sphere";
  mesh.indices = faces;
  mesh.material = material;
  for (const glm::dvec3& p : points)
    mesh.vertices.push_back({.position = glm::vec3(centre + radius * p), .normal = glm::vec3(p)});
  finish(mesh, 1.0f);
  return mesh;
}

// A square in the plane y = height, facing up.
inline Mesh floor(double half, double height, int material) {
  Mesh mesh;
  mesh.name = "floor";
  mesh.indices = {0, 1, 2, 0, 2, 3};
  mesh.material = material;
  const float h = static_cast<float>(half), y = static_cast<float>(height);
  for (const glm::vec3& p : {glm::vec3(-h, y, h), {h, y, h}, {h, y, -h}, {-h, y, -h}})
    mesh.vertices.push_back({.position = p, .normal = {0.0f, 1.0f, 0.0f}});
  finish(mesh, 0.0f);
  return mesh;
}

// A closed box with flat normals.
inline Mesh box(const glm::dvec3& lower, const glm::dvec3& upper, int material) {
  Mesh mesh;
  mesh.name = "box";
  mesh.material = material;
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side) {
      const int b = (axis + 1) % 3, c = (axis + 2) % 3;
      glm::vec3 normal(0.0f);
      normal[axis] = side ? 1.0f : -1.0f;
      const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
      for (const auto& [u, v] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
        glm::vec3 p;
        p[axis] = static_cast<float>(side ? upper[axis] : lower[axis]);
        p[b] = static_cast<float>(u ? upper[b] : lower[b]);
        p[c] = static_cast<float>(v ? upper[c] : lower[c]);
        mesh.vertices.push_back({.position = p, .normal = normal});
      }
      const std::uint32_t front[6] = {0, 1, 2, 0, 2, 3}, back[6] = {0, 2, 1, 0, 3, 2};
      for (int i = 0; i < 6; ++i) mesh.indices.push_back(first + (side ? front[i] : back[i]));
    }
  finish(mesh, 1.0f);
  return mesh;
}

// An open sheet y = height + amplitude cos(k x) over [-half, half]^2, with exact normals.
inline Mesh wave_sheet(double half, double height, double amplitude, double k, int cells, int material) {
  Mesh mesh;
  mesh.name = "water";
  mesh.material = material;
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) {
      const double x = -half + 2.0 * half * i / cells, z = half - 2.0 * half * j / cells;
      const glm::dvec3 normal = glm::normalize(glm::dvec3(amplitude * k * std::sin(k * x), 1.0, 0.0));
      mesh.vertices.push_back({.position = glm::vec3(glm::dvec3(x, height + amplitude * std::cos(k * x), z)),
                               .normal = glm::vec3(normal)});
    }
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (cells + 1) + i); };
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i)
      for (const std::uint32_t v :
           {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)})
        mesh.indices.push_back(v);
  finish(mesh, 0.0f);
  return mesh;
}

// The upright wall of a half ring around the y axis, x > 0, from the floor to `height`; its normals point
// inwards, and are exact.
inline Mesh half_ring(double radius, double height, int cells, int material) {
  Mesh mesh;
  mesh.name = "ring";
  mesh.material = material;
  for (int i = 0; i <= cells; ++i) {
    const double angle = 3.14159265358979323846 * (static_cast<double>(i) / cells - 0.5);
    const glm::dvec3 out(std::cos(angle), 0.0, std::sin(angle));
    for (const double y : {0.0, height})
      mesh.vertices.push_back(
          {.position = glm::vec3(radius * out + glm::dvec3(0.0, y, 0.0)), .normal = glm::vec3(-out)});
  }
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(cells); ++i)
    for (const std::uint32_t v : {2 * i, 2 * i + 3, 2 * i + 1, 2 * i, 2 * i + 2, 2 * i + 3})
      mesh.indices.push_back(v);
  finish(mesh, 0.0f);
  return mesh;
}

// A closed, flat-topped ring around the y axis that stands on y = 0; its walls have the cylinders' normals.
// With `inner` 0 a rod with two lids.
inline Mesh ring(double inner, double outer, double height, int cells, int material) {
  Mesh mesh;
  mesh.name = "ring";
  mesh.material = material;
  // Strips around the axis between two profiles: radius, height, and the normal's parts outward and up.
  const auto band = [&](const glm::dvec4& a, const glm::dvec4& b) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int i = 0; i <= cells; ++i) {
      const double angle = 2.0 * 3.14159265358979323846 * (i % cells) / cells;
      const glm::dvec3 out(std::cos(angle), 0.0, std::sin(angle)), up(0.0, 1.0, 0.0);
      for (const glm::dvec4& p : {a, b})
        mesh.vertices.push_back(
            {.position = glm::vec3(out * p.x + up * p.y), .normal = glm::vec3(out * p.z + up * p.w)});
    }
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(cells); ++i)
      for (const std::uint32_t v : {0u, 1u, 3u, 0u, 3u, 2u}) mesh.indices.push_back(first + 2 * i + v);
  };
  band({outer, 0.0, 1.0, 0.0}, {outer, height, 1.0, 0.0});
  band({outer, height, 0.0, 1.0}, {inner, height, 0.0, 1.0});
  if (inner > 0.0) band({inner, height, -1.0, 0.0}, {inner, 0.0, -1.0, 0.0});
  band({inner, 0.0, 0.0, -1.0}, {outer, 0.0, 0.0, -1.0});
  finish(mesh, 1.0f);
  return mesh;
}

inline Material metal(const glm::vec3& color) {
  Material m;
  m.name = "metal";
  m.base_color = glm::vec4(color, 1.0f);
  m.metallic = 1.0f;
  m.roughness = 0.0f;
  return m;
}

inline Material diffuse(float albedo) {
  Material m;
  m.name = "diffuse";
  m.base_color = glm::vec4(albedo, albedo, albedo, 1.0f);
  m.metallic = 0.0f;
  m.double_sided = true;
  return m;
}

inline Material glass(float ior) {
  Material m;
  m.name = "glass";
  m.metallic = 0.0f;
  m.roughness = 0.0f;
  m.transmission = 1.0f;
  m.ior = ior;
  m.thickness = 1.0f;
  return m;
}

// An orthographic camera at `height` that looks straight down on a square of +-half metres; up is -z.
inline Camera camera_down(double height, double half) {
  Camera camera{.name = "floor", .orthographic = true};
  camera.position = {0.0, height, 0.0};
  camera.right = {1.0, 0.0, 0.0};
  camera.up = {0.0, 0.0, -1.0};
  camera.forward = {0.0, -1.0, 0.0};
  camera.half_width = camera.half_height = half;
  camera.near = 1e-3;
  camera.far = 100.0;
  return camera;
}

inline Light sun(const glm::dvec3& direction, float lux) {
  Light light{.name = "sun", .intensity = lux};
  light.direction = glm::normalize(direction);
  return light;
}

}  // namespace caustics::test
