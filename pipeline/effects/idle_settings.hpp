// Settings that change nothing of a frame, because what they are about is not there.
#pragma once
#include <string>
#include <vector>

#include "pipeline/effects/effects.hpp"

namespace caustics {

// For each of the named settings that has no effect on a frame with these effects: "splits=4 changes nothing
// here: 0.0% of the light ...". `given`: names of settings (setting.hpp), each counts once. Settings whose
// effect depends on more than the effects tell are taken to have one.
std::vector<std::string> idle_settings(const std::vector<std::string>& given, const Scene& scene,
                                       const Settings& settings, const Effects& effects);

}  // namespace caustics
