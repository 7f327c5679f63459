#include "lab/reference/closed_forms.hpp"

#include <algorithm>
#include <cmath>

#include "lab/reference/squared.hpp"

namespace caustics {

namespace {

double transmittance_at(double incidence, double n) {
  return 1.0 - fresnel(std::cos(incidence), 1.0, n).mean();
}

}  // namespace

std::optional<double> refraction_angle(double incidence, double n1, double n2) {
  const double sine = n1 / n2 * std::sin(incidence);
  if (std::fabs(sine) > 1.0) return std::nullopt;
  return std::asin(sine);
}

double critical_angle(double n) { return std::asin(1.0 / n); }

double brewster_angle(double n) { return std::atan(n); }

Reflectance fresnel(double cos_incidence, double n1, double n2) {
  if (n1 == n2) return {0.0, 0.0};
  const double eta = n1 / n2;
  const double ci = std::max(cos_incidence, 0.0);
  const double ct_squared = (1.0 - eta) * (1.0 + eta) + squared(eta * ci);
  if (ct_squared < 0.0) return {1.0, 1.0};
  const double ct = std::sqrt(ct_squared);
  return {squared((n1 * ci - n2 * ct) / (n1 * ci + n2 * ct)),
          squared((n1 * ct - n2 * ci) / (n1 * ct + n2 * ci))};
}

std::optional<glm::dvec3> refract_direction(const glm::dvec3& direction, const glm::dvec3& normal,
                                            double eta) {
  const double ci = std::max(0.0, -glm::dot(direction, normal));
  const double ct_squared = (1.0 - eta) * (1.0 + eta) + squared(eta * ci);
  if (ct_squared < 0.0) return std::nullopt;
  const double sum = eta * ci + std::sqrt(ct_squared);
  const double mu = sum > 0.0 ? (1.0 - eta) * (1.0 + eta) / sum : 0.0;
  return glm::normalize(eta * direction - mu * normal);
}

double beer_lambert(double absorption, double distance) { return std::exp(-absorption * distance); }

double absorption_of(double attenuation_color, double attenuation_distance) {
  return -std::log(attenuation_color) / attenuation_distance;
}

double slab_offset(double incidence, double n, double thickness) {
  const double inside = std::asin(std::sin(incidence) / n);
  return thickness * std::sin(incidence - inside) / std::cos(inside);
}

double slab_floor_shift(double incidence, double n, double thickness) {
  const double inside = std::asin(std::sin(incidence) / n);
  return thickness * (std::tan(incidence) - std::tan(inside));
}

double slab_transmittance(double incidence, double n, double thickness, double absorption) {
  const double inside = std::asin(std::sin(incidence) / n);
  return squared(transmittance_at(incidence, n)) * beer_lambert(absorption, thickness / std::cos(inside));
}

// The geometric series of internal reflections: (1 - R)^2 (1 + R^2 + R^4 + ...) = (1 - R) / (1 +
// R).
double slab_transmittance_all_bounces(double incidence, double n) {
  const Reflectance r = fresnel(std::cos(incidence), 1.0, n);
  return 0.5 * ((1.0 - r.s) / (1.0 + r.s) + (1.0 - r.p) / (1.0 + r.p));
}

double LightOverWater::landing(double theta) const {
  return height * std::tan(theta) + depth * std::tan(std::asin(std::sin(theta) / index));
}

// Flux I sin(theta) dtheta dphi falls on X dX dphi; on the axis, its limit.
double LightOverWater::irradiance(double theta) const {
  const double transmitted = transmittance_at(theta, index);
  if (theta < 1e-9) return transmitted / squared(height + depth / index);
  const double inside = std::asin(std::sin(theta) / index);
  const double slope =
      height / squared(std::cos(theta)) + depth * std::cos(theta) / (index * std::pow(std::cos(inside), 3));
  return transmitted * std::sin(theta) / (landing(theta) * slope);
}

std::optional<double> prism_deviation(double apex, double n, double incidence) {
  const double second = apex - std::asin(std::sin(incidence) / n);
  const double sine = n * std::sin(second);
  if (std::fabs(sine) > 1.0) return std::nullopt;
  return incidence + std::asin(sine) - apex;
}

double prism_least_deviation(double apex, double n) {
  return 2.0 * std::asin(n * std::sin(0.5 * apex)) - apex;
}

double prism_least_incidence(double apex, double n) {
  return std::asin(n * std::sin(apex - critical_angle(n)));
}

double dispersive_index(double n, double dispersion, double wavelength) {
  const double spread = (n - 1.0) * dispersion / 20.0;
  return std::max(1.0, n + spread * (523655.0 / squared(wavelength) - 1.5168));
}

double bk7_index(double wavelength) {
  constexpr std::pair<double, double> kTerms[] = {
      {1.03961212, 0.00600069867}, {0.231792344, 0.0200179144}, {1.01046945, 103.560653}};
  const double square = squared(wavelength);
  double sum = 1.0;
  for (const auto& [strength, resonance] : kTerms) sum += strength * square / (square - resonance);
  return std::sqrt(sum);
}

double ring_axis_crossing(double radius, double t) { return radius / (2.0 * std::cos(t)); }

glm::dvec2 ring_envelope(double radius, double t) {
  return 0.25 * radius *
         glm::dvec2(3.0 * std::cos(t) - std::cos(3.0 * t), 3.0 * std::sin(t) - std::sin(3.0 * t));
}

double ring_irradiance(double radius, double t, double s, double reflectance) {
  const double width = radius * std::cos(t);
  return reflectance * width / std::fabs(width - 2.0 * s);
}

// The optical path to the focus is the same for all rays: r^2 = (n^2 - 1) z^2 + 2 (n - 1) F |z|.
double HyperbolicLens::surface(double r) const {
  const double a = squared(index) - 1.0, b = (index - 1.0) * focus;
  return -squared(r) / (b + std::sqrt(squared(b) + a * squared(r)));
}

// From the surface's equation: dz / dr = r / (a z - (n - 1) F).
double HyperbolicLens::slope(double r) const {
  return r / ((squared(index) - 1.0) * surface(r) - (index - 1.0) * focus);
}

double HyperbolicLens::landing(double r, double plane) const {
  return r * (focus - plane) / (focus - surface(r));
}

double HyperbolicLens::irradiance(double r, double plane) const {
  const double z = surface(r);
  if (r == 0.0) return squared(focus / (focus - plane));
  const double landed = landing(r, plane);
  const double stretch = (focus - plane) * (focus - z + r * slope(r)) / squared(focus - z);
  return std::fabs(r / (landed * stretch));
}

}  // namespace caustics
