// The kernel by which one landing is spread over the caustic map.
#pragma once

namespace caustics {

// Texels of a map that the footprint of a landing may span, where light is followed from surface to surface.
inline constexpr double kLargestFootprint = 8.0;

struct Settings;

// Lengths in texels. A Gaussian of standard deviation sigma is cut at `radius` = 3 sigma along each
// axis and divided by the mass inside, so that a splat that lies wholly in the map deposits exactly
// its flux. Point splats have radius 0.
struct SplatKernel {
  double radius = 0.0;
  double sharpness = 0.0;   // 1 / (sigma sqrt 2)
  double mass = 1.0;        // erf(radius * sharpness): along one axis, before the division
  double point_size = 1.0;  // pixels: covers every texel that the kernel touches
  // The share of the kernel between `from` and `to`, offsets from its centre along one axis.
  double share(double from, double to) const;
};
SplatKernel splat_kernel(const Settings& settings);

// Texels along a cascade's border that are not looked up: splats may have their middles beyond it, and one
// for the look-up.
double cascade_border(const Settings& settings);

}  // namespace caustics
