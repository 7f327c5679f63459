#include "pipeline/scene/gltf/weld.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace caustics::gltf {

namespace {

constexpr double kTolerance = 1e-6;  // of the extent

// A cell's three numbers in one, in the order x, y, z. Positions are at most a million cells from the corner;
// 1 is added to each number, so that those of neighbours are not below 0 and need no more than 21 bits.
using Cell = std::uint64_t;
constexpr int kBits = 21;

Cell cell_of(const glm::dvec3& p) {
  const auto number = [](double c) { return static_cast<Cell>(c) + 1; };
  return number(p.x) << 2 * kBits | number(p.y) << kBits | number(p.z);
}

// What lies between a cell and the one that is so many further.
Cell step(int x, int y, int z) {
  const auto part = [](int n) { return static_cast<Cell>(static_cast<std::int64_t>(n)); };
  return (part(x) << 2 * kBits) + (part(y) << kBits) + part(z);
}

// The vertices sorted into cells as wide as the tolerance. All vertices of a cell are one place;
// cells that touch are one place when their first vertices are within the tolerance.
class Grid {
 public:
  explicit Grid(const std::vector<Shape*>& group) {
    std::size_t count = 0;
    for (const Shape* shape : group) count += shape->positions.size();
    positions_.reserve(count);
    glm::dvec3 lower(std::numeric_limits<double>::infinity()), upper = -lower;
    for (const Shape* shape : group) {
      for (const glm::dvec3& p : shape->positions) {
        positions_.push_back(&p);
        lower = glm::min(lower, p);
        upper = glm::max(upper, p);
      }
    }
    width_ = std::max(kTolerance * exact::length(upper - lower), 1e-300);
    order_.reserve(count);
    // The cells lie round the grid's nodes.
    for (std::uint32_t i = 0; i < count; ++i)
      order_.push_back({cell_of((*positions_[i] - lower) / width_ + 0.5), i});
    std::sort(order_.begin(), order_.end(), [](const Place& a, const Place& b) {
      return a.cell != b.cell ? a.cell < b.cell : a.vertex < b.vertex;
    });
    for (std::uint32_t i = 0; i < order_.size(); ++i) {
      if (i == 0 || order_[i].cell != order_[i - 1].cell) first_.push_back(i);
    }
    parent_.resize(first_.size());
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  std::vector<std::uint32_t> places() {
    join_neighbours();
    std::vector<std::uint32_t> result(positions_.size());
    for (std::uint32_t c = 0; c < first_.size(); ++c) {
      const std::uint32_t end =
          c + 1 < first_.size() ? first_[c + 1] : static_cast<std::uint32_t>(order_.size());
      const std::uint32_t place = order_[first_[root(c)]].vertex;
      for (std::uint32_t i = first_[c]; i < end; ++i) result[order_[i].vertex] = place;
    }
    return result;
  }

 private:
  struct Place {
    Cell cell;
    std::uint32_t vertex;
  };

  const glm::dvec3& place_of(std::uint32_t c) const { return *positions_[order_[first_[c]].vertex]; }
  Cell cell(std::uint32_t c) const { return order_[first_[c]].cell; }

  // Joins every cell with those of its 13 neighbours that come later in the order. The three along z follow
  // each other; as the cell goes on, so does each row of three: none is searched for.
  void join_neighbours() {
    const auto count = static_cast<std::uint32_t>(first_.size());
    for (int dx = 0; dx <= 1; ++dx) {
      for (int dy = -dx; dy <= 1; ++dy) {
        const Cell from = step(dx, dy, dx == 0 && dy == 0 ? 1 : -1), last = step(dx, dy, 1);
        std::uint32_t next = 0;
        for (std::uint32_t c = 0; c < count; ++c) {
          while (next < count && cell(next) < cell(c) + from) ++next;
          for (std::uint32_t i = next; i < count && cell(i) <= cell(c) + last; ++i) join(c, i);
        }
      }
    }
  }

  void join(std::uint32_t a, std::uint32_t b) {
    if (exact::length(place_of(a) - place_of(b)) > width_) return;
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

  std::uint32_t root(std::uint32_t c) {
    while (parent_[c] != c) c = parent_[c] = parent_[parent_[c]];
    return c;
  }

  std::vector<const glm::dvec3*> positions_;
  double width_ = 1;
  std::vector<Place> order_;           // by cell
  std::vector<std::uint32_t> first_;   // where each cell begins in order_
  std::vector<std::uint32_t> parent_;  // of each cell: the cell that it was joined to
};

}  // namespace

std::vector<std::uint32_t> weld(const std::vector<Shape*>& group) { return Grid(group).places(); }

}  // namespace caustics::gltf
