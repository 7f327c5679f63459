// The points of a light with a size from which the pass walk sends light to its grid vertices, for rays that
// are held against it (passes/shared/wide_light.glsl and way_draw.glsl, in double precision).
#pragma once
#include <glm/glm.hpp>

#include "pipeline/measure/light_paths.hpp"
#include "pipeline/scene/scene.hpp"

namespace caustics {

// The ray from the vertex' own point of `source` to p, where the vertex is, scene space. `ray`: the one from
// the light's view.
LightRay from_own_point(const Light& source, LightRay ray, const glm::dvec3& p, int column, int row);

}  // namespace caustics
