#include "lab/reference/glass_bar.hpp"

#include <algorithm>
#include <cmath>

namespace caustics {

namespace {

struct Side {
  glm::dvec2 from, to;
  glm::dvec2 normal;  // outward
};

Side side_of(const GlassBar& bar, std::size_t i) {
  const glm::dvec2 a = bar.corners[i], b = bar.corners[(i + 1) % bar.corners.size()];
  return {a, b, glm::normalize(glm::dvec2(b.y - a.y, a.x - b.x))};
}

std::optional<glm::dvec2> bent(const glm::dvec2& direction, const glm::dvec2& normal, double eta) {
  const auto d = refract_direction(glm::dvec3(direction, 0.0), glm::dvec3(normal, 0.0), eta);
  if (!d) return {};
  return glm::dvec2(d->x, d->y);
}

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

// Where the line from p along d meets the side's line: 0 at its beginning, 1 at its end.
double share_of_side(const Side& side, const glm::dvec2& p, const glm::dvec2& d) {
  return cross(p - side.from, d) / cross(side.to - side.from, d);
}

double overlap(double a, double b, double lower, double upper) {
  return std::max(std::min(std::max(a, b), upper) - std::max(std::min(a, b), lower), 0.0);
}

// A rectangle of the floor, evenly lit.
struct Patch {
  double from, to;    // along x
  double irradiance;  // over E_perp
};

// What enters by one side and leaves by the other.
std::optional<Patch> patch_of(const GlassBar& bar, const Side& entry, const Side& exit) {
  const double incidence = -glm::dot(bar.travel, entry.normal);
  const auto inside = incidence > 0.0 ? bent(bar.travel, entry.normal, 1.0 / bar.index) : std::nullopt;
  const double leaving = inside ? glm::dot(*inside, exit.normal) : 0.0;
  const auto outside = leaving > 0.0 ? bent(*inside, -exit.normal, bar.index) : std::nullopt;
  if (!outside || !(outside->y < 0.0)) return {};
  // The part of the exit that the entry's two ends reach to.
  const double a = share_of_side(exit, entry.from, *inside), b = share_of_side(exit, entry.to, *inside);
  const double first = std::clamp(std::min(a, b), 0.0, 1.0), last = std::clamp(std::max(a, b), 0.0, 1.0);
  if (!(last > first)) return {};
  const auto landing = [&](double share) {
    const glm::dvec2 p = exit.from + share * (exit.to - exit.from);
    return p.x - outside->x / outside->y * p.y;
  };
  const double lit = glm::length(entry.to - entry.from) * (last - first) / std::fabs(b - a);
  const double passed =
      (1.0 - fresnel(incidence, 1.0, bar.index).mean()) * (1.0 - fresnel(leaving, bar.index, 1.0).mean());
  const double from = landing(first), to = landing(last);
  return Patch{from, to, passed * incidence * lit / std::fabs(to - from)};
}

}  // namespace

std::vector<double> irradiance_average(const GlassBar& bar, const FloorSquare& floor) {
  const double pixel = floor.side / floor.pixels;
  std::vector<double> values(static_cast<std::size_t>(floor.pixels) * static_cast<std::size_t>(floor.pixels));
  for (std::size_t i = 0; i < bar.corners.size(); ++i)
    for (std::size_t k = 0; k < bar.corners.size(); ++k) {
      const auto patch = i == k ? std::nullopt : patch_of(bar, side_of(bar, i), side_of(bar, k));
      if (!patch) continue;
      for (int y = 0; y < floor.pixels; ++y)
        for (int x = 0; x < floor.pixels; ++x) {
          const glm::dvec2 p = floor.lower + pixel * glm::dvec2(x, y);
          values[static_cast<std::size_t>(y) * static_cast<std::size_t>(floor.pixels) +
                 static_cast<std::size_t>(x)] +=
              patch->irradiance * overlap(patch->from, patch->to, p.x, p.x + pixel) / pixel *
              overlap(-bar.half_length, bar.half_length, p.y, p.y + pixel) / pixel;
        }
    }
  return values;
}

}  // namespace caustics
