#include "pipeline/scene/gltf/surface.hpp"

#include <algorithm>

namespace caustics::gltf {

namespace {

glm::dvec3 area_vector(const Shape& shape, const std::array<std::uint32_t, 3>& t) {
  return exact::cross(shape.positions[t[1]] - shape.positions[t[0]],
                      shape.positions[t[2]] - shape.positions[t[0]]);
}

template <typename T>
std::vector<T> split(const std::vector<T>& values, const Shape& shape) {
  std::vector<T> result;
  if (values.empty()) return result;
  for (const auto& triangle : shape.triangles) {
    for (const std::uint32_t corner : triangle) result.push_back(values[corner]);
  }
  return result;
}

void make_flat(Shape& shape) {
  std::vector<glm::dvec3> normals;
  for (const auto& triangle : shape.triangles) {
    const glm::dvec3 normal = exact::normalise(area_vector(shape, triangle), {0, 1, 0});
    normals.insert(normals.end(), 3, normal);
  }
  shape.positions = split(shape.positions, shape);
  shape.tangents = split(shape.tangents, shape);
  shape.uvs = split(shape.uvs, shape);
  shape.colors = split(shape.colors, shape);
  shape.normals = std::move(normals);
  for (std::uint32_t i = 0; i < shape.triangles.size(); ++i) {
    shape.triangles[i] = {3 * i, 3 * i + 1, 3 * i + 2};
  }
}

// The area-weighted mean of the faces round each vertex; where they cancel, that of the first face.
std::vector<glm::dvec3> geometric_normals(const Shape& shape) {
  std::vector<glm::dvec3> sums(shape.positions.size(), glm::dvec3(0));
  std::vector<glm::dvec3> first(shape.positions.size(), glm::dvec3(0, 1, 0));
  std::vector<bool> has_first(shape.positions.size(), false);
  for (const auto& triangle : shape.triangles) {
    const glm::dvec3 area = area_vector(shape, triangle);
    for (const std::uint32_t corner : triangle) {
      sums[corner] += area;
      if (has_first[corner]) continue;
      first[corner] = exact::normalise(area, {0, 1, 0});
      has_first[corner] = true;
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] = exact::normalise(sums[i], first[i]);
  return sums;
}

}  // namespace

void finish_normals(Context& context, Shape& shape) {
  if (shape.normals.empty()) {
    if (!shape.triangles.empty()) context.note(shape.name + ": no normals; it is shaded flat.");
    make_flat(shape);
    return;
  }
  const std::vector<glm::dvec3> geometric = geometric_normals(shape);
  std::size_t replaced = 0, turned = 0;
  for (std::size_t i = 0; i < shape.normals.size(); ++i) {
    const glm::dvec3 unit = exact::normalise(shape.normals[i], glm::dvec3(0));
    const bool usable = unit != glm::dvec3(0);
    // Shading normals may lean away from their faces, but not point to the other side of them.
    const bool opposed = usable && exact::dot(unit, geometric[i]) < -0.5;
    replaced += !usable;
    turned += opposed;
    shape.normals[i] = !usable ? geometric[i] : opposed ? -unit : unit;
  }
  if (replaced > 0) {
    context.note(shape.name + ": " + std::to_string(replaced) +
                 " normals are zero or not finite; the surface's own are used.");
  }
  if (turned > 0) {
    context.note(shape.name + ": " + std::to_string(turned) +
                 " normals pointed to the inner side of their triangles and were turned.");
  }
}

namespace {

// Sums over the faces of each vertex: directions of growing u and v.
struct Gradients {
  std::vector<glm::dvec3> along_u, along_v;
};

Gradients uv_gradients(const Shape& shape, const glm::mat3& m) {
  const auto transformed = [&](std::uint32_t i) {
    const glm::dvec2 uv = shape.uvs[i];
    return glm::dvec2(m[0][0] * uv.x + m[1][0] * uv.y, m[0][1] * uv.x + m[1][1] * uv.y);
  };
  Gradients sums{std::vector<glm::dvec3>(shape.positions.size(), glm::dvec3(0)),
                 std::vector<glm::dvec3>(shape.positions.size(), glm::dvec3(0))};
  for (const auto& t : shape.triangles) {
    const glm::dvec3 e1 = shape.positions[t[1]] - shape.positions[t[0]];
    const glm::dvec3 e2 = shape.positions[t[2]] - shape.positions[t[0]];
    const glm::dvec2 d1 = transformed(t[1]) - transformed(t[0]);
    const glm::dvec2 d2 = transformed(t[2]) - transformed(t[0]);
    const double sign = d1.x * d2.y - d2.x * d1.y < 0 ? -1.0 : 1.0;
    const glm::dvec3 u = sign * (e1 * d2.y - e2 * d1.y), v = sign * (e2 * d1.x - e1 * d2.x);
    if (!exact::finite(u) || !exact::finite(v)) continue;
    for (const std::uint32_t corner : t) {
      sums.along_u[corner] += u;
      sums.along_v[corner] += v;
    }
  }
  return sums;
}

}  // namespace

void finish_tangents(Context& context, Shape& shape, const glm::mat3& uv_transform) {
  const std::size_t count = shape.positions.size();
  if (shape.tangents.empty()) {
    shape.tangents.assign(count, glm::dvec4(0, 0, 0, 1));
    if (!shape.uvs.empty()) {
      const Gradients sums = uv_gradients(shape, uv_transform);
      for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3& u = sums.along_u[i];
        const bool mirrored = exact::dot(exact::cross(shape.normals[i], u), sums.along_v[i]) < 0;
        shape.tangents[i] = {u.x, u.y, u.z, mirrored ? -1.0 : 1.0};
      }
      context.note(shape.name + ": tangents were computed from its texture coordinates.");
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3& n = shape.normals[i];
    const glm::dvec3 given(shape.tangents[i].x, shape.tangents[i].y, shape.tangents[i].z);
    const glm::dvec3 unit = exact::normalise(given, exact::perpendicular(n));
    const glm::dvec3 across = unit - n * exact::dot(n, unit);
    const bool usable = exact::length(across) > 1e-6;
    const glm::dvec3 t = usable ? exact::normalise(across, unit) : exact::perpendicular(n);
    shape.tangents[i] = {t.x, t.y, t.z, shape.tangents[i].w};
  }
}

Mesh finish_mesh(const Shape& shape, const glm::dvec3& origin) {
  Mesh mesh;
  mesh.name = shape.name;
  mesh.material = shape.material;
  mesh.object = shape.object;
  mesh.closedness = shape.closedness;
  mesh.inside_out = shape.inside_out;
  mesh.has_uv = !shape.uvs.empty();
  constexpr std::uint32_t kUnused = 0xFFFFFFFFu;
  std::vector<std::uint32_t> renumbered(shape.positions.size(), kUnused);
  mesh.indices.reserve(shape.triangles.size() * 3);
  mesh.vertices.reserve(std::min(shape.positions.size(), shape.triangles.size() * 3));
  for (const auto& triangle : shape.triangles) {
    for (const std::uint32_t corner : triangle) {
      if (renumbered[corner] == kUnused) {
        renumbered[corner] = static_cast<std::uint32_t>(mesh.vertices.size());
        Vertex vertex;
        vertex.position = glm::vec3(shape.positions[corner] - origin);
        vertex.normal = glm::vec3(shape.normals[corner]);
        if (!shape.tangents.empty()) vertex.tangent = glm::vec4(shape.tangents[corner]);
        if (mesh.has_uv) vertex.uv = glm::vec2(shape.uvs[corner]);
        mesh.vertices.push_back(vertex);
        if (!shape.colors.empty()) mesh.colors.push_back(shape.colors[corner]);
      }
      mesh.indices.push_back(renumbered[corner]);
    }
  }
  mesh.lower = mesh.upper = mesh.vertices.empty() ? glm::vec3(0) : mesh.vertices[0].position;
  for (const Vertex& vertex : mesh.vertices) {
    mesh.lower = glm::min(mesh.lower, vertex.position);
    mesh.upper = glm::max(mesh.upper, vertex.position);
  }
  return mesh;
}

}  // namespace caustics::gltf
