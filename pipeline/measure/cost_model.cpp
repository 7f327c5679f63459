#include "pipeline/measure/cost_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace caustics {

namespace {

// Sizes of grid and maps that are chosen from.
constexpr int kSides[] = {64, 96, 128, 192, 256, 384, 512, 768, 1024, 1536, 2048};
// Room for what the model gets wrong.
constexpr double kErrorMargin = 0.85, kTimeMargin = 0.9;

// By which power of its side a part of the error falls, from the error at two sides.
double order(double error, int side, double other_error, int other_side) {
  if (!(error > 0.0) || !(other_error > 0.0)) return 1.0;
  return std::clamp(std::log(error / other_error) / std::log(static_cast<double>(other_side) / side), 0.3,
                    2.0);
}

double squared(int side) { return static_cast<double>(side) * static_cast<double>(side); }

}  // namespace

CostModel::CostModel(const Trial& base, const Trial& finer_grid, const Trial& finer_map)
    : base_(base),
      grid_order_(order(base.grid_error, base.grid, finer_grid.grid_error, finer_grid.grid)),
      map_order_(order(base.map_error, base.map, finer_map.map_error, finer_map.map)) {
  per_vertex_ = std::max(
      0.0, (finer_grid.milliseconds - base.milliseconds) / (squared(finer_grid.grid) - squared(base.grid)));
  per_texel_ = std::max(
      0.0, (finer_map.milliseconds - base.milliseconds) / (squared(finer_map.map) - squared(base.map)));
  fixed_ =
      std::max(0.0, base.milliseconds - per_vertex_ * squared(base.grid) - per_texel_ * squared(base.map));
}

Trial CostModel::expect(int grid, int map) const {
  const double finer_grid = static_cast<double>(grid) / base_.grid,
               finer_map = static_cast<double>(map) / base_.map;
  return {.grid = grid,
          .map = map,
          .map_error = base_.map_error / std::pow(finer_map, map_order_),
          .grid_error = base_.grid_error / std::pow(finer_grid, grid_order_),
          .missing = base_.missing,
          .milliseconds = fixed_ + per_vertex_ * squared(grid) + per_texel_ * squared(map)};
}

void CostModel::learn(const Trial& trial) {
  const Trial expected = expect(trial.grid, trial.map);
  const double slower = expected.milliseconds > 0.0 ? trial.milliseconds / expected.milliseconds : 1.0;
  fixed_ *= slower;
  per_vertex_ *= slower;
  per_texel_ *= slower;
  if (trial.grid != base_.grid)
    grid_order_ = order(base_.grid_error, base_.grid, trial.grid_error, trial.grid);
  if (trial.map != base_.map) map_order_ = order(base_.map_error, base_.map, trial.map_error, trial.map);
  base_ = trial;
}

bool meets(const Trial& trial, const Demand& demand) {
  if (demand.error) return trial.error() <= *demand.error;
  return !demand.milliseconds || trial.milliseconds <= *demand.milliseconds;
}

Trial choose(const CostModel& model, const Demand& demand, double longest) {
  std::optional<Trial> best;
  Trial closest = model.expect(kSides[0], kSides[0]);
  double least = std::numeric_limits<double>::infinity();
  const auto first = [&](const Trial& t) { return demand.error ? t.milliseconds : t.error(); };
  const auto demanded = [&](const Trial& t) { return demand.error ? t.error() : t.milliseconds; };
  const double bound =
      demand.error ? kErrorMargin * *demand.error : kTimeMargin * demand.milliseconds.value_or(least);
  for (const int grid : kSides)
    for (const int map : kSides) {
      const Trial trial = model.expect(grid, map);
      if (trial.milliseconds > longest) continue;
      if (demanded(trial) < least) {
        least = demanded(trial);
        closest = trial;
      }
      if (demanded(trial) > bound) continue;
      if (!best || first(trial) < first(*best)) best = trial;
    }
  return best.value_or(closest);
}

}  // namespace caustics
