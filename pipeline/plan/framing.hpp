// Where the maps of a light look, and how bright a picture is made.
#pragma once
#include <vector>

#include "pipeline/plan/scene_on_device.hpp"

namespace caustics {

// The frames of every light (by Scene::lights), fitted to the casters and to where their light lands.
// Finds the latter by running the passes that lead to `landing` coarsely on the scene's device, which
// should be the software device whatever backend renders, so that every backend sees the same frames.
std::vector<LightFrames> fit_light_frames(const SceneOnDevice& scene, const Effects& effects,
                                          const Settings& settings, const Registry& registry);

// The factor from nit to display white: `settings.exposure` EV above or below the automatic one,
// under which a white diffuse surface in the light that reaches the scene (light_level) shows at 0.45 of display white (linear), so that caustics have room above.
float exposure_of(const Scene& scene, const Settings& settings);

}  // namespace caustics
