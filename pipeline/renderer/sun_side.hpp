// On which side of what a camera shows an added sun stands.
#pragma once
#include "pipeline/scene/scene.hpp"

namespace caustics {

class LandedLight;

struct SunSide {
  glm::dvec3 direction{0.0, -1.0, 0.0};  // unit, the way its light travels
  const char* where = "behind";          // as the camera sees it: "behind", "beside", "before"
};

// Behind, on the left, so that caustics fall towards the camera; but where most opaque surfaces that turn to
// the camera would lie in the dark, or a tenth of them if they catch the casters' light, beside or before the
// scene, if the camera sees its caustics there. The scene has the ground that it will be shown on, and a sun,
// which is turned here and there; `landed` is its light. Unit vectors from the scene: `toward_camera`, and
// `front` the same along the ground.
SunSide sun_side(Scene& scene, LandedLight& landed, const glm::dvec3& toward_camera, const glm::dvec3& front);

}  // namespace caustics
