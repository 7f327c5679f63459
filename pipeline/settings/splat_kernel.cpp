#include "pipeline/settings/splat_kernel.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/settings/settings.hpp"

namespace caustics {

namespace {

// Abramowitz and Stegun 7.1.28, the same form as the shaders' erf_of, so that the mass fits it.
double error_function(double x) {
  const double a = std::min(std::fabs(x), 6.0);
  double p = 0.0000430638;
  for (const double c : {0.0002765672, 0.0001520143, 0.0092705272, 0.0422820123, 0.0705230784, 1.0})
    p = p * a + c;
  for (int i = 0; i < 4; ++i) p = p * p;
  const double positive = 1.0 - 1.0 / p;
  return x < 0.0 ? -positive : positive;
}

}  // namespace

double SplatKernel::share(double from, double to) const {
  if (radius == 0.0) return from <= 0.0 && 0.0 < to ? 1.0 : 0.0;
  const double a = std::clamp(from, -radius, radius);
  const double b = std::clamp(to, -radius, radius);
  return 0.5 * (error_function(b * sharpness) - error_function(a * sharpness)) / mass;
}

SplatKernel splat_kernel(const Settings& settings) {
  if (settings.splat == Splat::Point) return {};
  const double sigma = static_cast<double>(settings.gaussian_sigma);
  SplatKernel kernel;
  kernel.radius = 3.0 * sigma;
  kernel.sharpness = 1.0 / (sigma * std::sqrt(2.0));
  kernel.mass = error_function(kernel.radius * kernel.sharpness);
  kernel.point_size = 2.0 * kernel.radius + 1.0;
  return kernel;
}

double cascade_border(const Settings& settings) { return splat_kernel(settings).radius + 1.0; }

}  // namespace caustics
