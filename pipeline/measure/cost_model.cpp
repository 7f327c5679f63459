#include "pipeline/measure/cost_model.hpp"

#include <algorithm>
#include <cmath>

namespace caustics {

namespace {

// By which power of its side a part of the error falls, from the error at two sides.
double order(double error, int side, double other_error, int other_side, double least = 0.3) {
  if (!(error > 0.0) || !(other_error > 0.0)) return std::max(1.0, least);
  return std::clamp(std::log(error / other_error) / std::log(static_cast<double>(other_side) / side), least,
                    2.0);
}

double squared(int side) { return static_cast<double>(side) * static_cast<double>(side); }

}  // namespace

CostModel::CostModel(const Trial& base, const Trial& finer_grid, const Trial& finer_map)
    : base_(base),
      grid_order_(order(base.grid_error, base.grid, finer_grid.grid_error, finer_grid.grid)),
      map_order_(order(base.map_error, base.map, finer_map.map_error, finer_map.map)),
      missing_order_(order(base.missing, base.grid, finer_grid.missing, finer_grid.grid, 0.0)) {
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
          .missing = base_.missing / std::pow(finer_grid, missing_order_),
          .model = base_.model,
          .milliseconds = fixed_ + per_vertex_ * squared(grid) + per_texel_ * squared(map)};
}

void CostModel::learn(const Trial& trial) {
  const Trial expected = expect(trial.grid, trial.map);
  const double slower = expected.milliseconds > 0.0 ? trial.milliseconds / expected.milliseconds : 1.0;
  fixed_ *= slower;
  per_vertex_ *= slower;
  per_texel_ *= slower;
  if (trial.grid != base_.grid) {
    grid_order_ = order(base_.grid_error, base_.grid, trial.grid_error, trial.grid);
    missing_order_ = order(base_.missing, base_.grid, trial.missing, trial.grid, 0.0);
  }
  if (trial.map != base_.map) map_order_ = order(base_.map_error, base_.map, trial.map_error, trial.map);
  base_ = trial;
}

bool meets(const Trial& trial, const Demand& demand) {
  if (demand.error) return trial.error() <= *demand.error;
  return !demand.milliseconds || trial.milliseconds <= *demand.milliseconds;
}

}  // namespace caustics
