#include "pipeline/renderer/water_surface.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/scene/exact.hpp"

namespace caustics {

namespace {

// Height and slopes along columns and rows.
struct Sample {
  double height = 0.0, x = 0.0, z = 0.0;
};

Sample blend(const Sample& a, const Sample& b, double t) {
  const double s = 1.0 - t;
  return {a.height * s + b.height * t, a.x * s + b.x * t, a.z * s + b.z * t};
}

// The cells' heights and slopes, mirrored at the walls.
class Field {
 public:
  Field(const Water& water, const Image& state, double lead)
      : columns_(water.columns), rows_(water.rows), cells_(static_cast<std::size_t>(columns_ * rows_)) {
    for (int j = 0; j < rows_; ++j)
      for (int i = 0; i < columns_; ++i)
        cell(i, j).height =
            std::clamp(static_cast<double>(state.at(i, j, 0)) - lead * static_cast<double>(state.at(i, j, 1)),
                       -water.highest, water.highest);
    for (int j = 0; j < rows_; ++j)
      for (int i = 0; i < columns_; ++i) {
        cell(i, j).x = (height(i + 1, j) - height(i - 1, j)) / (2.0 * water.dx);
        cell(i, j).z = (height(i, j + 1) - height(i, j - 1)) / (2.0 * water.dz);
      }
  }

  // Of a cell, or one beyond a wall: the mirror image of the cell before it.
  Sample at(int i, int j) const {
    Sample s = cells_[index(i, j)];
    if (i < 0 || i >= columns_) s.x = -s.x;
    if (j < 0 || j >= rows_) s.z = -s.z;
    return s;
  }

 private:
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(std::clamp(j, 0, rows_ - 1) * columns_ + std::clamp(i, 0, columns_ - 1));
  }
  Sample& cell(int i, int j) { return cells_[index(i, j)]; }
  double height(int i, int j) const { return cells_[index(i, j)].height; }

  int columns_, rows_;
  std::vector<Sample> cells_;
};

// Slopes too small to tilt anything would only be numbers that some devices flush to 0 and others not.
double told(double slope) { return std::fabs(slope) < 1e-20 ? 0.0 : slope; }

glm::vec3 tilted(const glm::vec3& rest, const glm::dvec3& slope) {
  const glm::dvec3 n(rest);
  const glm::dvec3 sum(n.x / n.y - slope.x, 1.0, n.z / n.y - slope.z);
  const glm::dvec3 unit = exact::normalise({told(sum.x), 1.0, told(sum.z)}, {0.0, 1.0, 0.0});
  return glm::vec3(unit);
}

}  // namespace

WaterSurface::WaterSurface(const Water& water, const Mesh& mesh) : water_(water), rest_(mesh.vertices) {
  places_.reserve(rest_.size());
  for (const Vertex& v : rest_) {
    const glm::dvec3 from = glm::dvec3(v.position) - water.corner;
    const double x = exact::dot(from, water.right) / water.dx - 0.5;
    const double z = exact::dot(from, water.across) / water.dz - 0.5;
    const double column = std::clamp(std::floor(x), -1.0, water.columns - 1.0);
    const double row = std::clamp(std::floor(z), -1.0, water.rows - 1.0);
    places_.push_back({static_cast<int>(column), static_cast<int>(row), std::clamp(x - column, 0.0, 1.0),
                       std::clamp(z - row, 0.0, 1.0)});
  }
}

void WaterSurface::displace(const Image& state, double lead, Mesh& mesh) const {
  const Field field(water_, state, lead);
  for (std::size_t v = 0; v < rest_.size(); ++v) {
    const Place& p = places_[v];
    const Sample s = blend(blend(field.at(p.column, p.row), field.at(p.column + 1, p.row), p.x),
                           blend(field.at(p.column, p.row + 1), field.at(p.column + 1, p.row + 1), p.x), p.z);
    Vertex& vertex = mesh.vertices[v];
    vertex.position.y = static_cast<float>(static_cast<double>(rest_[v].position.y) + s.height);
    vertex.normal = tilted(rest_[v].normal, water_.right * s.x + water_.across * s.z);
  }
}

void WaterSurface::level(double height, Mesh& mesh) const {
  for (std::size_t v = 0; v < rest_.size(); ++v) {
    mesh.vertices[v] = rest_[v];
    mesh.vertices[v].position.y += static_cast<float>(height);
  }
}

}  // namespace caustics
