#include "pipeline/measure/light_shares.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

#include "pipeline/effects/dim_lights.hpp"
#include "pipeline/gpu/interrupt.hpp"
#include "pipeline/measure/meshes_in_the_way.hpp"
#include "pipeline/scene/exact.hpp"

namespace caustics {

namespace {

constexpr std::size_t kPointsOfMesh = 16;
// A light among its casters is not taken to be nearer than this share of a caster's radius.
constexpr double kNearest = 0.1;

std::size_t source_of(const Scene& scene, std::size_t light) {
  const int source = scene.lights[light].source;
  return source < 0 ? light : static_cast<std::size_t>(source);
}

// What a light gives a point, or less: of a spot light only within its inner cone. Lux.
double irradiance(const Light& light, const glm::dvec3& point) {
  if (light.type == LightType::Directional) return brightness(light);
  const glm::dvec3 to = point - light.position;
  const double squared = std::max(exact::dot(to, to), 1e-30), distance = std::sqrt(squared);
  const double along = exact::dot(to, light.direction) / distance;
  if (light.lambertian) return brightness(light) * std::max(along, 0.0) / squared;
  double sine, inner;
  exact::sin_cos(static_cast<double>(light.inner_cone), sine, inner);
  const bool reached = light.type != LightType::Spot || along >= inner;
  return reached ? brightness(light) / squared : 0.0;
}

// What it gives any point of a mesh at most.
double most_irradiance(const Light& light, const Mesh& mesh) {
  if (light.type == LightType::Directional) return brightness(light);
  const glm::dvec3 lower(mesh.lower), upper(mesh.upper), half = 0.5 * (upper - lower);
  const double radius = exact::length(half), away = exact::length(lower + half - light.position);
  const double nearest = std::max({away - radius, kNearest * radius, 1e-15});
  return brightness(light) / (nearest * nearest);
}

// One caster's light, by source.
struct CasterLight {
  double area = 0.0;   // of a box's surface around the caster
  double whole = 0.0;  // seen, mean over its points
  std::vector<double> seen, most;
};

CasterLight light_on(const Scene& scene, const Effects& effects, const MeshesInTheWay& ways, int mesh,
                     std::size_t sources) {
  CasterLight found{.seen = std::vector<double>(sources), .most = std::vector<double>(sources)};
  const std::vector<glm::dvec3> points =
      some_points(scene.meshes[static_cast<std::size_t>(mesh)], kPointsOfMesh);
  for (const Expectation& e : effects.expectations) {
    if (e.mesh != mesh || !e.expected || points.empty()) continue;
    stop_if_interrupted();
    const auto l = static_cast<std::size_t>(e.light);
    const Light& light = scene.lights[l];
    const std::size_t source = source_of(scene, l);
    double sum = 0.0;
    for (const glm::dvec3& point : points) {
      const double here = irradiance(light, point);
      if (here > 0.0 && !ways.stands_opaque(effects, light, point)) sum += here;
    }
    found.seen[source] += sum / static_cast<double>(points.size());
    found.most[source] += most_irradiance(light, scene.meshes[static_cast<std::size_t>(mesh)]);
  }
  const glm::dvec3 size(scene.meshes[static_cast<std::size_t>(mesh)].upper -
                        scene.meshes[static_cast<std::size_t>(mesh)].lower);
  found.area = 2.0 * (size.x * size.y + size.y * size.z + size.z * size.x);
  found.whole = std::accumulate(found.seen.begin(), found.seen.end(), 0.0);
  return found;
}

double largest_part(const std::vector<CasterLight>& casters, std::size_t source,
                    std::vector<double> CasterLight::*of) {
  double largest = 0.0;
  for (const CasterLight& caster : casters) {
    const double part = (caster.*of)[source];
    if (part > 0.0) largest = std::max(largest, caster.whole > 0.0 ? part / caster.whole : 1.0);
  }
  return largest;
}

// The weakest first, as long as all of them together stay below the limit on every caster.
void leave_out_weakest(const std::vector<CasterLight>& casters, double least,
                       std::vector<LightShare>& shares) {
  std::vector<std::pair<double, std::size_t>> weakest;
  for (std::size_t s = 0; s < shares.size(); ++s)
    if (const double most = largest_part(casters, s, &CasterLight::most); most > 0.0)
      weakest.emplace_back(most, s);
  std::sort(weakest.begin(), weakest.end());
  std::vector<double> left_out(casters.size(), 0.0);
  for (const auto& [most, source] : weakest) {
    for (std::size_t c = 0; c < casters.size(); ++c) {
      left_out[c] += casters[c].most[source];
      if (casters[c].most[source] > 0.0 && !(left_out[c] < least * casters[c].whole)) return;
    }
    shares[source].left_out = true;
  }
}

}  // namespace

std::vector<LightShare> light_shares(const Scene& scene, const Effects& effects, double least) {
  std::size_t sources = 0;
  std::vector<bool> throws(scene.lights.size());
  for (const Expectation& e : effects.expectations)
    if (e.expected) throws[source_of(scene, static_cast<std::size_t>(e.light))] = true;
  for (std::size_t l = 0; l < scene.lights.size(); ++l) sources = std::max(sources, source_of(scene, l) + 1);
  if (static_cast<std::size_t>(std::count(throws.begin(), throws.end(), true)) <= kFewLights) return {};
  const MeshesInTheWay ways(scene);
  std::vector<CasterLight> casters;
  for (int mesh = 0; mesh < static_cast<int>(scene.meshes.size()); ++mesh)
    if (is_caster(effects.surfaces[static_cast<std::size_t>(mesh)].role))
      casters.push_back(light_on(scene, effects, ways, mesh, sources));
  std::vector<LightShare> shares(sources);
  for (std::size_t s = 0; s < sources; ++s) {
    shares[s].share = largest_part(casters, s, &CasterLight::seen);
    for (const CasterLight& caster : casters) shares[s].on_casters += caster.area * caster.seen[s];
  }
  leave_out_weakest(casters, least, shares);
  return shares;
}

}  // namespace caustics
