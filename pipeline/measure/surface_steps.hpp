// What lies between the pixels of a texture of positions.
#pragma once
#include <glm/glm.hpp>
#include <optional>

#include "pipeline/gpu/image_view.hpp"

namespace caustics {

// None outside the texture, and where it has no surface (w = 0).
std::optional<glm::dvec3> surface_at(const ImageView& position, int x, int y);

// From `here`, the surface at (x, y), to the nearer of the neighbours along (dx, dy) and against it: the
// other may show something else.
std::optional<glm::dvec3> surface_step(const ImageView& position, const glm::dvec3& here, int x, int y,
                                       int dx, int dy);

}  // namespace caustics
