// The single water wave of lab/reference/closed_forms.hpp.
#include <algorithm>
#include <cmath>

#include "lab/reference/closed_forms.hpp"
#include "lab/reference/squared.hpp"

namespace caustics {

namespace {

// tan of the angle by which a vertical ray is turned where the surface leans by `incidence`.
double bend(double incidence, double index) {
  return std::tan(incidence - std::asin(std::sin(incidence) / index));
}

}  // namespace

double WaterWave::height(double x) const { return depth + amplitude * std::cos(wave_number * x); }

double WaterWave::incidence(double x) const {
  return std::atan(-amplitude * wave_number * std::sin(wave_number * x));
}

double WaterWave::landing(double x) const { return x + height(x) * bend(incidence(x), index); }

// d/dx of x + (depth + f) tau, with tau = tan(phi - asin(sin(phi) / n)) and phi = atan(f').
double WaterWave::landing_derivative(double x) const {
  const double slope = -amplitude * wave_number * std::sin(wave_number * x);
  const double curvature = -amplitude * squared(wave_number) * std::cos(wave_number * x);
  const double phi = std::atan(slope), tau = bend(phi, index);
  const double phi_slope = curvature / (1.0 + squared(slope));
  const double turn = 1.0 - std::cos(phi) / std::sqrt(squared(index) - squared(std::sin(phi)));
  return 1.0 + height(x) * (1.0 + squared(tau)) * turn * phi_slope + slope * tau;
}

double WaterWave::transmittance(double x) const {
  return fresnel ? 1.0 - caustics::fresnel(std::cos(incidence(x)), 1.0, index).mean() : 1.0;
}

double WaterWave::irradiance(double x) const { return transmittance(x) / std::fabs(landing_derivative(x)); }

double WaterWave::first_focus() const { return index / ((index - 1.0) * amplitude * squared(wave_number)); }

std::vector<double> irradiance_average(const WaterWave& wave, double lower, double upper, int pixels,
                                       double half_width) {
  const double pixel = (upper - lower) / pixels;
  // No ray runs farther sideways than that of the steepest slope from the highest crest.
  const double steepest = std::atan(std::fabs(wave.amplitude * wave.wave_number));
  const double reach = (wave.depth + std::fabs(wave.amplitude)) * bend(steepest, wave.index);
  const double start = std::max(lower - reach, -half_width);
  const double end = std::min(upper + reach, half_width);
  const double fine = std::min(pixel, 0.1 / std::fabs(wave.wave_number)) / 1024.0;
  const int steps = static_cast<int>(std::ceil(std::max(end - start, 0.0) / fine));
  std::vector<double> flux(static_cast<std::size_t>(pixels), 0.0);
  double x0 = start, landed0 = wave.landing(start);
  for (int i = 1; i <= steps; ++i) {
    const double x1 = start + (end - start) * i / steps, landed1 = wave.landing(x1);
    const double amount = (x1 - x0) * wave.transmittance(0.5 * (x0 + x1));
    const double low = (std::min(landed0, landed1) - lower) / pixel;
    const double high = (std::max(landed0, landed1) - lower) / pixel;
    // Spread evenly between the two landings, which lie within a pixel or two.
    for (int k = std::max(0, static_cast<int>(std::floor(low))); k < pixels && k <= high; ++k) {
      const double inside = std::min(high, k + 1.0) - std::max(low, static_cast<double>(k));
      if (inside < 0.0) continue;
      flux[static_cast<std::size_t>(k)] += high > low ? amount * inside / (high - low) : amount;
    }
    x0 = x1;
    landed0 = landed1;
  }
  for (double& value : flux) value /= pixel;
  return flux;
}

}  // namespace caustics
