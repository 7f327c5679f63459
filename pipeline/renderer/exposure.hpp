// How bright a picture for a screen is made.
#pragma once
#include <optional>

#include "pipeline/renderer/pilot.hpp"
#include "pipeline/scene/view.hpp"

namespace caustics {

struct Settings;

struct Exposure {
  float factor = 1.0f;    // from nit to display white
  float contrast = 1.0f;  // the power of tone_map's curve over its mid grey, 1 to 6
};

// By some two thousand rays of the camera, and by where the casters' light lands: the median of what they
// meet, the floor as a rule, is shown as a mid grey, and the brightest thousandth of the picture, what glows,
// as white. Where light glows too little for that, the contrast is higher; where it glows over eight times as
// bright as white, or a tenth of the picture would be white, or half of it is brighter than the floor, the
// picture is darker. What is emitted, and what glass and mirrors show the camera, is left out.
// `settings.exposure` adds EV. Where the camera meets nothing, or there is none: as if it saw an open floor
// of light grey. `pilot`: follows the casters' light.
Exposure exposure_of(const Scene& scene, const Settings& settings, const std::optional<View>& camera,
                     const Pilot& pilot);

}  // namespace caustics
