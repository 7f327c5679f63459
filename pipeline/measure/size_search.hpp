// Which sizes of grid and maps to try for an error or a time that was asked for, one after the other.
#pragma once
#include <limits>
#include <optional>
#include <vector>

#include "pipeline/measure/cost_model.hpp"

namespace caustics {

// For an error the fastest sizes that meet it are looked for, for a time the most accurate: from what a cost
// model expects, corrected by each trial, and down again from sizes that more than meet the demand.
class SizeSearch {
 public:
  SizeSearch(const CostModel& model, const Demand& demand);

  // The sizes to try next, with what is expected of them; none when the search is over.
  std::optional<Trial> next() const;
  void learn(const Trial& found);

  // Of the trials the best that meets the demand, or else the one that comes closest. None before the first.
  std::optional<Trial> chosen() const;
  // Does the model's error alone exceed the demand, so that no size meets it? The sizes' own error is then
  // brought down to what was asked for, or to a quarter of the model's: less would not show beside it.
  bool only_model() const;

 private:
  struct Candidate {
    Trial expected;
    double demanded = 0.0, wanted = 0.0;  // what is bounded, and what is to be small
  };
  Candidate candidate(const Trial& trial) const;
  bool is_met(const Trial& trial) const { return candidate(trial).demanded <= bound(); }
  double bound() const;
  bool is_ruled_out(int grid, int map) const;
  std::optional<Trial> better_than(const Trial& best) const;
  std::optional<Trial> first_to_meet(double longest) const;

  CostModel model_;
  Demand demand_;
  std::vector<Trial> trials_;
};

}  // namespace caustics
