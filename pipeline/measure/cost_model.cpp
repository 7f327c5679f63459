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

double squared(double side) { return side * side; }

constexpr int kRounds = 2000;
constexpr double kLeastTime = 1e-6;  // milliseconds

}  // namespace

CostModel::CostModel(const Trial& base, const Trial& finer_grid, const Trial& finer_map)
    : base_(base),
      grid_order_(order(base.grid_error, base.grid, finer_grid.grid_error, finer_grid.grid)),
      map_order_(order(base.map_error, base.map, finer_map.map_error, finer_map.map)),
      missing_order_(order(base.missing, base.grid, finer_grid.missing, finer_grid.grid, 0.0)),
      trials_{base, finer_grid, finer_map} {
  base_.model = finer_grid.model;
  finest_ = finer_grid.grid;
  fit_costs();
}

CostModel::Amounts CostModel::amounts(int grid, int map) { return {1.0, squared(grid), squared(map)}; }

double CostModel::time(const Amounts& amounts) const {
  return costs_[0] * amounts[0] + costs_[1] * amounts[1] + costs_[2] * amounts[2];
}

// Least squares of relative errors, by one cost after the other: times that are measured with noise, and
// costs that cannot be negative.
void CostModel::fit_costs() {
  for (int round = 0; round < kRounds; ++round)
    for (std::size_t k = 0; k < costs_.size(); ++k) {
      double along = 0.0, across = 0.0;
      for (const Trial& trial : trials_) {
        const Amounts row = amounts(trial.grid, trial.map);
        const double weight = 1.0 / squared(std::max(trial.milliseconds, kLeastTime));
        along += weight * row[k] * (trial.milliseconds - time(row) + costs_[k] * row[k]);
        across += weight * row[k] * row[k];
      }
      costs_[k] = std::max(0.0, along / across);
    }
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
          .milliseconds = time(amounts(grid, map))};
}

void CostModel::learn(const Trial& trial) {
  trials_.push_back(trial);
  fit_costs();
  const double expected = time(amounts(trial.grid, trial.map));
  for (double& cost : costs_) cost *= expected > 0.0 ? trial.milliseconds / expected : 1.0;
  if (trial.grid != base_.grid) {
    grid_order_ = order(base_.grid_error, base_.grid, trial.grid_error, trial.grid);
    missing_order_ = order(base_.missing, base_.grid, trial.missing, trial.grid, 0.0);
  }
  if (trial.map != base_.map) map_order_ = order(base_.map_error, base_.map, trial.map_error, trial.map);
  const double model = trial.grid >= finest_ ? trial.model : base_.model;
  finest_ = std::max(finest_, trial.grid);
  base_ = trial;
  base_.model = model;
}

bool meets(const Trial& trial, const Demand& demand) {
  if (demand.error) return trial.error() <= *demand.error;
  return !demand.milliseconds || trial.milliseconds <= *demand.milliseconds;
}

}  // namespace caustics
