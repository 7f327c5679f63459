#include "pipeline/measure/shown_light.hpp"

#include <array>
#include <utility>

#include "pipeline/settings/splat_kernel.hpp"

namespace caustics {

void TexelPlane::add(const glm::dvec2& texel, double value) {
  const int x = static_cast<int>(std::floor(texel.x)), y = static_cast<int>(std::floor(texel.y));
  if (x >= 0 && y >= 0 && x < side_ && y < side_) at(x, y) += value;
}

void TexelPlane::average(const glm::dvec2& box) {
  const auto row = static_cast<std::size_t>(side_);
  average(std::max(box.x, 1.0), 1, row);
  average(std::max(box.y, 1.0), row, 1);
}

double TexelPlane::absolute_sum(const glm::dvec2& box) && {
  average(box);
  double sum = 0.0;
  for (const double v : values_) sum += std::fabs(v);
  return sum;
}

namespace {

// Lines that are averaged together: where they run along columns, as many texels lie side by side.
constexpr std::size_t kTogether = 8;

// A place between the texels of a line: so many whole ones before it, and of the next one a part.
struct LinePlace {
  std::size_t whole = 0;
  double part = 0.0;

  LinePlace(double place, int side) {
    const double inside = std::clamp(place, 0.0, static_cast<double>(side));
    whole = static_cast<std::size_t>(std::min(static_cast<int>(inside), side - 1));
    part = inside - static_cast<double>(whole);
  }
};

}  // namespace

// Means over `side` texels along an axis, by running sums; the outermost texels of a box count by the share
// that lies in it, and beyond the map there is nothing. From a texel of a line to its next, and from a line
// to its next, it is so far.
void TexelPlane::average(double side, std::size_t along, std::size_t across) {
  if (side <= 1.0) return;
  const double reach = 0.5 * std::min(side, 2.0 * side_);
  const auto length = static_cast<std::size_t>(side_);
  std::vector<std::pair<LinePlace, LinePlace>> boxes;
  boxes.reserve(length);
  for (int k = 0; k < side_; ++k) boxes.push_back({{k + 0.5 - reach, side_}, {k + 0.5 + reach, side_}});
  using Values = std::array<double, kTogether>;
  std::vector<Values> values(length), sums(length + 1);
  for (std::size_t first = 0; first < length; first += kTogether) {
    const std::size_t lines = std::min(kTogether, length - first);
    for (std::size_t k = 0; k < length; ++k)
      for (std::size_t i = 0; i < lines; ++i) {
        values[k][i] = values_[k * along + (first + i) * across];
        sums[k + 1][i] = sums[k][i] + values[k][i];
      }
    for (std::size_t k = 0; k < length; ++k) {
      const auto& [from, to] = boxes[k];
      for (std::size_t i = 0; i < lines; ++i)
        values_[k * along + (first + i) * across] =
            ((sums[to.whole][i] + to.part * values[to.whole][i]) -
             (sums[from.whole][i] + from.part * values[from.whole][i])) /
            side;
    }
  }
}

ShownMaps::ShownMaps(const LightViews& views, const Settings& settings, int map_side, bool cascade)
    : side(map_side), has_cascade(cascade && views.cascade) {
  if (!has_cascade) return;
  const glm::dvec2 whole = views.caustic.window_upper - views.caustic.window_lower;
  const glm::dvec2 part = views.cascade->window_upper - views.cascade->window_lower;
  scale = whole / part;
  offset = (views.caustic.window_lower - views.cascade->window_lower) / part * static_cast<double>(side);
  border = cascade_border(settings);
}

bool ShownMaps::cascade_shows(const glm::dvec2& texel) const {
  if (!has_cascade) return false;
  const glm::dvec2 lower = in_cascade(glm::floor(texel)), upper = in_cascade(glm::floor(texel) + 1.0);
  return std::min(lower.x, lower.y) >= border && std::max(upper.x, upper.y) <= side - border;
}

void ShownLight::add(const glm::dvec2& texel, double flux) {
  if (maps.cascade_shows(texel)) {
    cascade.add(maps.in_cascade(texel), flux);
  } else {
    map.add(texel, flux);
  }
}

}  // namespace caustics
