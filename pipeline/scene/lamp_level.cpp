#include "pipeline/scene/lamp_level.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/scene/defaults.hpp"
#include "pipeline/scene/exact.hpp"
#include "pipeline/scene/low_discrepancy.hpp"
#include "pipeline/scene/triangle_tree.hpp"

namespace caustics {

namespace {

constexpr double kBrighter = 0.25;  // of the light
// Of all lamps together; of one at least and at most.
constexpr std::size_t kRays = 4096, kLeastRays = 16, kMostRays = 256;

// The k-th of `count` directions, spread evenly over all that the light shines to.
glm::dvec3 direction_of(const Light& light, int k, int count) {
  double sine = 0.0, cosine = 0.0, least = -1.0;
  if (light.lambertian) least = 0.0;
  if (light.type == LightType::Spot) exact::sin_cos(static_cast<double>(light.outer_cone), sine, least);
  const double along = 1.0 - (1.0 - least) * stratum(k, count);
  exact::sin_cos(2.0 * exact::kPi * stepped(k, kGoldenStep), sine, cosine);
  const glm::dvec3 x = exact::perpendicular(light.direction), y = exact::cross(light.direction, x);
  return light.direction * along + (x * cosine + y * sine) * std::sqrt(std::max(1.0 - along * along, 0.0));
}

struct Arrival {
  double irradiance, flux;
};

void follow(const Scene& scene, const Light& light, const TriangleTree& receivers, int rays,
            std::vector<Arrival>& arrivals) {
  const auto samples = std::count_if(scene.lights.begin(), scene.lights.end(), [&](const Light& other) {
    return light.source >= 0 && other.source == light.source;
  });
  for (int k = 0; k < rays; ++k) {
    const glm::dvec3 direction = direction_of(light, k, rays);
    const auto hit = receivers.nearest(light.position, direction, {}, light.emitter);
    if (!hit || !(hit->distance > 0.0)) continue;
    const double sent = exact::luminance(light.color) * static_cast<double>(light.intensity) *
                        (light.lambertian ? exact::dot(direction, light.direction) : 1.0);
    const double facing = exact::dot(plane_normal(scene, hit->id), direction);
    // As passes/shared/incidence.glsl has it near the light.
    const double squared = hit->distance * hit->distance, own = light.sample_radius * light.sample_radius;
    const double spread = light.lambertian ? squared + own : std::max(squared, own);
    const double there = sent * std::max(facing, -facing) / spread;
    arrivals.push_back({there * static_cast<double>(std::max<std::ptrdiff_t>(samples, 1)), sent});
  }
}

}  // namespace

double lamp_level(const Scene& scene) {
  const auto is_lamp = [](const Light& light) { return light.type != LightType::Directional; };
  const auto lamps =
      static_cast<std::size_t>(std::count_if(scene.lights.begin(), scene.lights.end(), is_lamp));
  if (lamps == 0) return 0.0;
  const TriangleTree receivers(scene, opaque_receivers(scene));
  const auto rays = static_cast<int>(std::clamp(kRays / lamps, kLeastRays, kMostRays));
  std::vector<Arrival> arrivals;
  for (const Light& light : scene.lights)
    if (is_lamp(light)) follow(scene, light, receivers, rays, arrivals);
  std::sort(arrivals.begin(), arrivals.end(),
            [](const Arrival& a, const Arrival& b) { return a.irradiance > b.irradiance; });
  double all = 0.0, brighter = 0.0;
  for (const Arrival& arrival : arrivals) all += arrival.flux;
  for (const Arrival& arrival : arrivals) {
    brighter += arrival.flux;
    if (brighter >= kBrighter * all) return arrival.irradiance;
  }
  return 0.0;
}

}  // namespace caustics
