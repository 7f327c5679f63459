// What a file leaves out, so that a bare model is enough for a picture: a ground that catches its light, a
// sun, a camera, a sky.
#pragma once
#include <string>
#include <vector>

#include "pipeline/renderer/pilot.hpp"
#include "pipeline/scene/scene.hpp"

namespace caustics {

struct Settings;

// Of Completed::added.
inline constexpr const char* kAddedCamera = "a camera";

// What complete_scene put in the place of the scene's own.
struct Completed {
  bool lights = false, cameras = false;
  // What was added, in a few words each: "a grey ground". Why it was is said by as many sentences at the
  // beginning of Scene::notes.
  std::vector<std::string> added{};
};

// Adds in this order, and says:
// - a sun where there is no light, or settings.sun asks for one in place of the scene's: as sun_side has it
//   (sun_side.hpp), of as many lux as sun_lux (pipeline/scene/defaults.hpp) unless that is asked for;
// - a ground under the lowest point (settings.ground), unless the scene has a floor (surroundings.hpp) and at
//   least half of what of the casters' light would land with the ground lands on the scene itself, by a few
//   thousand rays of each light. Never between the scene and a camera of its own below, nor beside one that
//   is rolled. It is twelve times as wide as what is shown, and fades into the background;
// - a camera where there is none, or settings.view asks for one: a three-quarter view from above of all that
// is
//   no floor and no backdrop, its shadow on an added ground, and all but the faintest of the caustics nearby,
//   as large as fits;
// - a sky where there is no environment (pipeline/scene/defaults.hpp).
// A sun that lights no floor is noted.
// Throws Error, as effects_of does.
Completed complete_scene(Scene& scene, const Settings& settings, const Pilot& pilot);

}  // namespace caustics
