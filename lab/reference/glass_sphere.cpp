// The glass sphere of lab/reference/closed_forms.hpp.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "lab/reference/closed_forms.hpp"
#include "lab/reference/squared.hpp"
#include "pipeline/scene/exact.hpp"

namespace caustics {

namespace {

// Simpson's rule for the mean of f(b) over the disc of impact parameters up to `largest` of a
// sphere: with b = R sin(alpha), b db / R^2 = sin(alpha) cos(alpha) dalpha, which is smooth up to
// the rim.
template <typename F>
double disc_integral(const GlassSphere& sphere, double largest, const F& f) {
  constexpr int kSteps = 20'000;
  const double end = std::asin(std::min(1.0, largest / sphere.radius));
  const double step = end / kSteps;
  double sum = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    const double alpha = step * i;
    // The last ray would graze: a hair inside, everything is defined.
    const double b = std::min(sphere.radius * std::sin(alpha), largest * (1.0 - 1e-15));
    const double weight = i == 0 || i == kSteps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    sum += weight * f(b) * std::sin(alpha) * std::cos(alpha);
  }
  return 2.0 * sum * step / 3.0;
}

// Flux in rings of the plane: ring k lies between k and k + 1 times `width`.
struct Rings {
  double width = 0.0;
  std::vector<double> flux{};  // square metres times E_perp

  // Spreads flux evenly over the radii from r0 to r1; what lies outside the last ring is left out.
  void add(double r0, double r1, double amount) {
    const double low = std::min(r0, r1) / width, high = std::max(r0, r1) / width;
    const auto count = static_cast<double>(flux.size());
    if (low >= count) return;
    const auto first = static_cast<std::size_t>(low);
    const auto last = static_cast<std::size_t>(std::min(high, count - 0.5));
    if (first == last && high < count) {
      flux[first] += amount;
      return;
    }
    for (std::size_t k = first; k <= last; ++k) {
      const double from = std::max(low, static_cast<double>(k));
      const double to = std::min(high, static_cast<double>(k) + 1.0);
      flux[k] += amount * (to - from) / (high - low);
    }
  }
};

// Books rays in equal steps of alpha = asin(b / R) to rings of the plane.
void book_rays(const GlassSphere& sphere, int ray_rings, Rings& rings) {
  const double end = std::asin(std::min(1.0, sphere.largest_impact() / sphere.radius));
  double b0 = 0.0, r0 = 0.0;
  for (int i = 1; i <= ray_rings; ++i) {
    const double b1 = sphere.radius * std::sin(end * i / ray_rings * (1.0 - 1e-12));
    const double r1 = sphere.landing(b1);
    const double amount = exact::kPi * (b1 - b0) * (b1 + b0) * sphere.transmittance(0.5 * (b0 + b1));
    if (r0 * r1 >= 0.0) {
      rings.add(std::fabs(r0), std::fabs(r1), amount);
    } else {  // crosses the axis: two parts, as long as the landing is near a straight line in b
      const double share = r0 / (r0 - r1);
      rings.add(std::fabs(r0), 0.0, amount * share);
      rings.add(0.0, std::fabs(r1), amount * (1.0 - share));
    }
    b0 = b1;
    r0 = r1;
  }
}

// Area of the disc round (0, 0) in the box from (0, 0) to (x, y), signed like x y.
double disc_in_quadrant(double radius, double x, double y) {
  const double u = std::min(std::fabs(x), radius), v = std::min(std::fabs(y), radius);
  const double sign = (x < 0.0) != (y < 0.0) ? -1.0 : 1.0;
  if (u * u + v * v <= radius * radius) return sign * u * v;
  const auto under_arc = [radius](double t) {  // integral of sqrt(radius^2 - t^2)
    return 0.5 * (t * std::sqrt(std::max(0.0, (radius - t) * (radius + t))) +
                  squared(radius) * std::asin(std::min(1.0, t / radius)));
  };
  const double corner = std::sqrt((radius - v) * (radius + v));
  return sign * (v * corner + under_arc(u) - under_arc(corner));
}

// Nearest and farthest distance of a box from (0, 0).
struct Reach {
  double nearest, farthest;
};

Reach reach_of(const glm::dvec2& lower, const glm::dvec2& upper) {
  const glm::dvec2 near = glm::max(glm::dvec2(0.0), glm::max(lower, -upper));
  const glm::dvec2 far = glm::max(glm::abs(lower), glm::abs(upper));
  return {glm::length(near), glm::length(far)};
}

// Flux inside a box: each ring's flux times the share of the ring's area inside.
double flux_in_box(const Rings& rings, const glm::dvec2& lower, const glm::dvec2& upper) {
  const Reach reach = reach_of(lower, upper);
  const auto first = static_cast<std::size_t>(reach.nearest / rings.width);
  const std::size_t last =
      std::min(static_cast<std::size_t>(reach.farthest / rings.width) + 1, rings.flux.size());
  double sum = 0.0;
  double inner_area = disc_in_box(rings.width * static_cast<double>(first), lower, upper);
  for (std::size_t k = first; k < last; ++k) {
    const double inner = rings.width * static_cast<double>(k), outer = inner + rings.width;
    const double outer_area = disc_in_box(outer, lower, upper);
    sum += rings.flux[k] * (outer_area - inner_area) / (exact::kPi * (outer - inner) * (outer + inner));
    inner_area = outer_area;
  }
  return sum;
}

}  // namespace

double GlassSphere::deviation(double b) const {
  return 2.0 * (std::asin(b / radius) - std::asin(b / (index * radius)));
}

double GlassSphere::landing(double b) const {
  const double delta = deviation(b);
  return (b - distance * std::sin(delta)) / std::cos(delta);
}

double GlassSphere::landing_derivative(double b) const {
  const double delta = deviation(b), cosine = std::cos(delta);
  const double slope =
      2.0 * (1.0 / std::sqrt((radius - b) * (radius + b)) - 1.0 / std::sqrt(squared(index * radius) - b * b));
  return 1.0 / cosine + slope * (b * std::sin(delta) - distance) / squared(cosine);
}

double GlassSphere::chord(double b) const {
  return 2.0 * std::sqrt(std::max(0.0, squared(radius) - squared(b / index)));
}

double GlassSphere::transmittance(double b) const {
  const double kept = beer_lambert(absorption, chord(b));
  if (loss == InterfaceLoss::None) return kept;
  const Reflectance r = fresnel(std::sqrt(std::max(0.0, 1.0 - squared(b / radius))), 1.0, index);
  if (loss == InterfaceLoss::Unpolarised) return kept * squared(1.0 - r.mean());
  return kept * 0.5 * (squared(1.0 - r.s) + squared(1.0 - r.p));
}

double GlassSphere::single_surface_landing(double b) const {
  const double alpha = std::asin(b / radius), beta = std::asin(b / (index * radius));
  return b - (distance + radius * std::cos(alpha)) * std::tan(alpha - beta);
}

double GlassSphere::axis_crossing(double b) const { return b / std::sin(deviation(b)); }

double GlassSphere::paraxial_focus() const { return index * radius / (2.0 * (index - 1.0)); }

double GlassSphere::marginal_focus() const {
  return squared(index) * radius / (2.0 * std::sqrt(squared(index) - 1.0));
}

double GlassSphere::largest_impact() const {
  if (index <= std::numbers::sqrt2) return radius * std::min(1.0, index);
  double low = 0.0, high = radius;  // the deviation grows with b
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (deviation(middle) < 0.5 * exact::kPi ? low : high) = middle;
  }
  return low;
}

double GlassSphere::irradiance(double r) const {
  constexpr int kSteps = 20'000;
  const double end = std::asin(std::min(1.0, largest_impact() / radius)) * (1.0 - 1e-12);
  const auto impact = [&](double step) { return radius * std::sin(end * step / kSteps); };
  double sum = 0.0;
  for (const double target : {r, -r}) {
    for (int i = 0; i < kSteps; ++i) {
      double low = impact(i), high = impact(i + 1);
      const bool rises = landing(low) < target;
      if (rises == (landing(high) < target)) continue;
      for (int k = 0; k < 100; ++k) {
        const double middle = 0.5 * (low + high);
        ((landing(middle) < target) == rises ? low : high) = middle;
      }
      sum += transmittance(low) * low / (r * std::fabs(landing_derivative(low)));
    }
  }
  return sum;
}

double GlassSphere::transmitted_share() const {
  return disc_integral(*this, radius * std::min(1.0, index), [this](double b) { return transmittance(b); });
}

double mean_absorption(const GlassSphere& sphere) {
  return disc_integral(sphere, sphere.radius * std::min(1.0, sphere.index),
                       [&](double b) { return beer_lambert(sphere.absorption, sphere.chord(b)); });
}

double disc_in_box(double radius, const glm::dvec2& lower, const glm::dvec2& upper) {
  return disc_in_quadrant(radius, upper.x, upper.y) - disc_in_quadrant(radius, lower.x, upper.y) -
         disc_in_quadrant(radius, upper.x, lower.y) + disc_in_quadrant(radius, lower.x, lower.y);
}

FloorIrradiance irradiance_average(const GlassSphere& sphere, const FloorSquare& floor, int rings_per_pixel,
                                   int ray_rings) {
  const double pixel = floor.side / floor.pixels;
  const glm::dvec2 upper = floor.lower + floor.side;
  Rings rings{.width = pixel / rings_per_pixel};
  rings.flux.resize(static_cast<std::size_t>(reach_of(floor.lower, upper).farthest / rings.width) + 1);
  book_rays(sphere, ray_rings, rings);
  FloorIrradiance result;
  for (int j = 0; j < floor.pixels; ++j) {
    for (int i = 0; i < floor.pixels; ++i) {
      const glm::dvec2 corner = floor.lower + pixel * glm::dvec2(i, j);
      const double flux = flux_in_box(rings, corner, corner + pixel);
      result.values.push_back(flux / squared(pixel));
      result.flux += flux;
    }
  }
  return result;
}

double annulus_average(const GlassSphere& sphere, double inner, double outer, int ray_rings) {
  // Of each disc the flux as a whole: one ring that is the disc.
  const auto flux_within = [&](double r) {
    if (r <= 0.0) return 0.0;
    Rings disc{.width = r, .flux = {0.0}};
    book_rays(sphere, ray_rings, disc);
    return disc.flux[0];
  };
  return (flux_within(outer) - flux_within(inner)) / (exact::kPi * (outer - inner) * (outer + inner));
}

}  // namespace caustics
