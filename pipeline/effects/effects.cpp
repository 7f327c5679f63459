#include "pipeline/effects/effects.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "pipeline/gpu/error.hpp"
#include "pipeline/views/all_around.hpp"
#include "pipeline/effects/backdrop.hpp"
#include "pipeline/effects/branches.hpp"
#include "pipeline/views/cascades.hpp"
#include "pipeline/effects/caustic_color.hpp"
#include "pipeline/effects/medium_effects.hpp"
#include "pipeline/effects/surface_role.hpp"
#include "pipeline/effects/textured_casters.hpp"
#include "pipeline/effects/water_waves.hpp"
#include "pipeline/scene/exact.hpp"
#include "pipeline/scene/view.hpp"

namespace caustics {

namespace {

std::string count(std::size_t n, const std::string& singular, const std::string& plural) {
  return std::to_string(n) + " " + (n == 1 ? singular : plural);
}

// Where a mesh lies, as a sphere.
struct Sphere {
  glm::dvec3 centre{0.0};
  double radius = 0.0;
};

Sphere sphere_of(const Mesh& mesh) {
  const glm::dvec3 lower(mesh.lower), upper(mesh.upper);
  const glm::dvec3 half = 0.5 * (upper - lower);
  return {0.5 * (upper + lower), exact::length(half)};
}

// Does the sphere lie wholly outside the cone? It does when one of two planes parts them: the one
// across the axis at the tip, or the one that touches the cone on the sphere's side.
bool cone_misses(const Light& light, const Sphere& sphere) {
  const glm::dvec3 to = sphere.centre - light.position;
  const double along = exact::dot(to, light.direction);
  const double across = std::sqrt(std::max(exact::dot(to, to) - along * along, 0.0));
  double sine, cosine;
  const double widest =
      light.lambertian ? 0.5 * exact::kPi : static_cast<double>(light.outer_cone);
  exact::sin_cos(widest, sine, cosine);
  return along < -sphere.radius || across * cosine - along * sine > sphere.radius;
}

// Nearest and farthest distance of a box along the light's way: metres along a directional light,
// from the position of the others.
struct Reach {
  double nearest, farthest;
};

Reach reach_of(const Light& light, const Mesh& mesh) {
  const Sphere sphere = sphere_of(mesh);
  if (light.type != LightType::Directional) {
    const glm::dvec3 to = sphere.centre - light.position;
    const double distance = exact::length(to);
    return {std::max(distance - sphere.radius, 0.0), distance + sphere.radius};
  }
  const glm::dvec3 half = 0.5 * (glm::dvec3(mesh.upper) - glm::dvec3(mesh.lower));
  const glm::dvec3& d = light.direction;
  const double middle = exact::dot(sphere.centre, d);
  const double extent = half.x * std::fabs(d.x) + half.y * std::fabs(d.y) + half.z * std::fabs(d.z);
  return {middle - extent, middle + extent};
}

bool dark(const Light& light) {
  return !(light.intensity > 0.0f) ||
         !(std::max({light.color.x, light.color.y, light.color.z}) > 0.0f);
}

// Why no light of this kind gets from the light by the mesh onto a receiver, or nothing.
// `receivers`: the farthest that any of them reaches from the light; none where there is no receiver.
std::string unreachable(const Scene& scene, const Light& light, std::size_t index, bool mirror,
                        std::optional<double> receivers) {
  const Mesh& mesh = scene.meshes[index];
  if (dark(light)) return "the light's intensity or colour is 0";
  if (light.emitter == static_cast<int>(index)) return "it is the light itself";
  const Reach caster = reach_of(light, mesh);
  if (light.type == LightType::Spot && cone_misses(light, sphere_of(mesh))) {
    return "the spot light's cone misses it";
  }
  if (light.lambertian && cone_misses(light, sphere_of(mesh))) return "it lies behind the light";
  if (light.type != LightType::Directional && caster.nearest > static_cast<double>(light.range)) {
    return "it lies beyond the light's range of " + number_text(light.range) + " m";
  }
  if (!receivers) return "there is no diffuse receiver";
  // A mirror sends light any way.
  if (mirror || *receivers > caster.nearest) return {};
  return "no receiver lies behind it, seen from the light";
}

// Looked for once a light, not once a light and caster: there may be a million of them.
std::optional<double> farthest_receiver(const Scene& scene, const Light& light, const std::vector<SurfaceRole>& surfaces) {
  std::optional<double> farthest;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (surfaces[i].role != Role::Receiver) continue;
    const double here = reach_of(light, scene.meshes[i]).farthest;
    farthest = farthest ? std::max(*farthest, here) : here;
  }
  return farthest;
}

// The lights as a person knows them.
const std::vector<Light>& known_lights(const Scene& scene) {
  return scene.sources.empty() ? scene.lights : scene.sources;
}

std::string light_name(const Scene& scene, int index) {
  const Light& light = source_of(scene, index);
  return quoted_name("light", light.name,
                     static_cast<std::size_t>(light.source < 0 ? index : light.source));
}

std::size_t count_roles(const Effects& effects, Role role) {
  return static_cast<std::size_t>(
      std::count_if(effects.surfaces.begin(), effects.surfaces.end(),
                    [&](const SurfaceRole& s) { return s.role == role; }));
}

// One expectation for each light and mesh that looks as if it threw a caustic. With IOR 1 there is
// no focus, but the light has to be carried through, so what the plan does is the same.
void add_expectations(const Scene& scene, const std::vector<Judgement>& judgements,
                      Effects& effects) {
  for (std::size_t l = 0; l < scene.lights.size(); ++l) {
    const std::optional<double> receivers = farthest_receiver(scene, scene.lights[l], effects.surfaces);
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
      if (!judgements[m].looks_specular) continue;
      Expectation e{static_cast<int>(l), static_cast<int>(m), false, judgements[m].no_caustic};
      const Role role = judgements[m].role.role;
      if (is_caster(role)) {
        const Mesh& mesh = scene.meshes[m];
        e.reason = unreachable(scene, scene.lights[l], m, role == Role::Mirror, receivers);
        e.expected = e.reason.empty();
        const float ior = scene.materials[static_cast<std::size_t>(mesh.material)].ior;
        if (e.expected && role == Role::Mirror) {
          e.reason = "light reaches it and is mirrored onto what stands around";
        } else if (e.expected) {
          e.reason = ior == 1.0f ? "IOR 1 bends nothing: its light passes, but without a focus"
                                 : "light reaches it and a receiver lies behind it";
        }
      }
      effects.expectations.push_back(std::move(e));
    }
  }
}

// Whether, for some light, a diffuse surface could shadow another or a caster. Casters shadow by their map.
bool anything_shadows(const Scene& scene, const Effects& effects) {
  for (const Light& light : scene.lights) {
    if (dark(light)) continue;
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
      const Role role = effects.surfaces[m].role;
      if (role != Role::Receiver || light.emitter == static_cast<int>(m)) continue;
      if (!is_backdrop(scene, m, light)) return true;
    }
  }
  return false;
}

void add_area_lights(const Scene& scene, Effects& effects) {
  const std::vector<Light>& lights = known_lights(scene);
  const auto has_size = [](const Light& light) { return light.shape != LightShape::None; };
  const std::size_t sized =
      static_cast<std::size_t>(std::count_if(lights.begin(), lights.end(), has_size));
  if (sized == 0) {
    effects.list.push_back({"area lights", false, "no light has a size"});
    return;
  }
  const std::size_t samples = static_cast<std::size_t>(
      std::count_if(scene.lights.begin(), scene.lights.end(), [&](const Light& light) {
        return light.source >= 0 && has_size(scene.sources[static_cast<std::size_t>(light.source)]);
      }));
  effects.list.push_back({"area lights", samples > sized,
                          count(sized, "light has a size", "lights have a size") +
                              (samples > sized ? ", " + std::to_string(samples) + " samples in all"
                                               : "; drawn as a point each")});
}

void add_light_effects(const Scene& scene, const Settings& settings, Effects& effects) {
  const std::vector<Light>& lights = known_lights(scene);
  const std::size_t lit = static_cast<std::size_t>(std::count_if(
      lights.begin(), lights.end(), [](const Light& light) { return !dark(light); }));
  const std::size_t receivers = count_roles(effects, Role::Receiver);
  const std::size_t refractors = count_roles(effects, Role::Refractor);
  const std::size_t mirrors = count_roles(effects, Role::Mirror);
  const std::string diffuse_surfaces = count(receivers, "diffuse surface", "diffuse surfaces");
  const auto add = [&](const char* name, bool active, const std::string& reason) {
    effects.list.push_back({name, active, reason});
  };
  add("light", lit > 0, lit > 0 ? count(lit, "light", "lights") : "no light shines");
  add_area_lights(scene, effects);
  add("receivers", receivers > 0, receivers > 0 ? diffuse_surfaces : "no surface is diffuse");
  const bool reached = std::any_of(effects.expectations.begin(), effects.expectations.end(),
                                   [](const Expectation& e) { return e.expected; });
  const auto first = std::find_if(
      effects.expectations.begin(), effects.expectations.end(), [&](const Expectation& e) {
        return is_caster(effects.surfaces[static_cast<std::size_t>(e.mesh)].role);
      });
  const auto caster = std::find_if(effects.surfaces.begin(), effects.surfaces.end(),
                                   [](const auto& s) { return is_caster(s.role); });
  if (reached) {
    add("caustics", true, caster->reason);
  } else if (refractors + mirrors == 0) {
    add("caustics", false, "no surface is smooth metal, or smooth, solid glass or water");
  } else {
    add("caustics", false,
        first == effects.expectations.end()
            ? "no light shines"
            : light_name(scene, first->light) + ": " + first->reason);
  }
  const bool cells = reached && settings.splat == Splat::Cell;
  add("cells", cells,
      cells ? "four neighbouring landings share their light by exact overlap"
            : reached ? "landings are splatted one by one, as asked for" : "there is no caustic");
  const auto solid = std::find_if(effects.surfaces.begin(), effects.surfaces.end(),
                                  [](const auto& s) { return s.two_interfaces; });
  const bool exits = solid != effects.surfaces.end();
  add("exit surface", exits, exits ? solid->reason : "no refractor has a second surface");
  const bool occluders = lit > 0 && anything_shadows(scene, effects);
  add("occluders", occluders,
      occluders ? "an opaque surface can stand in the light's way"
                : "no opaque surface can shadow another or a caster");
  const std::size_t panes = count_roles(effects, Role::ThinPane);
  add("thin panes", panes > 0,
      panes > 0 ? count(panes, "thin pane", "thin panes") + " that tint what passes straight through"
                : "none in the scene");
  add("mirrors", mirrors > 0,
      mirrors > 0 ? count(mirrors, "mirror", "mirrors") + ": smooth metal" : "none in the scene");
  add("seen casters", refractors + mirrors > 0,
      refractors + mirrors == 0
          ? "no refractor to look through, no mirror to look into"
          : count(refractors, "refractor", "refractors") + " to look through, " +
                count(mirrors, "mirror", "mirrors") + " to look into");
}

// Meshes that shine light the scene only on request.
void add_emitters(const Scene& scene, Effects& effects) {
  std::size_t shining = 0, lights = 0;
  for (const Mesh& mesh : scene.meshes) {
    const glm::vec3 e = scene.materials[static_cast<std::size_t>(mesh.material)].emissive;
    shining += std::max({e.x, e.y, e.z}) > 0.0f ? 1 : 0;
  }
  for (const Light& light : known_lights(scene)) lights += light.shape == LightShape::Mesh ? 1 : 0;
  const std::string found = count(shining, "mesh that shines", "meshes that shine");
  effects.list.push_back(
      {"emissive lights", lights > 0,
       shining == 0  ? "none in the scene"
       : lights > 0 ? found + ", lights of their own"
                    : found + ", but not on others; -D emissive.lights=on makes lights of them"});
}

// Receivers that are one plane hide nothing from any light.
void add_hidden_receivers(const Scene& scene, const Settings& settings, Effects& effects) {
  const bool window = std::any_of(effects.all_around.begin(), effects.all_around.end(),
                                  [](const std::string& reason) { return reason.empty(); });
  const bool plane = receivers_are_one_plane(scene, effects);
  const bool active = effects.active("caustics") && settings.hidden_receivers && !plane && window &&
                      !effects.active("medium") && settings.estimator != Estimator::Impostor;
  effects.list.push_back({"hidden receivers", active,
                          active                                          ? "receivers can hide others from a light"
                          : !effects.active("caustics")                   ? "there is no caustic"
                          : plane                                         ? "all receivers lie in one plane"
                          : !settings.hidden_receivers                    ? "not asked for"
                          : settings.estimator == Estimator::Impostor     ? "impostors see around the casters"
                          : !window                                       ? "the lights see all around"
                                                                          : "not simulated in a medium"});
}

// What is found in the scene but not simulated yet: never active, and the reason says so.
void add_missing_effects(const std::vector<Judgement>& judgements, Effects& effects) {
  const auto rough = static_cast<std::size_t>(std::count_if(
      judgements.begin(), judgements.end(), [](const Judgement& judgement) { return judgement.rough; }));
  effects.list.push_back({"rough glass", false,
                          rough == 0 ? "none in the scene"
                                     : count(rough, "surface", "surfaces") +
                                           " of rough glass: not simulated yet; drawn as diffuse"});
}

}  // namespace

std::string_view name_of(Role role) {
  switch (role) {
    case Role::Receiver:
      return "receiver";
    case Role::Refractor:
      return "refractor";
    case Role::ThinPane:
      return "thin pane";
    case Role::Mirror:
      return "mirror";
  }
  return "unknown";
}

const Effect& Effects::find(std::string_view name) const {
  const auto found = std::find_if(list.begin(), list.end(),
                                  [&](const Effect& effect) { return effect.name == name; });
  if (found == list.end()) {
    throw Error(ExitCode::InternalError, "there is no effect named '" + std::string(name) + "'");
  }
  return *found;
}

Effects effects_of(const Scene& scene, const Settings& settings) {
  Effects effects;
  std::vector<Judgement> judgements;
  for (const Mesh& mesh : scene.meshes) {
    judgements.push_back(
        judge(mesh, scene.materials[static_cast<std::size_t>(mesh.material)], settings));
    effects.surfaces.push_back(judgements.back().role);
  }
  add_expectations(scene, judgements, effects);
  add_light_effects(scene, settings, effects);
  add_textured_casters(scene, settings, effects);
  add_emitters(scene, effects);
  add_branches(scene, settings, effects);
  add_caustic_color(scene, effects);
  add_water_waves(scene, effects);
  add_medium(scene, effects);
  add_all_around(scene, settings, effects);
  add_cascades(settings, effects);
  add_hidden_receivers(scene, settings, effects);
  add_missing_effects(judgements, effects);
  return effects;
}

}  // namespace caustics
