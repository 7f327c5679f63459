// Completes a scene that a file leaves half-said, so that a bare model is enough for a picture.
// Whatever is added is said in Scene::notes.
#pragma once
#include "pipeline/scene/scene.hpp"

namespace caustics {

// A mesh that shows a caustic rather than throwing one: neither transmissive nor a mirror.
bool is_mirror(const Material& material);    // metallic >= 0.5 and roughness <= 0.2
bool is_receiver(const Material& material);  // not transmissive, not a mirror

// Adds what is missing, in this order:
// - a receiver: a square of light grey (0.7) under the lowest point, six times as wide as the
// objects;
// - a light: a directional one of 10 lux, 30 degrees off the vertical, from behind on the left of
// the
//   camera's view of the objects;
// - a camera: a three-quarter view from above that shows the objects and where their shadows fall;
// - a sky, unless there is an environment image or one was already set: grey, brightest at the
//   horizon, lighting a horizontal surface with 15 % of what the scene's lights give.
void complete_scene(Scene& scene);

// What the scene's lights together give at its centre on a surface facing each of them, in lux.
double light_level(const Scene& scene);

}  // namespace caustics
