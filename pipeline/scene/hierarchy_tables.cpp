#include "pipeline/scene/hierarchy_tables.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "pipeline/gpu/error.hpp"
#include "pipeline/scene/emitter.hpp"
#include "pipeline/scene/in_pieces.hpp"
#include "pipeline/scene/triangle_tree.hpp"

namespace caustics {

namespace {

constexpr float kFarAway = 1e30f;

std::int64_t triangles_of(const Scene& scene, int mesh) {
  return static_cast<std::int64_t>(scene.meshes[static_cast<std::size_t>(mesh)].indices.size() / 3);
}

std::int64_t triangles_of(const Scene& scene, const std::vector<int>& meshes) {
  std::int64_t sum = 0;
  for (const int mesh : meshes) sum += triangles_of(scene, mesh);
  return sum;
}

std::size_t rows_for(std::size_t texels) {
  return std::max<std::size_t>(1, (texels + kTableWidth - 1) / kTableWidth);
}

// Texels one after the other, in rows of kTableWidth.
class Table {
 public:
  explicit Table(std::size_t texels)
      : image_(Format::RGBA32F, kTableWidth, static_cast<int>(rows_for(texels))) {}
  void set(std::size_t texel, const glm::vec3& xyz, float w) { set(texel, glm::vec4(xyz, w)); }
  void set(std::size_t texel, const glm::vec4& xyzw) {
    const std::array<float, 4> values{xyzw.x, xyzw.y, xyzw.z, xyzw.w};
    std::copy(values.begin(), values.end(), image_.values.begin() + static_cast<std::ptrdiff_t>(4 * texel));
  }
  Image image() { return std::move(image_); }

 private:
  Image image_;
};

const Vertex& corner(const Mesh& mesh, int triangle, std::size_t k) {
  return mesh.vertices[mesh.indices[3 * static_cast<std::size_t>(triangle) + k]];
}

using Node = TriangleTree::Node;

// Inner nodes in the tree's order. A tree of one leaf gets an inner node with that leaf alone.
Image node_table(const TriangleTree& tree, float touch, int threads) {
  const std::vector<Node>& nodes = tree.nodes();
  std::vector<std::uint32_t> place(nodes.size(), 0);
  std::uint32_t inner = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (nodes[i].count == 0) place[i] = inner++;
  Table table(4 * std::size_t{std::max(inner, 1u)});
  const auto put = [&](std::size_t texel, const Node& child, std::size_t index) {
    table.set(texel, child.lower - touch,
              child.count > 0 ? static_cast<float>(child.first) : static_cast<float>(place[index]));
    table.set(texel + 1, child.upper + touch, static_cast<float>(child.count));
  };
  // A box without extent that is farther than anything can be met, whichever way a ray goes.
  const Node nothing{glm::vec3(kFarAway), glm::vec3(kFarAway), 0, 1};
  if (inner == 0) {
    put(0, nodes.empty() ? nothing : nodes.front(), 0);
    put(2, nothing, 0);
  }
  in_runs(nodes.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (nodes[i].count > 0) continue;
      const std::size_t right = nodes[i].first, texel = 4 * std::size_t{place[i]};
      put(texel, nodes[i + 1], i + 1);
      put(texel + 2, nodes[right], right);
    }
  });
  return table.image();
}

// The first so many by number.
std::size_t triangles_with_uv(const Scene& scene, const HierarchyMeshes& meshes) {
  if (!meshes.dressed && !meshes.receivers_dressed) return 0;
  const std::int64_t receivers = meshes.receivers_dressed ? triangles_of(scene, meshes.receivers) : 0;
  return static_cast<std::size_t>(triangles_of(scene, meshes.casters) + receivers);
}

void put_points(const std::vector<SurfacePoint>& points, int first, Table& table) {
  auto texel = static_cast<std::size_t>(first);
  for (const SurfacePoint& point : points) {
    table.set(texel++, glm::vec3(point.position), 0.0f);
    table.set(texel++, glm::vec3(point.normal), 0.0f);
  }
}

}  // namespace

std::vector<std::int64_t> first_triangles(const Scene& scene, const HierarchyMeshes& meshes) {
  std::vector<std::int64_t> first(scene.meshes.size(), -1);
  std::int64_t next = 0;
  for (const std::vector<int>* list : {&meshes.casters, &meshes.receivers})
    for (const int mesh : *list) {
      first[static_cast<std::size_t>(mesh)] = next;
      next += triangles_of(scene, mesh);
    }
  return first;
}

std::int64_t caster_triangles(const Scene& scene, const HierarchyMeshes& meshes) {
  return triangles_of(scene, meshes.casters);
}

int first_uv(const Scene& scene, const HierarchyMeshes& meshes) {
  return static_cast<int>(3 * (triangles_of(scene, meshes.casters) + triangles_of(scene, meshes.receivers)));
}

int first_point(const Scene& scene, const HierarchyMeshes& meshes, std::size_t lamp) {
  return static_cast<int>(static_cast<std::size_t>(first_uv(scene, meshes)) +
                          kTexelsOfUv * triangles_with_uv(scene, meshes) +
                          2 * std::size_t{kPointsOfLamp} * lamp);
}

HierarchyTables hierarchy_tables(const Scene& scene, const HierarchyMeshes& meshes,
                                 const std::vector<int>& rows, float touch, int threads) {
  const auto count =
      static_cast<std::size_t>(triangles_of(scene, meshes.casters) + triangles_of(scene, meshes.receivers));
  const auto texels_of_uv = kTexelsOfUv * triangles_with_uv(scene, meshes);
  const auto texels_of_normals = static_cast<std::size_t>(first_point(scene, meshes, meshes.lamps.size()));
  if (count > kMostTriangles || rows_for(texels_of_normals) > kMostRows)
    throw Error(ExitCode::BadInput, "casters and receivers have " + std::to_string(count) +
                                        " triangles, and light can be followed through at most " +
                                        std::to_string(kMostTriangles) +
                                        "; simplify their meshes, or give --interfaces 2");
  std::vector<int> all = meshes.casters;
  all.insert(all.end(), meshes.receivers.begin(), meshes.receivers.end());
  const TriangleTree tree(scene, all, threads);
  const std::vector<std::int64_t> first = first_triangles(scene, meshes);
  Table triangles(3 * count), normals(texels_of_normals);
  const auto put = [&](std::size_t place) {
    const TriangleId& id = tree.triangles()[place];
    const auto m = static_cast<std::size_t>(id.mesh);
    const Mesh& mesh = scene.meshes[m];
    const auto number = static_cast<std::size_t>(first[m] + id.triangle);
    const std::array<float, 3> of_triangle{static_cast<float>(number), static_cast<float>(rows[m]),
                                           static_cast<float>(meshes.bodies[m] + 1)};
    for (std::size_t k = 0; k < 3; ++k) {
      triangles.set(3 * place + k, corner(mesh, id.triangle, k).position, of_triangle[k]);
      normals.set(3 * number + k, corner(mesh, id.triangle, k).normal,
                  k == 0 ? static_cast<float>(place) : 0.0f);
    }
    if (kTexelsOfUv * number >= texels_of_uv) return;
    const auto of = [&](std::size_t k) -> const Vertex& { return corner(mesh, id.triangle, k); };
    const std::size_t texel = 3 * count + kTexelsOfUv * number;
    normals.set(texel, glm::vec4(of(0).uv, of(1).uv));
    normals.set(texel + 1, glm::vec4(of(2).uv, 0.0f, 0.0f));
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = mesh.indices[3 * static_cast<std::size_t>(id.triangle) + k];
      normals.set(texel + 2 + k, mesh.colors.empty() ? of(k).tangent : mesh.colors[vertex]);
    }
  };
  in_runs(tree.triangles().size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t place = begin; place < end; ++place) put(place);
  });
  for (std::size_t i = 0; i < meshes.lamps.size(); ++i)
    put_points(Emitter(scene, meshes.lamps[i]).list(kPointsOfLamp), first_point(scene, meshes, i), normals);
  return {node_table(tree, touch, threads), triangles.image(), normals.image()};
}

}  // namespace caustics
