#include "pipeline/scene/gltf/topology.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "pipeline/scene/gltf/weld.hpp"

namespace caustics::gltf {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

// A triangle of the group: where it is, and its corners after welding.
struct Face {
  std::uint32_t shape, triangle;
  Triangle corners;
};

struct HalfEdge {
  std::uint32_t low, high, face;
  bool forward;  // runs from low to high
};

std::vector<Face> faces_of(const std::vector<Shape*>& group) {
  const std::vector<std::uint32_t> welded = weld(group);
  std::vector<Face> faces;
  std::size_t count = 0;
  for (const Shape* shape : group) count += shape->triangles.size();
  faces.reserve(count);
  std::uint32_t offset = 0;
  for (std::uint32_t s = 0; s < group.size(); ++s) {
    for (std::uint32_t t = 0; t < group[s]->triangles.size(); ++t) {
      const Triangle& c = group[s]->triangles[t];
      faces.push_back({s, t, {welded[offset + c[0]], welded[offset + c[1]], welded[offset + c[2]]}});
    }
    offset += static_cast<std::uint32_t>(group[s]->positions.size());
  }
  return faces;
}

// Numbers of things by a key of each, one list after the other: those of key k are in `numbers` from start[k]
// to start[k + 1], in their order. Unlike sorting it takes twice the time for twice the things.
struct Buckets {
  std::vector<std::uint32_t> start, numbers;

  // `each` calls its argument with the key and the number of everything, in order.
  template <class Each>
  explicit Buckets(const Each& each) {
    each([&](std::uint32_t key, std::uint32_t) {
      if (start.size() < std::size_t{key} + 2) start.resize(std::size_t{key} + 2, 0);
      ++start[std::size_t{key} + 1];
    });
    std::partial_sum(start.begin(), start.end(), start.begin());
    numbers.resize(start.empty() ? 0 : start.back());
    std::vector<std::uint32_t> next = start;
    each([&](std::uint32_t key, std::uint32_t number) { numbers[next[key]++] = number; });
  }
};

// The triangle turned so that its lowest corner comes first, winding kept.
Triangle rotated(const Triangle& t) {
  if (t[0] <= t[1] && t[0] <= t[2]) return t;
  if (t[1] <= t[0] && t[1] <= t[2]) return {t[1], t[2], t[0]};
  return {t[2], t[0], t[1]};
}

// Removes the later of two faces with equal corners and winding, from `faces` and from the shapes.
std::size_t drop_doubles(const std::vector<Shape*>& group, std::vector<Face>& faces) {
  Buckets faces_at([&](const auto& visit) {
    for (std::uint32_t f = 0; f < faces.size(); ++f) visit(rotated(faces[f].corners)[0], f);
  });
  std::vector<bool> doubled(faces.size(), false);
  std::size_t count = 0;
  for (std::size_t corner = 0; corner + 1 < faces_at.start.size(); ++corner) {
    const auto begin = faces_at.numbers.begin() + faces_at.start[corner];
    const auto end = faces_at.numbers.begin() + faces_at.start[corner + 1];
    std::sort(begin, end, [&](std::uint32_t a, std::uint32_t b) {
      const Triangle p = rotated(faces[a].corners), q = rotated(faces[b].corners);
      return p != q ? p < q : a < b;
    });
    for (auto i = begin; i != end; ++i) {
      if (i == begin || rotated(faces[*i].corners) != rotated(faces[*(i - 1)].corners)) continue;
      doubled[*i] = true;
      ++count;
    }
  }
  if (count == 0) return 0;
  std::vector<std::vector<Triangle>> kept(group.size());
  std::vector<Face> kept_faces;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (doubled[i]) continue;
    Face face = faces[i];
    kept[face.shape].push_back(group[face.shape]->triangles[face.triangle]);
    face.triangle = static_cast<std::uint32_t>(kept[face.shape].size() - 1);
    kept_faces.push_back(face);
  }
  for (std::size_t s = 0; s < group.size(); ++s) group[s]->triangles = std::move(kept[s]);
  faces = std::move(kept_faces);
  return count;
}

// The half-edge of a face that runs from its corner k to the next.
HalfEdge half_edge(const std::vector<Face>& faces, std::uint32_t face, std::uint32_t k) {
  const std::uint32_t a = faces[face].corners[k], b = faces[face].corners[(k + 1) % 3];
  return {std::min(a, b), std::max(a, b), face, a < b};
}

// Calls `visit` with the half-edges of each edge, by their corners, then by the faces' order.
template <class Visit>
void each_edge(const std::vector<Face>& faces, const Visit& visit) {
  // Numbers alone, face * 3 + k: the half-edges themselves would be the most of what loading takes.
  const Buckets edges_at([&](const auto& put) {
    for (std::uint32_t f = 0; f < faces.size(); ++f)
      for (std::uint32_t k = 0; k < 3; ++k) {
        const HalfEdge edge = half_edge(faces, f, k);
        if (edge.low != edge.high) put(edge.low, 3 * f + k);  // else shorter than the welding tolerance
      }
  });
  std::vector<HalfEdge> edges;
  for (std::size_t corner = 0; corner + 1 < edges_at.start.size(); ++corner) {
    edges.clear();
    for (std::uint32_t i = edges_at.start[corner]; i < edges_at.start[corner + 1]; ++i)
      edges.push_back(half_edge(faces, edges_at.numbers[i] / 3, edges_at.numbers[i] % 3));
    std::sort(edges.begin(), edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
      return a.high != b.high ? a.high < b.high : a.face < b.face;
    });
    for (std::size_t i = 0; i < edges.size();) {
      std::size_t end = i + 1;
      while (end < edges.size() && edges[end].high == edges[i].high) ++end;
      visit(edges.data() + i, end - i);
      i = end;
    }
  }
}

// Two faces that share an edge; `agree` when they run through it in opposite directions.
struct Neighbours {
  std::uint32_t a, b;
  bool agree;
};

struct Edges {
  float closedness = 0.0f;
  std::vector<Neighbours> pairs;
};

// Where each welded corner is, by its number.
std::vector<glm::dvec3> corner_positions(const std::vector<Shape*>& group, const std::vector<Face>& faces) {
  std::vector<glm::dvec3> positions;
  for (const Face& face : faces) {
    const Shape& shape = *group[face.shape];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t corner = face.corners[k];
      if (positions.size() <= corner) positions.resize(corner + 1);
      positions[corner] = shape.positions[shape.triangles[face.triangle][k]];
    }
  }
  return positions;
}

// Groups numbers that have been joined; a group goes by its lowest member.
class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
  std::uint32_t of(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = of(a);
    b = of(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

// The area that would have to be added to close the surface, over the area that is there: each
// connected border spans the vector area 1/2 sum p x q over its edges. A scan's holes are small
// shares; an open sheet's border spans as much as the sheet.
double hole_share(const std::vector<Shape*>& group, const std::vector<Face>& faces,
                  const std::vector<HalfEdge>& borders) {
  if (borders.empty()) return 0.0;
  const std::vector<glm::dvec3> p = corner_positions(group, faces);
  double area = 0.0;
  for (const Face& f : faces)
    area += 0.5 *
            exact::length(exact::cross(p[f.corners[1]] - p[f.corners[0]], p[f.corners[2]] - p[f.corners[0]]));
  Groups groups(p.size());
  for (const HalfEdge& edge : borders) groups.join(edge.low, edge.high);
  std::vector<glm::dvec3> spanned(p.size(), glm::dvec3(0.0));
  for (const HalfEdge& edge : borders) {
    const std::uint32_t border = groups.of(edge.low);
    const glm::dvec3 a = p[edge.low] - p[border], b = p[edge.high] - p[border];
    spanned[border] += (edge.forward ? 0.5 : -0.5) * exact::cross(a, b);
  }
  double holes = 0.0;
  for (const glm::dvec3& s : spanned) holes += exact::length(s);
  return area > 0.0 ? std::min(holes / area, 1.0) : 1.0;
}

Edges examine_edges(const std::vector<Shape*>& group, const std::vector<Face>& faces) {
  Edges result;
  result.pairs.reserve(faces.size() / 2 * 3);
  std::vector<HalfEdge> borders;
  each_edge(faces, [&](const HalfEdge* sides, std::size_t count) {
    if (count == 2)
      result.pairs.push_back({sides[0].face, sides[1].face, sides[0].forward != sides[1].forward});
    if (count == 1) borders.push_back(sides[0]);
  });
  if (!faces.empty()) {
    result.closedness = static_cast<float>(1.0 - hole_share(group, faces, borders));
  }
  return result;
}

class Orientation {
 public:
  Orientation(const std::vector<Shape*>& group, const std::vector<Face>& faces)
      : group_(group), faces_(faces), turned_(faces.size(), false) {
    glm::dvec3 lower(std::numeric_limits<double>::infinity()), upper = -lower;
    for (const Shape* shape : group) {
      for (const glm::dvec3& p : shape->positions) {
        lower = glm::min(lower, p);
        upper = glm::max(upper, p);
      }
    }
    centre_ = 0.5 * (lower + upper);
    extent_ = exact::length(upper - lower);
  }

  // Makes every connected part that disagrees within itself face outwards; returns how many turned.
  std::size_t reconcile(const std::vector<Neighbours>& pairs);
  double volume() const {
    double sum = 0;
    for (std::uint32_t f = 0; f < faces_.size(); ++f) sum += volume(f);
    return sum;
  }
  bool inside_out() const { return volume() < -1e-9 * extent_ * extent_ * extent_; }
  void turn_all() { turned_.flip(); }
  void apply() {
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      Triangle& t = group_[faces_[f].shape]->triangles[faces_[f].triangle];
      if (turned_[f]) std::swap(t[1], t[2]);
    }
  }

 private:
  // Signed volume between the face and the centre.
  double volume(std::uint32_t f) const {
    const Shape& shape = *group_[faces_[f].shape];
    const Triangle& t = shape.triangles[faces_[f].triangle];
    const double v =
        exact::dot(shape.positions[t[0]] - centre_,
                   exact::cross(shape.positions[t[1]] - centre_, shape.positions[t[2]] - centre_)) /
        6.0;
    return turned_[f] ? -v : v;
  }

  const std::vector<Shape*>& group_;
  const std::vector<Face>& faces_;
  std::vector<bool> turned_;
  glm::dvec3 centre_{0};
  double extent_ = 0;
};

std::size_t Orientation::reconcile(const std::vector<Neighbours>& pairs) {
  // Neighbour lists, one after the other; entry = pair number.
  std::vector<std::uint32_t> start(faces_.size() + 1, 0), lists(pairs.size() * 2);
  for (const Neighbours& pair : pairs) ++start[pair.a + 1], ++start[pair.b + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<std::uint32_t> fill(start.begin(), start.end() - 1);
  for (std::uint32_t i = 0; i < pairs.size(); ++i) {
    lists[fill[pairs[i].a]++] = i;
    lists[fill[pairs[i].b]++] = i;
  }
  std::vector<bool> seen(faces_.size(), false);
  std::vector<std::uint32_t> part;
  std::size_t count = 0;
  for (std::uint32_t seed = 0; seed < faces_.size(); ++seed) {
    if (seen[seed]) continue;
    part.assign(1, seed);
    seen[seed] = true;
    bool disagreed = false;
    for (std::size_t next = 0; next < part.size(); ++next) {
      const std::uint32_t face = part[next];
      for (std::uint32_t k = start[face]; k < start[face + 1]; ++k) {
        const Neighbours& pair = pairs[lists[k]];
        const std::uint32_t other = pair.a == face ? pair.b : pair.a;
        if (!pair.agree) disagreed = true;
        if (seen[other]) continue;
        seen[other] = true;
        turned_[other] = turned_[face] != !pair.agree;
        part.push_back(other);
      }
    }
    if (!disagreed) continue;
    double sum = 0;
    for (const std::uint32_t face : part) sum += volume(face);
    for (const std::uint32_t face : part) {
      if (sum < 0) turned_[face] = !turned_[face];
      count += turned_[face];
    }
  }
  return count;
}

}  // namespace

std::size_t drop_degenerate(Shape& shape) {
  const auto flat = [&](const Triangle& t) {
    const glm::dvec3 &a = shape.positions[t[0]], &b = shape.positions[t[1]];
    const glm::dvec3& c = shape.positions[t[2]];
    const double longest = std::max({exact::length(b - a), exact::length(c - b), exact::length(a - c)});
    // No area, or too flat or too small (a picometre) for single precision to give it a direction.
    return !(longest > 1e-12) || !(exact::length(exact::cross(b - a, c - a)) > 1e-10 * longest * longest);
  };
  return std::erase_if(shape.triangles, flat);
}

void join_group(Context& context, const std::vector<Shape*>& group, bool solid) {
  std::vector<Face> faces = faces_of(group);
  if (faces.empty()) return;
  const std::string& name = group.front()->name;
  if (const std::size_t doubles = drop_doubles(group, faces)) {
    context.note(name + ": " + std::to_string(doubles) + " triangles given twice were dropped.");
  }
  const Edges edges = examine_edges(group, faces);
  for (Shape* shape : group) shape->closedness = edges.closedness;
  if (edges.closedness < 0.9f) return;
  Orientation orientation(group, faces);
  if (!solid) {
    for (Shape* shape : group) shape->inside_out = orientation.inside_out();
    return;
  }
  const std::size_t turned = orientation.reconcile(edges.pairs);
  if (turned > 0) {
    context.note(name + ": " + std::to_string(turned) +
                 " triangles faced against their neighbours and were turned round.");
  }
  if (orientation.inside_out()) {
    orientation.turn_all();
    context.note(name + " was inside out (its triangles face inwards) and was turned.");
  }
  orientation.apply();
}

}  // namespace caustics::gltf
