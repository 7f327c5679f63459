// Recognises the circular cylinder that a mesh stands for.
#include <algorithm>
#include <cmath>

#include "lab/reference/tracer/exact_cylinder.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/scene/exact.hpp"

namespace caustics::tracer {

namespace {

constexpr double kThousandth = 1e-3;
// Cosine of the most by which a smooth wall's normals may lean: facets of a prism lean more.
constexpr double kSmooth = 0.99;
// A lid's polygon has less area than its circle: of eight corners 0.90 of it.
constexpr double kLeastOfLid = 0.9;

// A triangle with an area.
struct Face {
  std::size_t first;  // of its corners, in Mesh::indices
  glm::dvec3 normal;  // unit, outward
  double area;
};

// A corner in cylinder coordinates.
struct Corner {
  double radius, turn, height;
  double facing;  // cosine of the angle from the axis' outward direction to the vertex's normal
};

class CylinderFit {
 public:
  explicit CylinderFit(const Mesh& mesh) : mesh_(mesh) {}

  ExactCylinder fit() {
    list_faces();
    find_axis();
    find_foot();
    find_walls();
    find_heights();
    measure_walls();
    find_lids();
    cylinder_.foot += cylinder_.axis * lowest_;
    cylinder_.height = highest_ - lowest_;
    return cylinder_;
  }

 private:
  [[noreturn]] void refuse(const char* why) const {
    throw Error(ExitCode::BadInput, "mesh '" + mesh_.name + "' is no cylinder: " + why);
  }
  const Vertex& vertex(std::size_t index) const { return mesh_.vertices[mesh_.indices[index]]; }
  const Vertex& vertex(const Face& face, std::size_t corner) const { return vertex(face.first + corner); }

  void list_faces() {
    for (std::size_t i = 0; i < mesh_.indices.size(); i += 3) {
      const auto at = [&](std::size_t corner) { return glm::dvec3(vertex(i + corner).position); };
      const glm::dvec3 across = exact::cross(at(1) - at(0), at(2) - at(0));
      const Face face{i, exact::normalise(across, glm::dvec3(0.0)), 0.5 * exact::length(across)};
      if (face.area > 0.0) faces_.push_back(face);
    }
    if (faces_.empty()) refuse("it has no triangles");
  }

  // Every face lies along the axis (a wall) or across it (a lid).
  static bool along(const Face& face, const glm::dvec3& axis) {
    return std::fabs(exact::dot(face.normal, axis)) < kThousandth;
  }
  static bool lies_across(const Face& face, const glm::dvec3& axis) {
    return std::fabs(exact::dot(face.normal, axis)) > 1.0 - 0.5 * kThousandth * kThousandth;
  }

  // Two faces that are not parallel: both are walls, or one is a lid.
  void find_axis() {
    const glm::dvec3 first = faces_[0].normal;
    const auto other = std::min_element(faces_.begin(), faces_.end(), [&](const Face& a, const Face& b) {
      return std::fabs(exact::dot(a.normal, first)) < std::fabs(exact::dot(b.normal, first));
    });
    const glm::dvec3 both = exact::normalise(exact::cross(first, other->normal), first);
    for (const glm::dvec3& candidate : {both, first, other->normal}) {
      const bool fits = std::all_of(faces_.begin(), faces_.end(), [&](const Face& face) {
        return along(face, candidate) || lies_across(face, candidate);
      });
      if (fits &&
          std::any_of(faces_.begin(), faces_.end(), [&](const Face& f) { return along(f, candidate); })) {
        cylinder_.axis = refined(candidate);
        split();
        return;
      }
    }
    refuse("its triangles must lie along one axis or across it");
  }

  // The direction that the walls' normals have least of: inverse iteration on the sum of their squares.
  glm::dvec3 refined(glm::dvec3 axis) const {
    glm::dmat3 sum(0.0);
    double area = 0.0;
    for (const Face& face : faces_) {
      if (!along(face, axis)) continue;
      sum += face.area * glm::outerProduct(face.normal, face.normal);
      area += face.area;
    }
    const glm::dmat3 inverse = glm::inverse(sum + glm::dmat3(1e-10 * area));
    for (int i = 0; i < 4; ++i) axis = exact::normalise(inverse * axis, axis);
    return axis;
  }

  void split() {
    for (const Face& face : faces_) (along(face, cylinder_.axis) ? walls_ : lids_).push_back(face);
    if (walls_.empty()) refuse("its triangles must lie along one axis or across it");
    x_ = exact::perpendicular(cylinder_.axis);
    y_ = exact::cross(cylinder_.axis, x_);
    cylinder_.middle = x_;
  }

  // The point that the normals of all the walls' vertices aim at.
  void find_foot() {
    glm::dmat2 sum(0.0);
    glm::dvec2 aim(0.0);
    for (const Face& face : walls_)
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const glm::dvec3 p(vertex(face, corner).position), n(vertex(face, corner).normal);
        const glm::dvec2 q(exact::dot(p, x_), exact::dot(p, y_)), m(exact::dot(n, x_), exact::dot(n, y_));
        const glm::dmat2 off = glm::dmat2(glm::dot(m, m)) - glm::outerProduct(m, m);
        sum += off;
        aim += off * q;
      }
    if (!(glm::determinant(sum) > 1e-12 * sum[0][0] * sum[1][1])) refuse("its walls are flat");
    const glm::dvec2 centre = glm::inverse(sum) * aim;
    cylinder_.foot = x_ * centre.x + y_ * centre.y;
  }

  Corner corner_of(const Face& face, std::size_t number) const {
    const Vertex& v = vertex(face, number);
    const glm::dvec3 p = glm::dvec3(v.position) - cylinder_.foot;
    const double x = exact::dot(p, x_), y = exact::dot(p, y_), radius = std::hypot(x, y);
    const glm::dvec3 out = exact::normalise(x_ * x + y_ * y, x_);
    return {radius, std::atan2(y, x), exact::dot(p, cylinder_.axis), exact::dot(out, glm::dvec3(v.normal))};
  }

  // One wall, or two where the radii have two values.
  void find_walls() {
    double least = std::numeric_limits<double>::infinity(), most = 0.0;
    for (const Face& face : walls_)
      for (std::size_t c = 0; c < 3; ++c) {
        least = std::min(least, corner_of(face, c).radius);
        most = std::max(most, corner_of(face, c).radius);
      }
    tolerance_ = kThousandth * most;
    split_at_ = most - least > 2.0 * tolerance_ ? 0.5 * (least + most) : 0.0;
    double sums[2] = {}, counts[2] = {};
    for (const Face& face : walls_)
      for (std::size_t c = 0; c < 3; ++c) {
        const double radius = corner_of(face, c).radius;
        const int wall = radius < split_at_ ? 1 : 0;
        sums[wall] += radius;
        counts[wall] += 1.0;
      }
    for (int wall = 0; wall < (split_at_ > 0.0 ? 2 : 1); ++wall)
      cylinder_.walls.push_back({.radius = sums[wall] / counts[wall], .outward = 0.0});
    for (const Face& face : walls_) place_on_wall(face);
  }

  std::size_t wall_of(const Face& face) const { return corner_of(face, 0).radius < split_at_ ? 1 : 0; }

  void place_on_wall(const Face& face) {
    ExactCylinder::Wall& wall = cylinder_.walls[wall_of(face)];
    for (std::size_t c = 0; c < 3; ++c) {
      const Corner corner = corner_of(face, c);
      if (!(std::fabs(corner.radius - wall.radius) <= tolerance_))
        refuse("its walls' vertices must lie on one or two cylinders of one axis to a thousandth");
      const double outward = corner.facing > 0.0 ? 1.0 : -1.0;
      if (wall.outward == 0.0) wall.outward = outward;
      if (!(corner.facing * wall.outward > kSmooth) ||
          !(exact::dot(face.normal, glm::dvec3(vertex(face, c).normal)) > 0.0))
        refuse("its walls' normals must point straight away from the axis, or to it");
    }
  }

  void find_heights() {
    lowest_ = std::numeric_limits<double>::infinity();
    highest_ = -lowest_;
    for (const Face& face : walls_)
      for (std::size_t c = 0; c < 3; ++c) {
        lowest_ = std::min(lowest_, corner_of(face, c).height);
        highest_ = std::max(highest_, corner_of(face, c).height);
      }
  }

  // Each wall unrolled must be a rectangle: all around, or of a single wall an arc.
  void measure_walls() {
    double arcs[2] = {};
    for (const Face& face : walls_) {
      const Corner a = corner_of(face, 0), b = corner_of(face, 1), c = corner_of(face, 2);
      const double ab = std::remainder(b.turn - a.turn, 2.0 * exact::kPi),
                   ac = std::remainder(c.turn - a.turn, 2.0 * exact::kPi);
      arcs[wall_of(face)] += 0.5 * std::fabs(ab * (c.height - a.height) - ac * (b.height - a.height));
    }
    for (std::size_t wall = 0; wall < cylinder_.walls.size(); ++wall) {
      const double arc = arcs[wall] / (highest_ - lowest_);
      if (std::fabs(arc - 2.0 * exact::kPi) <= kThousandth * 2.0 * exact::kPi) continue;
      if (cylinder_.walls.size() > 1 || !lids_.empty() || !lies_between_gap(arc))
        refuse("its walls must reach from one height to another without holes, and around the axis");
    }
  }

  // Is the wall all of the circle but the widest gap between its vertices?
  bool lies_between_gap(double arc) {
    std::vector<double> turns;
    for (const Face& face : walls_)
      for (std::size_t c = 0; c < 3; ++c) turns.push_back(corner_of(face, c).turn);
    std::sort(turns.begin(), turns.end());
    double gap = turns.front() + 2.0 * exact::kPi - turns.back(), behind = turns.back();
    for (std::size_t i = 1; i < turns.size(); ++i)
      if (turns[i] - turns[i - 1] > gap) {
        gap = turns[i] - turns[i - 1];
        behind = turns[i - 1];
      }
    if (!(std::fabs(2.0 * exact::kPi - gap - arc) <= kThousandth * arc)) return false;
    const double opposite = behind + 0.5 * gap;  // the gap's middle
    cylinder_.middle = -(x_ * std::cos(opposite) + y_ * std::sin(opposite));
    cylinder_.least_cosine = std::cos(exact::kPi - 0.5 * gap);
    return true;
  }

  void find_lids() {
    const double inner = cylinder_.walls.size() > 1 ? cylinder_.walls[1].radius : 0.0;
    const double outer = cylinder_.walls[0].radius, whole = exact::kPi * (outer * outer - inner * inner);
    double areas[2] = {};
    for (const Face& face : lids_) {
      const bool upper = exact::dot(face.normal, cylinder_.axis) > 0.0;
      for (std::size_t c = 0; c < 3; ++c) {
        const Corner corner = corner_of(face, c);
        if (!(std::fabs(corner.height - (upper ? highest_ : lowest_)) <= tolerance_) ||
            !(corner.radius >= inner - tolerance_ && corner.radius <= outer + tolerance_))
          refuse("its lids must lie at the rims of its walls and look outward");
      }
      areas[upper ? 1 : 0] += face.area;
    }
    for (const double area : areas)
      if (area > 0.0 && !(area >= kLeastOfLid * whole && area <= (1.0 + kThousandth) * whole))
        refuse("its lids must reach from wall to wall without holes");
    cylinder_.lower_lid = areas[0] > 0.0;
    cylinder_.upper_lid = areas[1] > 0.0;
    if (lids_.empty()) return;
    const auto outward = [&](std::size_t wall) { return cylinder_.walls[wall].outward; };
    if (outward(0) < 0.0 || (cylinder_.walls.size() > 1 && outward(1) > 0.0))
      refuse("walls with lids must look outward");
  }

  const Mesh& mesh_;
  ExactCylinder cylinder_;
  std::vector<Face> faces_, walls_, lids_;
  glm::dvec3 x_{0.0}, y_{0.0};  // across the axis
  double tolerance_ = 0.0, split_at_ = 0.0, lowest_ = 0.0, highest_ = 0.0;
};

}  // namespace

ExactCylinder cylinder_of(const Mesh& mesh) { return CylinderFit(mesh).fit(); }

}  // namespace caustics::tracer
