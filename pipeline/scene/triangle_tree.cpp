#include "pipeline/scene/triangle_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "pipeline/gpu/interrupt.hpp"
#include "pipeline/scene/exact.hpp"
#include "pipeline/scene/in_pieces.hpp"

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
  using Items = Item*;
  // What lies around triangles, and around their middles.
  struct Extent {
    Box box, middles;
    Extent(Items begin, Items end) {
      for (Items i = begin; i != end; ++i) {
        box.add(i->box);
        middles.add(i->middle());
      }
    }
  };
  // Triangles that are divided by themselves: into two others, `left` and the one after it, or in `nodes`.
  struct Part {
    Items begin, end;
    int depth = 0;
    Box box{};
    std::size_t left = 0;  // 0: none
    std::vector<Node> nodes{};
  };
  // What a part has at most before it is divided further on one thread. Its size shows in no result.
  static constexpr std::ptrdiff_t kPart = 4096;
  TriangleTree& tree;
  int threads;
  std::vector<Item> items{};

  void gather(const std::vector<int>& meshes) {
    std::size_t sum = 0;
    for (const int m : meshes) sum += tree.scene_.meshes[static_cast<std::size_t>(m)].indices.size() / 3;
    items.reserve(sum);
    for (const int m : meshes) {
      const std::size_t count = tree.scene_.meshes[static_cast<std::size_t>(m)].indices.size() / 3;
      for (std::size_t t = 0; t < count; ++t) items.push_back({.id = {m, static_cast<int>(t)}, .box = {}});
    }
    in_runs(items.size(), threads, [&](std::size_t first, std::size_t end) {
      for (std::size_t i = first; i < end; ++i) {
        Item& item = items[i];
        if (plane_normal(tree.scene_, item.id) == glm::dvec3(0.0))
          item.id.mesh = -1;
        else
          for (int k = 0; k < 3; ++k) item.box.add(vertex_of(tree.scene_, item.id, k).position);
      }
    });
    std::erase_if(items, [](const Item& item) { return item.id.mesh < 0; });
  }

  static Split best_split(Items begin, Items end, const Box& middles) {
    std::array<Split, 3> splits;
    std::array<std::array<Bin, kBins>, 3> bins;
    for (int axis = 0; axis < 3; ++axis) {
      const float extent = middles.upper[axis] - middles.lower[axis];
      const Split split{.axis = axis, .bin = 0, .lower = middles.lower[axis], .scale = kBins / extent};
      if (extent > 0.0f && std::isfinite(split.scale)) splits[static_cast<std::size_t>(axis)] = split;
    }
    for (Items i = begin; i != end; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (splits[axis].axis >= 0)
          bins[axis][static_cast<std::size_t>(splits[axis].bin_of(*i))].add({i->box, 1});
    Split best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (splits[axis].axis >= 0) take_better(splits[axis], bins[axis], best, least);
    return best;
  }

  static void take_better(const Split& split, const std::array<Bin, kBins>& bins, Split& best,
                          double& least) {
    std::array<Bin, kBins> right;
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

  // Where the right half begins. Both keep their order.
  static Items divide(Items begin, Items end, int depth, const Box& middles) {
    stop_if_interrupted();
    const Items half = begin + (end - begin) / 2;
    if (depth >= kDeepestSplit) return half;
    const Split split = best_split(begin, end, middles);
    if (split.axis < 0) return half;
    const Items middle =
        std::stable_partition(begin, end, [&](const Item& item) { return split.bin_of(item) <= split.bin; });
    return middle == begin || middle == end ? half : middle;
  }

  void build(std::vector<Node>& nodes, Items begin, Items end, int depth) const {
    const std::size_t at = nodes.size();
    const Extent extent(begin, end);
    nodes.push_back({.lower = extent.box.lower, .upper = extent.box.upper});
    const auto count = static_cast<std::size_t>(end - begin);
    if (count <= kLeafSize) {
      nodes[at].first = static_cast<std::uint32_t>(begin - items.data());
      nodes[at].count = static_cast<std::uint32_t>(count);
      return;
    }
    const Items middle = divide(begin, end, depth, extent.middles);
    build(nodes, begin, middle, depth + 1);
    nodes[at].first = static_cast<std::uint32_t>(nodes.size());
    build(nodes, middle, end, depth + 1);
  }

  // Level by level, the parts of a level at once.
  std::vector<Part> parts() {
    std::vector<Part> parts{{.begin = items.data(), .end = items.data() + items.size()}};
    for (std::size_t first = 0; first < parts.size();) {
      const std::size_t end = parts.size();
      std::vector<Items> middles(end - first, nullptr);
      in_pieces(static_cast<int>(end - first), threads, [&](int i) {
        Part& part = parts[first + static_cast<std::size_t>(i)];
        if (part.end - part.begin <= kPart) return build(part.nodes, part.begin, part.end, part.depth);
        const Extent extent(part.begin, part.end);
        part.box = extent.box;
        middles[static_cast<std::size_t>(i)] = divide(part.begin, part.end, part.depth, extent.middles);
      });
      for (std::size_t i = first; i < end; ++i) {
        const Items middle = middles[i - first];
        if (!middle) continue;
        const Part part = parts[i];
        parts[i].left = parts.size();
        parts.push_back({.begin = part.begin, .end = middle, .depth = part.depth + 1});
        parts.push_back({.begin = middle, .end = part.end, .depth = part.depth + 1});
      }
      first = end;
    }
    return parts;
  }

  // Each part's nodes where they would be, had all been built in one go.
  void join(std::vector<Part>& parts, std::size_t at = 0) {
    Part& part = parts[at];
    const std::size_t first = tree.nodes_.size();
    if (part.left == 0) {
      for (Node node : part.nodes) {
        if (node.count == 0) node.first += static_cast<std::uint32_t>(first);
        tree.nodes_.push_back(node);
      }
      part.nodes = {};
      return;
    }
    tree.nodes_.push_back({.lower = part.box.lower, .upper = part.box.upper});
    join(parts, part.left);
    tree.nodes_[first].first = static_cast<std::uint32_t>(tree.nodes_.size());
    join(parts, part.left + 1);
  }

  void run(const std::vector<int>& meshes) {
    gather(meshes);
    if (items.empty()) return;
    std::vector<Part> built = parts();
    std::size_t nodes = 0;
    for (const Part& part : built) nodes += std::max<std::size_t>(part.nodes.size(), 1);
    tree.nodes_.reserve(nodes);
    join(built);
    tree.triangles_.reserve(items.size());
    for (const Item& item : items) tree.triangles_.push_back(item.id);
  }
};

TriangleTree::TriangleTree(const Scene& scene, const std::vector<int>& meshes, int threads) : scene_(scene) {
  Builder{*this, threads}.run(meshes);
}

// Axes turned so that z is the direction's largest component, and sheared so that the ray runs along it.
// Nodes twice: in parts, and joined.
std::size_t TriangleTree::building_bytes(std::size_t triangles) {
  return triangles * (sizeof(Builder::Item) + sizeof(TriangleId)) + triangles / 5 * 8 * sizeof(Node);
}

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
