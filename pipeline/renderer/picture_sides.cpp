#include "pipeline/renderer/picture_sides.hpp"

#include <algorithm>

namespace caustics {

namespace {

// Map and grid. The last take about twice the time of the first in a picture of 512 x 512 pixels; the grid
// need not grow as fast as the map (docs/accuracy.md has the figures).
constexpr int kSides[][2] = {{512, 512}, {768, 576}, {1024, 640}, {1280, 704}};
constexpr double kMostBlurred = 0.004;

double brightness(const Light& light) {
  return static_cast<double>(light.intensity * std::max({light.color.x, light.color.y, light.color.z}));
}

bool has_soft_edges(const Scene& scene, std::size_t light) {
  return std::count_if(scene.lights.begin(), scene.lights.end(), [&](const Light& other) {
           return other.source >= 0 && other.source == scene.lights[light].source;
         }) > 1;
}

}  // namespace

bool chooses_sides(const Scene& scene, const Settings& settings) {
  return settings.grid.automatic && settings.map.automatic && settings.splat == Splat::Cell &&
         scene.waters.empty();
}

Settings with_least_sides(Settings settings) {
  for (Side* side : {&settings.grid, &settings.map}) *side = side->count;
  return settings;
}

Settings with_sides_for_picture(Settings settings, const Scene& scene, const std::vector<CausticEdges>& edges,
                                const std::vector<LightViews>& views, const View& camera) {
  for (const auto& [map, grid] : kSides) {
    settings.map = map;
    settings.grid = grid;
    double blurred = 0.0, all = 0.0;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (has_soft_edges(scene, i)) continue;
      const double light = brightness(scene.lights[i]) * edges[i].flux;
      all += light;
      blurred += light * blurred_share(edges[i], views[i], camera, settings.width, map);
    }
    if (blurred <= kMostBlurred * all) break;
  }
  return settings;
}

}  // namespace caustics
