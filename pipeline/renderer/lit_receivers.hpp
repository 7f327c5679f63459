// On what the light of casters lands that its light does not see there.
#pragma once
#include <vector>

#include "pipeline/measure/light_paths.hpp"
#include "pipeline/views/light_views.hpp"

namespace caustics {

// How a light sees where a part of it has landed.
struct LandingSeen {
  bool hidden = false;  // another receiver stands before it
  bool behind = false;  // it has come to the side that the light cannot shine on
  bool away = false;    // the triangle's outward normal faces away from the light
};

// `landings`: of light, by rays that have been followed through the tables' scene; `views`: that light's. By
// landing. What stands between light and casters hides nothing: maps leave it out.
struct LitScene {
  const LightPaths& paths;
  const RayTables& tables;
  const Light& light;
  const LightViews& views;
};
std::vector<LandingSeen> seen_by_light(const LitScene& scene, const std::vector<LightLanding>& landings);

LitReceivers lit_receivers(const std::vector<LightLanding>& landings, const std::vector<LandingSeen>& seen,
                           std::size_t meshes);

}  // namespace caustics
