// Where a cone of light lies in the window of a view from its tip.
#pragma once
#include <glm/glm.hpp>
#include <optional>

#include "pipeline/scene/view.hpp"

namespace caustics {

// The range of x/z (axis 0) or y/z (axis 1) in the perspective view `axes`, whose origin is the cone's tip,
// of the cone around the unit vector `direction` with this half angle in radians: between its two tangent
// planes along the other axis. Nothing where the cone is a half space or wider, or reaches near a right angle
// from the view's middle.
std::optional<glm::dvec2> cone_range(const View& axes, int axis, const glm::dvec3& direction,
                                     double half_angle);

}  // namespace caustics
