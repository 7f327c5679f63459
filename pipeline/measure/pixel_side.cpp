#include "pipeline/measure/pixel_side.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "pipeline/measure/surface_steps.hpp"
#include "pipeline/scene/in_pieces.hpp"

namespace caustics {

namespace {

// Texels of a map of so many a side, of a cube those of this face; none behind a light.
std::optional<glm::dvec2> texel_of(const glm::dvec3& p, const View& view, int map, int face) {
  glm::dvec3 q = view.coordinates(p);
  if (view.cube) {
    q = turned_to_face(q, face);
    return q.z > 0.0 ? std::optional(view.cube->texel({q.x / q.z, q.y / q.z}, face)) : std::nullopt;
  }
  if (view.perspective && !(q.z > 0.0)) return {};
  return (view.window(q) - view.window_lower) / (view.window_upper - view.window_lower) *
         static_cast<double>(map);
}

double light_at(const ImageView& map, const glm::dvec2& texel) {
  const double x = std::floor(texel.x), y = std::floor(texel.y);
  if (!(x >= 0.0 && y >= 0.0 && x < map.width() && y < map.height())) return 0.0;
  double light = 0.0;
  for (int c = 0; c < std::min(map.channels(), 3); ++c)
    light += static_cast<double>(map.at(static_cast<int>(x), static_cast<int>(y), c));
  return light;
}

// Square texels of a pixel's parallelogram; none where that cannot be told.
std::optional<double> area_at(const ImageView& position, const glm::dvec3& here, const glm::dvec2& texel,
                              const View& view, int map, int face, int x, int y) {
  const auto across = surface_step(position, here, x, y, 1, 0),
             upward = surface_step(position, here, x, y, 0, 1);
  if (!across || !upward) return {};
  const auto right = texel_of(here + *across, view, map, face),
             above = texel_of(here + *upward, view, map, face);
  if (!right || !above) return {};
  const glm::dvec2 a = *right - texel, b = *above - texel;
  const double area = std::fabs(a.x * b.y - a.y * b.x);
  // No pixel is taken to be wider than the map.
  return area <= static_cast<double>(map) * static_cast<double>(map) ? std::optional(area) : std::nullopt;
}

// Every n-th pixel of a row and of a column tells enough of a large picture.
constexpr double kMostPixels = 1 << 20;

struct LitPixel {
  double area = 0.0, light = 0.0;  // on the map: square texels; what is in them
};

// Of every n-th pixel of a row those that see light.
std::vector<LitPixel> lit_pixels(const ImageView& view_position, const ImageView& caustic_map,
                                 const View& caustic, int y, int step) {
  const int map = caustic_map.width();
  std::vector<LitPixel> found;
  for (int x = step / 2; x < view_position.width(); x += step) {
    const auto here = surface_at(view_position, x, y);
    if (!here) continue;
    const int face = caustic.cube ? face_of(caustic.coordinates(*here)) : 0;
    const std::optional<glm::dvec2> texel = texel_of(*here, caustic, map, face);
    const double light = texel ? light_at(caustic_map, *texel) : 0.0;
    if (!(light > 0.0)) continue;
    const std::optional<double> area = area_at(view_position, *here, *texel, caustic, map, face, x, y);
    // The light in the pixel is in proportion to the light in the texel and to its area.
    if (area) found.push_back({*area, light * *area});
  }
  return found;
}

}  // namespace

double pixel_side(const ImageView& view_position, const ImageView& caustic_map, const View& caustic,
                  int coarser) {
  const double pixels = static_cast<double>(view_position.width()) * view_position.height();
  const int step = std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / kMostPixels)))) * coarser;
  const int first = step / 2, rows = std::max(0, (view_position.height() - first + step - 1) / step);
  std::vector<std::vector<LitPixel>> lit(static_cast<std::size_t>(rows));
  in_pieces(rows, 0, [&](int row) {
    lit[static_cast<std::size_t>(row)] =
        lit_pixels(view_position, caustic_map, caustic, first + row * step, step);
  });
  // Row by row, so that the sum is the same whoever has looked at which.
  double sides = 0.0, weights = 0.0;
  for (const std::vector<LitPixel>& row : lit)
    for (const LitPixel& pixel : row) {
      sides += pixel.light * std::sqrt(pixel.area);
      weights += pixel.light;
    }
  return weights > 0.0 ? sides / weights : 0.0;
}

}  // namespace caustics
