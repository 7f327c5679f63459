// Where the casters' light lands, by a few thousand rays: what a scene is set up by.
#pragma once
#include <vector>

#include "pipeline/scene/scene.hpp"

namespace caustics {

struct Settings;

struct Landed {
  glm::dvec3 position{0.0};
  double share = 0.0;  // of its light's
  double area = 0.0;   // that its ray has without casters, times what is left of its flux, square metres
  int mesh = -1;
};

// By any number of surfaces.
std::vector<Landed> landed_light(const Scene& scene, const Settings& settings);

}  // namespace caustics
