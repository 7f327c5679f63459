// How much of the caustics a picture shows, where, and how bright: in figures that a person can be told.
#pragma once
#include <glm/glm.hpp>

#include "pipeline/gpu/image_view.hpp"
#include "pipeline/scene/view.hpp"

namespace caustics {

// What a camera sees without casters, the light on it, and the casters before it.
struct LitSurfaces {
  ImageView position, normal;  // as view_position and view_normal have them
  ImageView caustic, direct;   // irradiance, lux
  ImageView caster;            // positions of casters; without values where the camera sees none
};

struct SeenCaustic {
  // Of caustics, on surfaces seen directly and on those seen through casters: irradiance times area, the sum
  // over three channels, lumen.
  double beside = 0.0, through = 0.0;
  // Of square blocks of pixels, 64 along the picture: where the brightest is, pixels from the top left.
  glm::dvec2 brightest{0.0};
  bool is_through = false;  // it lies behind a caster
  // As bright as the brightest surface near it that lies in the lights' direct light, and as the same place
  // without it; 0 where neither is lit.
  double times = 0.0, times_without = 0.0;
};

// `ambient`: what surfaces get beside, lux, by luminance.
SeenCaustic see_caustic(const LitSurfaces& surfaces, const View& camera, double ambient);

}  // namespace caustics
