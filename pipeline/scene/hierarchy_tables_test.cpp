#include "pipeline/scene/hierarchy_tables.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/gpu/error.hpp"
#include "pipeline/scene/triangle_tree.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/light_path_bench.hpp"

using namespace caustics;

namespace {

// Triangles that face up at height `y`, with their right angles at x = first, first + 1 ..., legs of half a
// metre. Their normals are no unit vectors, so that each can be told: (x, y, corner).
Mesh row_of(int triangles, float first, float y) {
  Mesh mesh;
  for (int i = 0; i < triangles; ++i) {
    const float x = first + static_cast<float>(i);
    const glm::vec3 corners[3] = {{x, y, 0.0f}, {x, y, 0.5f}, {x + 0.5f, y, 0.0f}};
    for (int k = 0; k < 3; ++k) {
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
      mesh.vertices.push_back({.position = corners[k], .normal = {x, y, static_cast<float>(k)}});
    }
  }
  return mesh;
}

glm::vec4 entry(const Image& table, std::size_t texel) {
  glm::vec4 value;
  for (std::size_t c = 0; c < 4; ++c) value[static_cast<int>(c)] = table.values[4 * texel + c];
  return value;
}

// A floor of two triangles, which is a receiver; and two casters, of one and of three triangles, whose
// materials are in rows 5 and 6, and whose bodies have those of rows 5 and 2.
struct Small {
  Scene scene;
  HierarchyMeshes meshes{.casters = {1, 2}, .receivers = {0}, .bodies = {-1, 5, 2}};
  Small() { scene.meshes = {row_of(2, 2.0f, 0.0f), row_of(1, 1.0f, 1.0f), row_of(3, 100.0f, 2.0f)}; }
  HierarchyTables tables(float touch = 0.0f) const {
    return hierarchy_tables(scene, meshes, {4, 5, 6}, touch);
  }
};

HierarchyTables tables_of(const Mesh& mesh, float touch = 0.0f) {
  Scene scene;
  scene.meshes = {mesh};
  return hierarchy_tables(scene, {.casters = {0}, .receivers = {}, .bodies = {0}}, {0}, touch);
}

// Nodes below the root of the deepest leaf.
int depth_of(const TriangleTree& tree, std::size_t node = 0) {
  const TriangleTree::Node& own = tree.nodes()[node];
  if (own.count > 0) return 0;
  return 1 + std::max(depth_of(tree, node + 1), depth_of(tree, own.first));
}

int depth_of(const Mesh& mesh) {
  Scene scene;
  scene.meshes = {mesh};
  return depth_of(TriangleTree(scene, {0}));
}

// Triangles of which each is 1/ratio as large and as far from the origin as the one before; the last of them
// many times.
Mesh geometric(double largest, double ratio, int triangles, int copies) {
  Mesh mesh;
  for (int i = 0; i + 1 < triangles + copies; ++i) {
    const auto x = static_cast<float>(largest * std::pow(ratio, -std::min(i, triangles - 1)));
    for (const glm::vec3& corner : {glm::vec3(x, 0, -x), {x, 0, x}, {1.1f * x, 0, 0}}) {
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
      mesh.vertices.push_back({.position = corner});
    }
  }
  return mesh;
}

}  // namespace

TEST_CASE("hierarchy tables: triangles are numbered mesh by mesh, casters first") {
  const Small small;
  CHECK(first_triangles(small.scene, small.meshes) == std::vector<std::int64_t>{4, 0, 1});
  CHECK(caster_triangles(small.scene, small.meshes) == 4);
  HierarchyMeshes without = small.meshes;
  without.casters = {2};
  CHECK(first_triangles(small.scene, without) == std::vector<std::int64_t>{3, -1, 0});
}

TEST_CASE("hierarchy tables: a triangle has its corners, its number, its material's row and its body's") {
  // The casters' three triangles at x = 100 are one leaf, what is at x < 4 the other, in the order of their
  // numbers: numbers by place are 0, 4, 5, 1, 2, 3.
  const HierarchyTables tables = Small{}.tables();
  const auto triangle = [&](std::size_t place, std::size_t k) {
    return entry(tables.triangles, 3 * place + k);
  };
  CHECK(triangle(0, 0) == glm::vec4(1.0f, 1.0f, 0.0f, 0.0f));
  CHECK(triangle(0, 1) == glm::vec4(1.0f, 1.0f, 0.5f, 5.0f));
  CHECK(triangle(0, 2) == glm::vec4(1.5f, 1.0f, 0.0f, 6.0f));
  CHECK(triangle(2, 0) == glm::vec4(3.0f, 0.0f, 0.0f, 5.0f));
  CHECK(triangle(2, 1) == glm::vec4(3.0f, 0.0f, 0.5f, 4.0f));
  CHECK(triangle(2, 2) == glm::vec4(3.5f, 0.0f, 0.0f, 0.0f));  // a receiver is no body
  CHECK(triangle(4, 0) == glm::vec4(101.0f, 2.0f, 0.0f, 2.0f));
  CHECK(triangle(4, 1).w == 6.0f);
  CHECK(triangle(4, 2).w == 3.0f);
}

TEST_CASE("hierarchy tables: normals are found by number, and tell the triangle's place") {
  const HierarchyTables tables = Small{}.tables();
  const float places[6] = {0.0f, 3.0f, 4.0f, 5.0f, 1.0f, 2.0f};
  for (std::size_t number = 0; number < 6; ++number) {
    CHECK(entry(tables.normals, 3 * number).w == places[number]);
    CHECK(entry(tables.triangles, 3 * static_cast<std::size_t>(places[number])).w ==
          static_cast<float>(number));
  }
  CHECK(entry(tables.normals, 3 * 2 + 1) == glm::vec4(101.0f, 2.0f, 1.0f, 0.0f));
  CHECK(entry(tables.normals, 3 * 5 + 2) == glm::vec4(3.0f, 0.0f, 2.0f, 0.0f));
}

TEST_CASE(
    "hierarchy tables: behind all normals a lamp has its points, which lie even over it, near by near") {
  // A triangle of half a square metre that looks along x.
  Scene scene;
  scene.materials.resize(1);
  const test::Corners upright{{{2, 0, 0}, {2, 1, 0}, {2, 0, 1}}}, level{{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}};
  scene.meshes = {test::mesh_of({upright}), test::mesh_of({level})};
  HierarchyMeshes meshes;
  meshes.receivers = {0, 1};
  meshes.bodies = {-1, -1};
  meshes.lamps = {1, 0};
  const HierarchyTables tables = hierarchy_tables(scene, meshes, {0, 0}, 0.0f);
  const auto first = static_cast<std::size_t>(first_point(scene, meshes, 1));
  CHECK(first == 2 * 3 + 2 * kPointsOfLamp);
  glm::dvec3 sum(0.0);
  double steps = 0.0;
  for (std::size_t k = 0; k < kPointsOfLamp; ++k) {
    const glm::vec4 place = entry(tables.normals, first + 2 * k);
    CHECK(entry(tables.normals, first + 2 * k + 1) == glm::vec4(1.0f, 0.0f, 0.0f, 0.0f));
    sum += glm::dvec3(place);
    if (k > 0) steps += double(glm::length(place - entry(tables.normals, first + 2 * k - 2)));
  }
  sum /= double{kPointsOfLamp};
  CHECK(sum.x == 2.0);
  CHECK(sum.y == Approx(1.0 / 3.0).epsilon(5e-3));
  CHECK(sum.z == Approx(1.0 / 3.0).epsilon(5e-3));
  // Points in no order are half a metre apart on the mean.
  CHECK(steps / kPointsOfLamp < 0.03);
}

TEST_CASE("hierarchy tables: a node has both children's boxes, larger by what touches, and what is in them") {
  const HierarchyTables tables = Small{}.tables(0.25f);
  CHECK(entry(tables.nodes, 0) == glm::vec4(0.75f, -0.25f, -0.25f, 0.0f));
  CHECK(entry(tables.nodes, 1) == glm::vec4(3.75f, 1.25f, 0.75f, 3.0f));
  CHECK(entry(tables.nodes, 2) == glm::vec4(99.75f, 1.75f, -0.25f, 3.0f));
  CHECK(entry(tables.nodes, 3) == glm::vec4(102.75f, 2.25f, 0.75f, 3.0f));
}

TEST_CASE("hierarchy tables: of a larger tree every place is in one leaf, and in the boxes above it") {
  const HierarchyTables tables = tables_of(row_of(1000, 0.0f, 1.0f));
  std::vector<int> visits(1000, 0);
  int outside = 0;
  const auto visit = [&](const auto& self, std::size_t node) -> void {
    for (const std::size_t child : {4 * node, 4 * node + 2}) {
      const glm::vec4 lower = entry(tables.nodes, child), upper = entry(tables.nodes, child + 1);
      const auto first = static_cast<std::size_t>(lower.w), count = static_cast<std::size_t>(upper.w);
      if (count == 0) {
        REQUIRE(first > node);
        self(self, first);
      }
      for (std::size_t place = first; place < first + count; ++place) {
        ++visits[place];
        for (std::size_t k = 0; k < 3; ++k) {
          const float x = entry(tables.triangles, 3 * place + k).x;
          outside += x < lower.x || x > upper.x;
        }
      }
    }
  };
  visit(visit, 0);
  CHECK(visits == std::vector<int>(1000, 1));
  CHECK(outside == 0);
}

TEST_CASE("hierarchy tables: any number of threads makes the same bits") {
  // Enough for several parts that are built by themselves (4096 triangles), and for several runs of 8192: of
  // a row, of triangles in one place, and of sizes that are divided as deep as may be.
  std::vector<Mesh> meshes{row_of(30'000, 0.0f, 1.0f), geometric(1e37, 1.5, 200, 20'000)};
  meshes.push_back(meshes[0]);
  for (std::size_t i = 0; i < meshes[2].vertices.size(); ++i)
    meshes[2].vertices[i] = meshes[0].vertices[i % 3];
  for (const Mesh& mesh : meshes) {
    Scene scene;
    scene.meshes = {mesh};
    const auto made = [&](int threads) {
      return hierarchy_tables(scene, {.casters = {0}, .receivers = {}, .bodies = {0}}, {0}, 0.25f, threads);
    };
    const HierarchyTables alone = made(1);
    for (const int threads : {0, 2, 3, 7, 16}) {
      const HierarchyTables several = made(threads);
      CHECK(sha256(several.nodes) == sha256(alone.nodes));
      CHECK(sha256(several.triangles) == sha256(alone.triangles));
      CHECK(sha256(several.normals) == sha256(alone.normals));
    }
  }
}

TEST_CASE("hierarchy tables: a tree of one leaf has a node with that and a child that nothing meets") {
  const HierarchyTables tables = tables_of(row_of(1, 3.0f, 1.0f));
  CHECK(entry(tables.nodes, 0) == glm::vec4(3.0f, 1.0f, 0.0f, 0.0f));
  CHECK(entry(tables.nodes, 1) == glm::vec4(3.5f, 1.0f, 0.5f, 1.0f));
  CHECK(entry(tables.nodes, 2).x >= 1e30f);
  CHECK(entry(tables.nodes, 3).x >= 1e30f);
}

TEST_CASE("hierarchy tables: without triangles there is a node with nothing to meet") {
  for (const Mesh& mesh : {Mesh{}, [] {
                             Mesh line = row_of(1, 0.0f, 0.0f);
                             line.indices = {0, 1, 1};
                             return line;
                           }()}) {
    const HierarchyTables tables = tables_of(mesh);
    for (const std::size_t child : {0u, 2u}) CHECK(entry(tables.nodes, child).x >= 1e30f);
    for (const Image* image : {&tables.nodes, &tables.triangles, &tables.normals}) {
      CHECK(image->width() == kTableWidth);
      CHECK(image->height() == 1);
    }
  }
}

TEST_CASE("hierarchy tables: a triangle without area keeps its number, and is in no leaf") {
  Mesh mesh = row_of(3, 0.0f, 1.0f);
  mesh.indices[4] = mesh.indices[3];
  const HierarchyTables tables = tables_of(mesh);
  CHECK(entry(tables.nodes, 1).w == 2.0f);
  CHECK(entry(tables.triangles, 0).w == 0.0f);
  CHECK(entry(tables.triangles, 3).w == 2.0f);
  CHECK(entry(tables.normals, 6).w == 1.0f);
}

TEST_CASE("hierarchy tables: rows are 4096 texels, as many as it takes") {
  // 1365 triangles take 4095 texels, 1366 take 4098.
  CHECK(tables_of(row_of(1365, 0.0f, 1.0f)).triangles.height() == 1);
  const HierarchyTables tables = tables_of(row_of(1366, 0.0f, 1.0f));
  CHECK(tables.triangles.height() == 2);
  CHECK(tables.normals.height() == 2);
  CHECK(entry(tables.normals, 3 * 1365).x == 1365.0f);
}

TEST_CASE("hierarchy tables: more triangles than single precision can number are refused") {
  // A mesh of 4096, named 4097 times: one is refused before any table is made.
  Scene scene;
  scene.meshes = {row_of(4096, 0.0f, 1.0f)};
  const HierarchyMeshes meshes{.casters = std::vector<int>(4096, 0), .receivers = {0}, .bodies = {0}};
  try {
    hierarchy_tables(scene, meshes, {0}, 0.0f);
    FAIL("not refused");
  } catch (const Error& error) {
    CHECK(error.code() == ExitCode::BadInput);
    CHECK(
        std::string(error.what()) ==
        "casters and receivers have 16781312 triangles, and light can be followed through at most 16777216; "
        "simplify their meshes, or give --interfaces 2");
  }
}

TEST_CASE("hierarchy tables: no mesh makes a tree deeper than 60 nodes, which the walk's stack of 64 holds") {
  // From 1e37 m down to 1e-37 m, triangles are divided by place 36 times at most, then halved by number until
  // 4 or less are left. A node of 4096 to 8192 takes 11 halvings, one of 2^24 took 22.
  static_assert(TriangleTree::kDeepest == 60);
  for (const double ratio : {1.5, 2.0, 4.0, 8.0}) {
    const int triangles = static_cast<int>(170.0 / std::log(ratio));
    INFO("ratio " << ratio << ", " << triangles << " triangles");
    const int alone = depth_of(geometric(1e37, ratio, triangles, 1));
    CHECK(alone > 36);
    CHECK(alone <= 36 + static_cast<int>(std::ceil(std::log2(triangles / 4.0))));
    CHECK(depth_of(geometric(1e37, ratio, triangles, 4096)) == 36 + 11);
  }
}
