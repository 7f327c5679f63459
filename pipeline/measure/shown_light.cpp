#include "pipeline/measure/shown_light.hpp"

#include "pipeline/settings/splat_kernel.hpp"

namespace caustics {

void TexelPlane::add(const glm::dvec2& texel, double value) {
  const int x = static_cast<int>(std::floor(texel.x)), y = static_cast<int>(std::floor(texel.y));
  if (x >= 0 && y >= 0 && x < side_ && y < side_) at(x, y) += value;
}

double TexelPlane::absolute_sum(const glm::dvec2& box) const {
  const TexelPlane averaged = along(std::max(box.x, 1.0), 1, 0).along(std::max(box.y, 1.0), 0, 1);
  double sum = 0.0;
  for (const double v : averaged.values_) sum += std::fabs(v);
  return sum;
}

// Means over `side` texels along an axis, by running sums; the outermost texels of a box count by the share
// that lies in it, and beyond the map there is nothing.
TexelPlane TexelPlane::along(double side, int dx, int dy) const {
  if (side <= 1.0) return *this;
  TexelPlane result(side_);
  std::vector<double> sums(static_cast<std::size_t>(side_) + 1);
  const double box = std::min(side, 2.0 * side_);
  for (int line = 0; line < side_; ++line) {
    const auto value = [&](int k) { return at(dx ? k : line, dy ? k : line); };
    for (int k = 0; k < side_; ++k)
      sums[static_cast<std::size_t>(k) + 1] = sums[static_cast<std::size_t>(k)] + value(k);
    const auto up_to = [&](double t) {
      const double inside = std::clamp(t, 0.0, static_cast<double>(side_));
      const int whole = std::min(static_cast<int>(inside), side_ - 1);
      return sums[static_cast<std::size_t>(whole)] + (inside - whole) * value(whole);
    };
    for (int k = 0; k < side_; ++k)
      result.at(dx ? k : line, dy ? k : line) =
          (up_to(k + 0.5 + 0.5 * box) - up_to(k + 0.5 - 0.5 * box)) / side;
  }
  return result;
}

ShownMaps::ShownMaps(const LightViews& views, const Settings& settings, int map_side, bool cascade)
    : side(map_side), has_cascade(cascade && views.cascade) {
  if (!has_cascade) return;
  const glm::dvec2 whole = views.caustic.window_upper - views.caustic.window_lower;
  const glm::dvec2 part = views.cascade->window_upper - views.cascade->window_lower;
  scale = whole / part;
  offset = (views.caustic.window_lower - views.cascade->window_lower) / part * static_cast<double>(side);
  border = splat_kernel(settings).radius + 1.0;
}

bool ShownMaps::cascade_shows(const glm::dvec2& texel) const {
  if (!has_cascade) return false;
  const glm::dvec2 p = in_cascade(texel);
  return std::min(p.x, p.y) >= border && std::max(p.x, p.y) <= static_cast<double>(side) - border;
}

void ShownLight::add(const glm::dvec2& texel, double flux) {
  if (maps.cascade_shows(texel)) {
    cascade.add(maps.in_cascade(texel), flux);
  } else {
    map.add(texel, flux);
  }
}

}  // namespace caustics
