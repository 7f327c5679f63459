// A camera that is added to a closed room stands in it.
#pragma once
#include <vector>

#include "pipeline/scene/scene.hpp"

namespace caustics {

struct Settings;

// Where one of the opaque walls hides the middle of `subject` (scene space) from the camera, the camera comes
// forward until it stands before the wall, and opens its angle, unless the settings state one, so that it
// still shows all of the subject. Walls are hidden from their backs as the picture leaves them out
// (passes/view_surfaces). `around`: which meshes are walls; the rest of the scene's are none. False: nothing
// was changed, because no wall stands there, or one too near to stand before it.
bool come_inside(Camera& camera, const Scene& scene, const std::vector<bool>& around, const Bounds& subject,
                 const Settings& settings);

}  // namespace caustics
