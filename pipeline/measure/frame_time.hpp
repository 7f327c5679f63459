// What a frame will take of the processors, told from a smaller one of the same scene that was drawn.
#pragma once
#include <vector>

#include "pipeline/gpu/pass_run.hpp"

namespace caustics {

struct Effects;
struct FramePlan;
struct Settings;

// A frame and the settings that its sides come from.
struct SizedFrame {
  const FramePlan& plan;
  const Settings& settings;
  const Effects& effects;
};

// Processor milliseconds of all passes. Of a pass of the smaller frame, what its vertices took grows with the
// grid where it draws the grid, and else stays; what its fragments took grows with its texels; and what the
// cheapest passes take stays. A pass that the smaller frame lacks takes what its other instances take.
// `results`: of the smaller frame's passes, in turn.
double expected_milliseconds(const SizedFrame& frame, const SizedFrame& smaller,
                             const std::vector<PassResult>& results);

}  // namespace caustics
