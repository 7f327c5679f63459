// A light with a size whose caustic is drawn once has one grid, which does not show all of the casters that
// it lights.
#pragma once
#include <set>

#include "pipeline/measure/drawn_points.hpp"
#include "pipeline/measure/light_paths.hpp"
#include "pipeline/scene/scene.hpp"

namespace caustics {

// Returns the share (0..1) of the light onto the casters that comes to where `eye`, the place from which the
// light's view is drawn (scene space), does not see them: to their sides, or past one that hides another. It
// is told from a thousand ways between points of the light and points all over the casters, spread by area.
// `casters`: indices into Scene::meshes.
double unseen_share(const Scene& scene, const std::set<int>& casters, const LightPaths& paths,
                    const DrawnPoints& points, const glm::dvec3& eye);

}  // namespace caustics
