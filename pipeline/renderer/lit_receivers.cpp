#include "pipeline/renderer/lit_receivers.hpp"

#include <limits>

#include "pipeline/scene/exact.hpp"

namespace caustics {

namespace {

// Less of what lands is left to chance: it may be a few rays'.
constexpr double kLeastHidden = 1e-3, kLeastBehind = 2e-3;
// So much of what is hidden lies on one kind of sides where only that is looked for.
constexpr double kNearlyAll = 0.98;
// The share of what lands from behind that may land from before on the same receivers: each side shows both.
constexpr double kMostMixed = 0.1;

struct TowardsLight {
  glm::dvec3 direction;
  double distance;  // metres
};

TowardsLight towards(const Light& light, const glm::dvec3& p) {
  if (light.type == LightType::Directional)
    return {-light.direction, std::numeric_limits<double>::infinity()};
  const glm::dvec3 way = light.position - p;
  return {exact::normalise(way, glm::dvec3(0.0, 1.0, 0.0)), exact::length(way)};
}

// As passes/shared/casters_column.glsl has it of light that is followed, whose column is the casters' own.
bool stands_before_casters(const LightViews& views, const glm::dvec3& p) {
  const View& column = views.caster;
  const glm::dvec3 q = column.coordinates(p);
  if (column.cube) return exact::length(q) < views.casters_nearest;
  const glm::dvec2 at = column.window(q);
  const bool inside = at.x >= column.window_lower.x && at.x <= column.window_upper.x &&
                      at.y >= column.window_lower.y && at.y <= column.window_upper.y;
  return inside && q.z < views.casters_nearest;
}

}  // namespace

std::vector<LandingSeen> seen_by_light(const LitScene& scene, const std::vector<LightLanding>& landings) {
  const Light& light = scene.light;
  // Receivers in the landing's place, or in the light's, hide nothing.
  const double touch = 2.0 * static_cast<double>(scene.tables.touch());
  std::vector<LightRay> rays;
  std::vector<LandingSeen> seen;
  for (const LightLanding& landing : landings) {
    const TowardsLight to = towards(light, landing.position);
    const bool away = exact::dot(scene.tables.plane_of(landing.triangle), to.direction) <= 0.0;
    seen.push_back({.behind = away == landing.front && landing.mesh != light.emitter, .away = away});
    rays.push_back({.origin = landing.position + to.direction * touch,
                    .direction = to.direction,
                    .emitter = light.emitter,
                    .own = landing.triangle});
  }
  for (const LightLanding& met : scene.paths.first_receivers(rays)) {
    const glm::dvec3& from = landings[met.ray].position;
    const bool between = exact::length(met.position - from) < towards(light, from).distance - 2.0 * touch;
    seen[met.ray].hidden =
        between && met.mesh != light.emitter && !stands_before_casters(scene.views, met.position);
  }
  return seen;
}

namespace {

// Chooses the map for what comes from behind, by the landings that are not hidden.
LitFromBehind from_behind(const std::vector<LightLanding>& landings, const std::vector<LandingSeen>& seen,
                          std::size_t meshes) {
  std::vector<double> before(meshes), behind(meshes);
  double all = 0.0, all_behind = 0.0;
  for (std::size_t i = 0; i < landings.size(); ++i) {
    const double flux = flux_of(landings[i]);
    all += flux;
    if (seen[i].behind) all_behind += flux;
    if (!seen[i].hidden)
      (seen[i].behind ? behind : before)[static_cast<std::size_t>(landings[i].mesh)] += flux;
  }
  if (!(all_behind > kLeastBehind * all)) return LitFromBehind::No;
  double mixed = 0.0, shown = 0.0;
  for (std::size_t m = 0; m < meshes; ++m) {
    shown += behind[m];
    if (behind[m] > 0.0) mixed += before[m];
  }
  return mixed > kMostMixed * shown ? LitFromBehind::InFarthest : LitFromBehind::InNearest;
}

}  // namespace

LitReceivers lit_receivers(const std::vector<LightLanding>& landings, const std::vector<LandingSeen>& seen,
                           std::size_t meshes) {
  std::vector<double> by_mesh(meshes);
  double all = 0.0, hidden = 0.0, away = 0.0;
  LitReceivers lit{.behind = from_behind(landings, seen, meshes)};
  for (std::size_t i = 0; i < landings.size(); ++i) {
    const double flux = flux_of(landings[i]);
    all += flux;
    if (!seen[i].hidden && !(seen[i].behind && lit.behind == LitFromBehind::InFarthest)) continue;
    hidden += flux;
    by_mesh[static_cast<std::size_t>(landings[i].mesh)] += flux;
    if (seen[i].away) away += flux;
  }
  if (!(hidden > kLeastHidden * all)) return lit;
  for (const double flux : by_mesh) lit.hidden.push_back(flux > kLeastHidden * hidden);
  if (away > kNearlyAll * hidden) lit.hidden_sides = OutwardSides::Away;
  if (hidden - away > kNearlyAll * hidden) lit.hidden_sides = OutwardSides::Towards;
  return lit;
}

}  // namespace caustics
