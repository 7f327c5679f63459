// What sizes of grid and maps cost in time and leave in error: a model of three frames that were measured.
#pragma once
#include <limits>
#include <optional>

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
  double milliseconds = 0.0;
  double error() const { return map_error + grid_error + missing; }
};

// Error and time as powers and squares of the sizes, from three trials: a base, one with a larger grid, one
// with larger maps.
class CostModel {
 public:
  CostModel(const Trial& base, const Trial& finer_grid, const Trial& finer_map);
  Trial expect(int grid, int map) const;
  // Makes the model true for this trial, and the orders those between it and the one before.
  void learn(const Trial& trial);

 private:
  Trial base_;
  double grid_order_ = 1.0, map_order_ = 1.0;
  double fixed_ = 0.0, per_vertex_ = 0.0, per_texel_ = 0.0;  // milliseconds
};

// The sizes with which the demand is expected to be met: for an error the fastest, for a time the most
// accurate. Where none suffices, those that come closest. Among those that are expected to take no longer
// than `longest`, milliseconds, or the fastest of all: a model is not to be trusted far from what it was
// measured at.
Trial choose(const CostModel& model, const Demand& demand,
             double longest = std::numeric_limits<double>::infinity());
bool meets(const Trial& trial, const Demand& demand);

}  // namespace caustics
