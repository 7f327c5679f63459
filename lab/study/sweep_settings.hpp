// The settings that a sweep's points stand for.
#pragma once
#include "lab/study/sweep.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics::study {

// The base's settings with a point's values.
Settings settings_at(const Settings& base, const std::vector<Knob>& knobs, const Point& point);

// What nothing in the sweep is finer than: of grid, map and the other counts the largest values, then
// grid and map doubled (8192 at most); everything else as in the base.
Settings finest_settings(const Settings& base, const std::vector<Knob>& knobs);

}  // namespace caustics::study
