#include "pipeline/renderer/picture_sides.hpp"

#include <algorithm>
#include <iterator>

namespace caustics {

namespace {

struct Sides {
  int map, grid;
};
// The grid need not grow as fast as the map (docs/accuracy.md has figures).
constexpr Sides kSides[] = {{512, 512}, {768, 576}, {1024, 640}, {1280, 704}};
// A vertex whose light is followed takes three to six times as long, and the ways that are left out err more
// than the grid: it grows where cascades need half the map's side.
constexpr Sides kSidesOfFollowed[] = {{512, 512}, {768, 512}, {1024, 512}, {1280, 640}};
constexpr double kMostBlurred = 0.004;

// What passes take of a pixel, of a vertex, of a cell in a cascade and of a texel that a cell's square
// covers, relative to each other: nanoseconds of the software device on two cores.
constexpr double kPerPixel = 1200.0, kPerVertex = 1100.0, kPerCascadeCell = 600.0, kPerTexel = 21.0;
// Times the least sides' time; twice is the bound, and what is expected can be wrong.
constexpr double kMostTime = 1.85;

double expected_time(const Settings& settings, const Sides& sides, const std::vector<LandingSurvey>& surveys,
                     const std::vector<LightViews>& views) {
  double sum = kPerPixel * settings.width * settings.height;
  const double vertices = static_cast<double>(sides.grid) * sides.grid;
  for (std::size_t i = 0; i < surveys.size(); ++i) {
    const double branches = surveys[i].branches;
    sum += branches * vertices * kPerVertex;
    sum += kPerTexel * covered_texels(surveys[i], views[i].caustic, sides.grid, sides.map);
    if (!views[i].cascade) continue;
    sum += branches * vertices * kPerCascadeCell;
    sum += kPerTexel * covered_texels(surveys[i], *views[i].cascade, sides.grid, sides.map);
  }
  return sum;
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

Settings with_sides_for_picture(Settings settings, const Scene& scene, bool is_followed,
                                const std::vector<LandingSurvey>& surveys,
                                const std::vector<LightViews>& views, const View& camera) {
  const auto blurs = [&](int map) {
    double blurred = 0.0, all = 0.0;
    for (std::size_t i = 0; i < surveys.size(); ++i) {
      if (has_soft_edges(scene, i)) continue;
      const double light = brightness(scene.lights[i]) * surveys[i].flux;
      all += light;
      blurred += light * blurred_share(surveys[i], views[i], camera, settings.width, map);
    }
    return blurred > kMostBlurred * all;
  };
  const auto& sides = is_followed ? kSidesOfFollowed : kSides;
  const Sides* chosen = std::begin(sides);
  const double least = expected_time(settings, *chosen, surveys, views);
  for (const Sides* finer = chosen + 1; finer != std::end(sides) && blurs(chosen->map); ++finer) {
    if (expected_time(settings, *finer, surveys, views) > kMostTime * least) break;
    chosen = finer;
  }
  settings.map = chosen->map;
  settings.grid = chosen->grid;
  return settings;
}

}  // namespace caustics
