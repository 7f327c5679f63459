// What sizes of grid and maps cost in time and leave in error: a model of three frames that were measured.
#pragma once
#include <array>
#include <optional>
#include <vector>

namespace caustics {

// At most one of both.
struct Demand {
  std::optional<double> error;         // relative L1 of the caustic's irradiance, as it is estimated
  std::optional<double> milliseconds;  // of all passes of a frame
  bool any() const { return error || milliseconds; }
};

// A frame's sizes, and what came of them.
struct Trial {
  int grid = 0, map = 0;
  double map_error = 0.0, grid_error = 0.0, missing = 0.0;  // shares, as ErrorEstimate
  double model = 0.0;                                       // likewise: what no size takes away
  double milliseconds = 0.0;
  double of_sizes() const { return map_error + grid_error + missing; }
  double error() const { return of_sizes() + model; }
};

// Error and time as powers and squares of the sizes, from three trials: a base, one with a larger grid, one
// with larger maps. The model's error is that of the finest grid: few rays show too much.
class CostModel {
 public:
  CostModel(const Trial& base, const Trial& finer_grid, const Trial& finer_map);
  Trial expect(int grid, int map) const;
  // Makes the model true for this trial, its costs those that fit all trials best, and the orders those
  // between it and the one before.
  void learn(const Trial& trial);

 private:
  // What a frame of a trial's sides has of each cost: itself, vertices, texels.
  using Amounts = std::array<double, 3>;
  static Amounts amounts(int grid, int map);
  double time(const Amounts& amounts) const;
  void fit_costs();

  Trial base_;
  double grid_order_ = 1.0, map_order_ = 1.0, missing_order_ = 0.0;  // what is missing falls with the grid
  Amounts costs_{};                                                  // milliseconds, none negative
  std::vector<Trial> trials_;
  int finest_ = 0;  // of the grids
};

bool meets(const Trial& trial, const Demand& demand);

}  // namespace caustics
