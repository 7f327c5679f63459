#include "pipeline/measure/splat_counts.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/measure/ledger.hpp"
#include "pipeline/shader/constants.hpp"

namespace caustics {

namespace {

// Counts rectangles of texels: each is marked at its corners, and one running sum along both axes counts them
// all.
class RectangleCounts {
 public:
  explicit RectangleCounts(int side) : side_(side), marks_(stride() * stride()) {}

  // Every texel that the rectangle touches; corners in texels.
  void add(const glm::dvec2& lower, const glm::dvec2& upper) {
    const std::size_t x0 = column(lower.x), x1 = column(upper.x) + 1, y0 = column(lower.y),
                      y1 = column(upper.y) + 1;
    ++marks_[y0 * stride() + x0];
    --marks_[y0 * stride() + x1];
    --marks_[y1 * stride() + x0];
    ++marks_[y1 * stride() + x1];
  }

  std::vector<std::uint32_t> counts() const {
    const auto side = static_cast<std::size_t>(side_);
    std::vector<std::uint32_t> result(side * side);
    std::vector<std::int32_t> above(side);
    for (std::size_t y = 0; y < side; ++y) {
      std::int32_t row = 0;
      for (std::size_t x = 0; x < side; ++x) {
        row += marks_[y * stride() + x];
        above[x] += row;
        result[y * side + x] = static_cast<std::uint32_t>(above[x]);
      }
    }
    return result;
  }

 private:
  std::size_t stride() const { return static_cast<std::size_t>(side_) + 1; }
  // Beyond the edge: the outermost texel, which then counts too many.
  std::size_t column(double texel) const {
    return static_cast<std::size_t>(std::clamp(std::floor(texel), 0.0, static_cast<double>(side_ - 1)));
  }

  int side_;
  std::vector<std::int32_t> marks_;
};

// How far a footprint reaches from its middle, texels, and a little farther
// (passes/caustic_footprints/caustic_footprints.glsl).
glm::dvec2 footprint_reach(const ImageView& footprint, int x, int y, int map) {
  const glm::dvec2 steps(std::fabs(footprint.at(x, y, 0)) + std::fabs(footprint.at(x, y, 2)),
                         std::fabs(footprint.at(x, y, 1)) + std::fabs(footprint.at(x, y, 3)));
  return glm::min(0.5 * map * steps, glm::dvec2(kLargestFootprint / 2.0)) + 1.0;
}

void add_landings(const BranchImages& images, const SplatKernel& kernel, const View& view, int map,
                  RectangleCounts& counts) {
  const std140::View uniforms = shader_view(view);
  for (int y = 0; y < images.landing.height(); ++y)
    for (int x = 0; x < images.landing.width(); ++x) {
      if (!is_drawn(static_cast<LandingStatus>(static_cast<int>(images.landing.at(x, y, 3))))) continue;
      if (share_of_points(images.cell_flux, x, y) <= 0.0) continue;
      const glm::dvec2 texel = texel_of(images, x, y, uniforms, map);
      const glm::dvec2 reach = images.footprint.values.empty() ? glm::dvec2(kernel.radius)
                                                               : footprint_reach(images.footprint, x, y, map);
      counts.add(texel - reach, texel + reach);
    }
}

void add_cells(const BranchImages& images, const CellImages& cells, RectangleCounts& counts) {
  if (images.cell_flux.values.empty() || cells.near.values.empty()) return;
  const auto corner = [](const ImageView& image, int x, int y, int channel) {
    return glm::dvec2(image.at(x, y, channel), image.at(x, y, channel + 1));
  };
  for (int y = 0; y < cells.near.height(); ++y)
    for (int x = 0; x < cells.near.width(); ++x) {
      if (images.cell_flux.at(x, y, 3) == 0.0f) continue;
      const glm::dvec2 a = corner(cells.near, x, y, 0), b = corner(cells.near, x, y, 2),
                       c = corner(cells.far, x, y, 0), d = corner(cells.far, x, y, 2);
      counts.add(glm::min(glm::min(a, b), glm::min(c, d)), glm::max(glm::max(a, b), glm::max(c, d)));
    }
}

}  // namespace

glm::dvec2 texel_of(const BranchImages& images, int x, int y, const std140::View& view, int map) {
  const glm::vec3 p{images.landing.at(x, y, 0), images.landing.at(x, y, 1), images.landing.at(x, y, 2)};
  const auto along = [&](int row) {
    const glm::mat4& m = view.from_scene;
    return ((m[0][row] * p.x + m[1][row] * p.y) + m[2][row] * p.z) + m[3][row];
  };
  const float w = view.kind != VIEW_PARALLEL ? along(2) : 1.0f;
  const auto side = static_cast<float>(map);
  return {(along(0) / w * view.scale.x + view.offset.x) * side,
          (along(1) / w * view.scale.y + view.offset.y) * side};
}

std::vector<std::uint32_t> splat_counts(const std::vector<BranchImages>& branches,
                                        const std::vector<CellImages>& cells, const SplatKernel& kernel,
                                        const View& view, int map) {
  RectangleCounts counts(map);
  for (std::size_t b = 0; b < branches.size(); ++b) {
    add_landings(branches[b], kernel, view, map, counts);
    if (b < cells.size()) add_cells(branches[b], cells[b], counts);
  }
  return counts.counts();
}

}  // namespace caustics
