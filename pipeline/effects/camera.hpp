// What the camera does not see, and so needs no light.
#pragma once
#include "pipeline/effects/effects.hpp"

namespace caustics {

// Judges seen_casters, reflecting_receivers and which lights light anything in view, by the roles and
// expectations. `camera`: null: everything counts as seen.
void add_camera(const Scene& scene, const View* camera, Effects& effects);

}  // namespace caustics
