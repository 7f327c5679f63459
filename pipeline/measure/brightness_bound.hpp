// How bright a frame can be at most, by its lights: what exceeds it is no light, but a fault of the
// arithmetic.
#pragma once
#include <limits>
#include <vector>

#include "pipeline/scene/scene.hpp"
#include "pipeline/views/light_views.hpp"

namespace caustics {

struct Effects;
struct Settings;

struct BrightnessBound {
  double direct = 0.0, caustic = 0.0;  // irradiance, lux
  double radiance = 0.0;               // nit
};

enum class BoundBy : std::uint8_t { Guess, Triangles };

// Of any channel of any pixel, four times over. No light is nearer to a surface than to the nearest triangle
// (or than its own radius); no texel of a caustic map gets more than all the flux that its light sends
// through the casters' window; no surface scatters, and none mirrors, more than arrives. So a focus, however
// sharp, stays below it. Without a bound for the caustic where its weights are the paper's, which conserve no
// flux.
//
// `by`: Guess takes no triangle to be nearer to a lamp than a tenth of the scene's radius, and the image of
// the environment to be black: quick, and enough for most frames. Who finds something brighter asks again.
BrightnessBound brightness_bound(const Scene& scene, const Effects& effects, const Settings& settings,
                                 const std::vector<LightViews>& views, BoundBy by);

}  // namespace caustics
