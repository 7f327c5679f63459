// Where the casters' light lands, by a few thousand rays: what a scene is set up by.
#pragma once
#include <optional>
#include <vector>

#include "pipeline/measure/light_paths.hpp"
#include "pipeline/renderer/pilot.hpp"
#include "pipeline/scene/scene.hpp"

namespace caustics {

struct Settings;

struct Landed {
  glm::dvec3 position{0.0};
  double share = 0.0;  // of its light's
  double area = 0.0;   // that its ray has without casters, times what is left of its flux, square metres
  double lumen = 0.0;  // by luminance, of all samples of its light together
  int mesh = -1;
};

// The scene must outlive it and keep its meshes and materials; its lights may be others for each search.
class LandedLight {
 public:
  LandedLight(const Scene& scene, const Settings& settings, const Pilot& pilot);
  // By any number of surfaces; by each ray, or each `step`th along each side of their square.
  std::vector<Landed> find(int step = 1);
  // Does a caster stand on the way from p in this direction, up to that distance? None before find() was
  // called.
  bool casters_block(const glm::dvec3& p, const glm::dvec3& direction, double distance) const {
    return paths_ && paths_->casters_block(p, direction, distance);
  }

 private:
  const Scene& scene_;
  const Settings& settings_;
  Pilot pilot_;
  std::optional<RayTables> tables_;
  std::optional<LightPaths> paths_;
};

}  // namespace caustics
