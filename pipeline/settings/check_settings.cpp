#include "pipeline/settings/check_settings.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/gpu/error.hpp"
#include "pipeline/scene/cube_atlas.hpp"
#include "pipeline/settings/splat_kernel.hpp"

namespace caustics {

namespace {

std::string too_small(const std::string& name, int side, int least) {
  if (side >= least) return {};
  return name + " is " + std::to_string(side) + ", must be at least " + std::to_string(least);
}

int least_atlas(int guard) { return std::max(kLeastAtlas, 9 * guard); }

}  // namespace

int caustic_guard(const Settings& settings) {
  const int kernel = static_cast<int>(std::ceil(splat_kernel(settings).radius)) + 2;
  return std::max({kLeastGuard, kernel, settings.map / 40});
}

std::string too_small_for_cubes(const Settings& settings) {
  std::string small = too_small("grid", settings.grid, least_atlas(kLeastGuard));
  if (small.empty()) small = too_small("map", settings.map, least_atlas(caustic_guard(settings)));
  if (small.empty()) small = too_small("shadow", settings.shadow, least_atlas(kLeastGuard));
  return small;
}

void check(const Settings& settings) {
  check_ranges(settings);
  if (settings.view && !settings.camera.empty())
    throw Error(ExitCode::WrongUsage,
                "--view and --camera exclude each other: both say which camera shows the scene");
  if (const std::string small = too_small("map", settings.map, kLeastAtlas);
      settings.estimator == Estimator::Impostor && !small.empty())
    throw Error(ExitCode::WrongUsage, small + " with the estimator impostor");
  if (const std::string small = too_small_for_cubes(settings); settings.cube == Cube::On && !small.empty())
    throw Error(ExitCode::WrongUsage, small + " for -D cube=on");
}

}  // namespace caustics
