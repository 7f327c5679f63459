#include "pipeline/measure/splat_counts.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/measure/ledger.hpp"
#include "pipeline/shader/constants.hpp"

namespace caustics {

namespace {

// How far a footprint reaches from its middle, texels, and a little farther
// (passes/caustic_footprints/caustic_footprints.glsl).
glm::dvec2 footprint_reach(const ImageView& footprint, int x, int y, int map) {
  const glm::dvec2 steps(std::fabs(footprint.at(x, y, 0)) + std::fabs(footprint.at(x, y, 2)),
                         std::fabs(footprint.at(x, y, 1)) + std::fabs(footprint.at(x, y, 3)));
  return glm::min(0.5 * map * steps, glm::dvec2(kLargestFootprint / 2.0)) + 1.0;
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

SplatCounts::SplatCounts(const SplatKernel& kernel, const View& view, int map)
    : kernel_(kernel), view_(view), map_(map), marks_(stride() * stride()) {}

void SplatCounts::add(const BranchImages& images, const CellImages& cells) {
  add_landings(images);
  add_cells(images, cells);
}

void SplatCounts::add_landings(const BranchImages& images) {
  const std140::View uniforms = shader_view(view_);
  for (int y = 0; y < images.landing.height(); ++y)
    for (int x = 0; x < images.landing.width(); ++x) {
      if (!is_drawn(static_cast<LandingStatus>(static_cast<int>(images.landing.at(x, y, 3))))) continue;
      if (share_of_points(images.cell_flux, x, y) <= 0.0) continue;
      const glm::dvec2 texel = texel_of(images, x, y, uniforms, map_);
      const glm::dvec2 reach = images.footprint.values.empty()
                                   ? glm::dvec2(kernel_.radius)
                                   : footprint_reach(images.footprint, x, y, map_);
      add_rectangle(texel - reach, texel + reach);
    }
}

void SplatCounts::add_cells(const BranchImages& images, const CellImages& cells) {
  if (images.cell_flux.values.empty() || cells.near.values.empty()) return;
  const auto corner = [](const ImageView& image, int x, int y, int channel) {
    return glm::dvec2(image.at(x, y, channel), image.at(x, y, channel + 1));
  };
  for (int y = 0; y < cells.near.height(); ++y)
    for (int x = 0; x < cells.near.width(); ++x) {
      if (images.cell_flux.at(x, y, 3) == 0.0f) continue;
      const glm::dvec2 a = corner(cells.near, x, y, 0), b = corner(cells.near, x, y, 2),
                       c = corner(cells.far, x, y, 0), d = corner(cells.far, x, y, 2);
      add_rectangle(glm::min(glm::min(a, b), glm::min(c, d)), glm::max(glm::max(a, b), glm::max(c, d)));
    }
}

// Every texel that the rectangle touches; corners in texels.
void SplatCounts::add_rectangle(const glm::dvec2& lower, const glm::dvec2& upper) {
  const std::size_t x0 = column(lower.x), x1 = column(upper.x) + 1, y0 = column(lower.y),
                    y1 = column(upper.y) + 1;
  ++marks_[y0 * stride() + x0];
  --marks_[y0 * stride() + x1];
  --marks_[y1 * stride() + x0];
  ++marks_[y1 * stride() + x1];
}

// Beyond the edge: the outermost texel, which then counts too many.
std::size_t SplatCounts::column(double texel) const {
  return static_cast<std::size_t>(std::clamp(std::floor(texel), 0.0, static_cast<double>(map_ - 1)));
}

std::vector<std::uint32_t> SplatCounts::by_texel() const {
  const auto side = static_cast<std::size_t>(map_);
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

}  // namespace caustics
