#include "pipeline/scene/gltf/weld.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace caustics::gltf {

namespace {

constexpr double kTolerance = 1e-6;  // of the extent

using Cell = std::array<std::int64_t, 3>;

// The vertices sorted into cells as wide as the tolerance. All vertices of a cell are one place;
// cells that touch are one place when their first vertices are within the tolerance.
class Grid {
 public:
  explicit Grid(const std::vector<Shape*>& group) {
    glm::dvec3 lower(std::numeric_limits<double>::infinity()), upper = -lower;
    for (const Shape* shape : group) {
      for (const glm::dvec3& p : shape->positions) {
        positions_.push_back(&p);
        lower = glm::min(lower, p);
        upper = glm::max(upper, p);
      }
    }
    lower_ = lower;
    width_ = std::max(kTolerance * exact::length(upper - lower), 1e-300);
    order_.resize(positions_.size());
    std::iota(order_.begin(), order_.end(), 0u);
    std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
      const Cell p = cell(a), q = cell(b);
      return p != q ? p < q : a < b;
    });
    for (std::uint32_t i = 0; i < order_.size(); ++i) {
      if (i == 0 || cell(order_[i]) != cell(order_[i - 1])) first_.push_back(i);
    }
    parent_.resize(first_.size());
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  std::vector<std::uint32_t> places() {
    for (std::uint32_t c = 0; c < first_.size(); ++c) join_neighbours(c);
    std::vector<std::uint32_t> result(positions_.size());
    for (std::uint32_t c = 0; c < first_.size(); ++c) {
      const std::uint32_t end =
          c + 1 < first_.size() ? first_[c + 1] : static_cast<std::uint32_t>(order_.size());
      const std::uint32_t place = order_[first_[root(c)]];
      for (std::uint32_t i = first_[c]; i < end; ++i) result[order_[i]] = place;
    }
    return result;
  }

 private:
  Cell cell(std::uint32_t vertex) const {
    // The cells lie round the grid's nodes; positions are at most a million cells from the corner.
    const glm::dvec3 p = (*positions_[vertex] - lower_) / width_ + 0.5;
    return {static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y), static_cast<std::int64_t>(p.z)};
  }

  const glm::dvec3& place_of(std::uint32_t c) const { return *positions_[order_[first_[c]]]; }

  // Joins cell c with those of its 13 neighbours that come later in the order.
  void join_neighbours(std::uint32_t c) {
    const Cell here = cell(order_[first_[c]]);
    for (std::int64_t dx = 0; dx <= 1; ++dx) {
      for (std::int64_t dy = -dx; dy <= 1; ++dy) {
        // The three cells along z are neighbours in the order: one search finds them.
        const bool own_column = dx == 0 && dy == 0;
        const Cell from{here[0] + dx, here[1] + dy, own_column ? here[2] + 1 : here[2] - 1};
        const Cell last{here[0] + dx, here[1] + dy, here[2] + 1};
        auto next = std::lower_bound(first_.begin() + c, first_.end(), from,
                                     [&](std::uint32_t i, const Cell& key) { return cell(order_[i]) < key; });
        for (; next != first_.end() && cell(order_[*next]) <= last; ++next) {
          join(c, static_cast<std::uint32_t>(next - first_.begin()));
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
  glm::dvec3 lower_{0};
  double width_ = 1;
  std::vector<std::uint32_t> order_;   // vertices by cell
  std::vector<std::uint32_t> first_;   // where each cell begins in order_
  std::vector<std::uint32_t> parent_;  // of each cell: the cell that it was joined to
};

}  // namespace

std::vector<std::uint32_t> weld(const std::vector<Shape*>& group) { return Grid(group).places(); }

}  // namespace caustics::gltf
