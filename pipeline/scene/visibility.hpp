// Whether a view can see any of a part of the scene. False only where it surely cannot: all of the part lies
// beyond one of the planes that bound what the view sees.
#pragma once
#include "pipeline/scene/view.hpp"

namespace caustics {

bool may_see(const View& view, const Bounds& bounds);
// The part that another view sees; neither is a cube.
bool may_see(const View& view, const View& other);

}  // namespace caustics
