#include "pipeline/scene/triangle_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "pipeline/scene/exact.hpp"

namespace caustics {

namespace {

constexpr std::size_t kLeafSize = 4;
constexpr int kBins = 16;
// From here on triangles are halved by number: 2^24 of them take 22 more steps.
constexpr int kDeepestSplit = TriangleTree::kDeepest - 24;

const Mesh& mesh_of(const Scene& scene, const TriangleId& id) {
  return scene.meshes[static_cast<std::size_t>(id.mesh)];
}

const Vertex& vertex_of(const Scene& scene, const TriangleId& id, int k) {
  const Mesh& mesh = mesh_of(scene, id);
  return mesh.vertices[mesh.indices[3 * static_cast<std::size_t>(id.triangle) + static_cast<std::size_t>(k)]];
}

}  // namespace

// Binned surface-area heuristic (Wald 2007) over the triangles' middles.
struct TriangleTree::Builder {
  struct Box {
    glm::vec3 lower{std::numeric_limits<float>::infinity()};
    glm::vec3 upper{-std::numeric_limits<float>::infinity()};
    void add(const glm::vec3& p) {
      lower = glm::min(lower, p);
      upper = glm::max(upper, p);
    }
    void add(const Box& other) {
      lower = glm::min(lower, other.lower);
      upper = glm::max(upper, other.upper);
    }
    // Half of its surface.
    double area() const {
      if (lower.x > upper.x) return 0.0;
      const glm::dvec3 side = glm::dvec3(upper) - glm::dvec3(lower);
      return (side.x * side.y + side.y * side.z) + side.z * side.x;
    }
  };

  struct Bin {
    Box box;
    std::size_t count = 0;
    void add(const Bin& other) {
      box.add(other.box);
      count += other.count;
    }
    // What a ray that meets the box around all pays for it, up to a factor.
    double cost() const { return box.area() * static_cast<double>(count); }
  };
  struct Item {
    TriangleId id;
    Box box;
    glm::vec3 middle() const { return 0.5f * (box.lower + box.upper); }
  };
  struct Split {
    int axis = -1, bin = 0;  // the last bin on the left
    float lower = 0.0f, scale = 0.0f;
    int bin_of(const Item& item) const {
      return std::min(static_cast<int>((item.middle()[axis] - lower) * scale), kBins - 1);
    }
  };
  using Items = std::vector<Item>::iterator;

  TriangleTree& tree;
  std::vector<Item> items;

  void gather(const Scene& scene, const std::vector<int>& meshes) {
    for (const int m : meshes) {
      const Mesh& mesh = scene.meshes[static_cast<std::size_t>(m)];
      for (std::size_t t = 0; 3 * t + 2 < mesh.indices.size(); ++t) {
        Item item{.id = {m, static_cast<int>(t)}, .box = {}};
        if (plane_normal(scene, item.id) == glm::dvec3(0.0)) continue;
        for (int k = 0; k < 3; ++k) item.box.add(vertex_of(scene, item.id, k).position);
        items.push_back(item);
      }
    }
  }

  Split best_split(Items begin, Items end) const {
    Box middles;
    for (Items i = begin; i != end; ++i) middles.add(i->middle());
    Split best;
    double least = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      const float extent = middles.upper[axis] - middles.lower[axis];
      if (!(extent > 0.0f)) continue;
      Split split{.axis = axis, .bin = 0, .lower = middles.lower[axis], .scale = kBins / extent};
      if (!std::isfinite(split.scale)) continue;
      std::array<Bin, kBins> bins, right;
      for (Items i = begin; i != end; ++i) bins[static_cast<std::size_t>(split.bin_of(*i))].add({i->box, 1});
      right.back() = bins.back();
      for (std::size_t b = kBins - 1; b-- > 0;) {
        right[b] = bins[b];
        right[b].add(right[b + 1]);
      }
      Bin left;
      for (int b = 0; b + 1 < kBins; ++b) {
        left.add(bins[static_cast<std::size_t>(b)]);
        const double cost = left.cost() + right[static_cast<std::size_t>(b) + 1].cost();
        if (!(cost < least)) continue;
        least = cost;
        best = split;
        best.bin = b;
      }
    }
    return best;
  }

  // Where the right half begins.
  Items divide(Items begin, Items end, int depth) const {
    const Items half = begin + (end - begin) / 2;
    if (depth >= kDeepestSplit) return half;
    const Split split = best_split(begin, end);
    if (split.axis < 0) return half;
    const Items middle =
        std::stable_partition(begin, end, [&](const Item& item) { return split.bin_of(item) <= split.bin; });
    return middle == begin || middle == end ? half : middle;
  }

  void build(Items begin, Items end, int depth = 0) {
    const std::size_t at = tree.nodes_.size();
    Box box;
    for (Items i = begin; i != end; ++i) box.add(i->box);
    tree.nodes_.push_back({.lower = box.lower, .upper = box.upper});
    const auto count = static_cast<std::size_t>(end - begin);
    if (count <= kLeafSize) {
      tree.nodes_[at].first = static_cast<std::uint32_t>(tree.triangles_.size());
      tree.nodes_[at].count = static_cast<std::uint32_t>(count);
      for (Items i = begin; i != end; ++i) tree.triangles_.push_back(i->id);
      return;
    }
    const Items middle = divide(begin, end, depth);
    build(begin, middle, depth + 1);
    tree.nodes_[at].first = static_cast<std::uint32_t>(tree.nodes_.size());
    build(middle, end, depth + 1);
  }
};

TriangleTree::TriangleTree(const Scene& scene, const std::vector<int>& meshes) : scene_(scene) {
  Builder builder{*this, {}};
  builder.gather(scene, meshes);
  triangles_.reserve(builder.items.size());
  if (!builder.items.empty()) builder.build(builder.items.begin(), builder.items.end());
}

// Axes turned so that z is the direction's largest component, and sheared so that the ray runs along it.
struct TriangleTree::Sheared {
  glm::dvec3 origin, direction, inverse, shear;
  int x = 0, y = 1, z = 2;

  Sheared(const glm::dvec3& from, const glm::dvec3& along) : origin(from), direction(along) {
    const glm::dvec3 size = glm::abs(along);
    z = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    x = (z + 1) % 3;
    y = (z + 2) % 3;
    if (along[z] < 0.0) std::swap(x, y);
    shear = {along[x] / along[z], along[y] / along[z], 1.0 / along[z]};
    // Finite, so that no slab gives 0 times infinity.
    for (int k = 0; k < 3; ++k)
      inverse[k] = std::fabs(along[k]) > 1e-300 ? 1.0 / along[k] : std::copysign(1e300, along[k]);
  }
  glm::dvec3 of(const glm::dvec3& p) const {
    const glm::dvec3 q = p - origin;
    return {q[x] - shear.x * q[z], q[y] - shear.y * q[z], shear.z * q[z]};
  }
  // How far off a box is: infinite where the ray misses it. Slabs (Kay and Kajiya 1986), a little wider than
  // rounding.
  double reaches(const glm::vec3& lower, const glm::vec3& upper) const {
    double enters = 0.0, leaves = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
      const double a = (static_cast<double>(lower[k]) - origin[k]) * inverse[k],
                   b = (static_cast<double>(upper[k]) - origin[k]) * inverse[k];
      enters = std::max(enters, std::min(a, b));
      leaves = std::min(leaves, std::max(a, b));
    }
    return enters <= leaves * (1.0 + 1e-14) ? enters : std::numeric_limits<double>::infinity();
  }
};

glm::dvec3 TriangleTree::corner(const TriangleId& id, int k) const {
  return glm::dvec3(vertex_of(scene_, id, k).position);
}

std::optional<TriangleHit> TriangleTree::meet(const Sheared& ray, const TriangleId& id) const {
  const glm::dvec3 a = ray.of(corner(id, 0)), b = ray.of(corner(id, 1)), c = ray.of(corner(id, 2));
  const double u = c.x * b.y - c.y * b.x, v = a.x * c.y - a.y * c.x, w = b.x * a.y - b.y * a.x;
  if ((u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0)) return {};
  const double area = (u + v) + w;
  if (area == 0.0) return {};
  TriangleHit hit{.id = id, .weights = glm::dvec3(u, v, w) / area, .front = area > 0.0};
  hit.distance = (hit.weights.x * a.z + hit.weights.y * b.z) + hit.weights.z * c.z;
  return hit.distance >= 0.0 ? std::optional(hit) : std::nullopt;
}

std::optional<TriangleHit> TriangleTree::nearest(const glm::dvec3& origin, const glm::dvec3& direction,
                                                 const TriangleId& own, int without) const {
  if (nodes_.empty() || !exact::finite(origin) || !exact::finite(direction) || direction == glm::dvec3(0.0))
    return {};
  const Sheared ray(origin, direction);
  std::optional<TriangleHit> best;
  const auto before = [](const TriangleHit& a, const TriangleHit& b) {
    if (a.distance != b.distance) return a.distance < b.distance;
    return a.id.mesh != b.id.mesh ? a.id.mesh < b.id.mesh : a.id.triangle < b.id.triangle;
  };
  struct Waiting {
    std::uint32_t node;
    double distance;
  };
  std::vector<Waiting> stack;
  stack.reserve(64);
  stack.push_back({0, ray.reaches(nodes_[0].lower, nodes_[0].upper)});
  while (!stack.empty()) {
    const Waiting next = stack.back();
    stack.pop_back();
    if (!(next.distance <= (best ? best->distance : std::numeric_limits<double>::max()))) continue;
    const Node& node = nodes_[next.node];
    for (std::uint32_t i = 0; i < node.count; ++i) {
      const TriangleId& id = triangles_[node.first + i];
      if (id == own || id.mesh == without) continue;
      const std::optional<TriangleHit> hit = meet(ray, id);
      if (hit && (!best || before(*hit, *best))) best = hit;
    }
    if (node.count > 0) continue;
    Waiting left{next.node + 1, 0.0}, right{node.first, 0.0};
    for (Waiting* child : {&left, &right})
      child->distance = ray.reaches(nodes_[child->node].lower, nodes_[child->node].upper);
    if (left.distance < right.distance) std::swap(left, right);
    stack.push_back(left);
    stack.push_back(right);
  }
  return best;
}

glm::dvec3 shading_normal(const Scene& scene, const TriangleHit& hit) {
  glm::dvec3 sum(0.0);
  for (int k = 0; k < 3; ++k) sum += glm::dvec3(vertex_of(scene, hit.id, k).normal) * hit.weights[k];
  return exact::normalise(sum, plane_normal(scene, hit.id));
}

glm::dvec3 plane_normal(const Scene& scene, const TriangleId& id) {
  const glm::dvec3 a(vertex_of(scene, id, 0).position), b(vertex_of(scene, id, 1).position),
      c(vertex_of(scene, id, 2).position);
  return exact::normalise(exact::cross(b - a, c - a), glm::dvec3(0.0));
}

glm::dvec3 position_of(const Scene& scene, const TriangleHit& hit) {
  glm::dvec3 sum(0.0);
  for (int k = 0; k < 3; ++k) sum += glm::dvec3(vertex_of(scene, hit.id, k).position) * hit.weights[k];
  return sum;
}

}  // namespace caustics
