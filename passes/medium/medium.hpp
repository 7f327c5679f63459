#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// medium.md says what these passes are for, what they read and write, and what can go wrong.

// What the medium leaves of what the camera sees, and how far each of its rays goes through it.
Pass view_medium_pass();
// What scatters towards the camera of one light's direct light.
Pass light_haze_pass();
// Adds what the medium scatters to the picture.
Pass haze_pass();

}  // namespace caustics
