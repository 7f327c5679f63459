#include "pipeline/plan/effects.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/gpu/error.hpp"
#include "pipeline/plan/backdrop.hpp"
#include "pipeline/plan/scene_on_device.hpp"
#include "pipeline/plan/spectrum.hpp"
#include "pipeline/plan/surface_role.hpp"
#include "pipeline/scene/exact.hpp"
#include "pipeline/scene/frame.hpp"

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
  exact::sin_cos(static_cast<double>(light.outer_cone), sine, cosine);
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
std::string unreachable(const Scene& scene, const Light& light, const Mesh& mesh, bool mirror,
                        const std::vector<SurfaceRole>& surfaces) {
  if (dark(light)) return "the light's intensity or colour is 0";
  const Reach caster = reach_of(light, mesh);
  if (light.type == LightType::Spot && cone_misses(light, sphere_of(mesh))) {
    return "the spot light's cone misses it";
  }
  if (light.type != LightType::Directional && caster.nearest > static_cast<double>(light.range)) {
    return "it lies beyond the light's range of " + number_text(light.range) + " m";
  }
  bool any = false;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (surfaces[i].role != Role::Receiver) continue;
    any = true;
    // A mirror sends light any way.
    if (mirror || reach_of(light, scene.meshes[i]).farthest > caster.nearest) return {};
  }
  return any ? "no receiver lies behind it, seen from the light" : "there is no diffuse receiver";
}

std::string light_name(const Scene& scene, int index) {
  return quoted_name("light", scene.lights[static_cast<std::size_t>(index)].name,
                     static_cast<std::size_t>(index));
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
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
      if (!judgements[m].looks_specular) continue;
      Expectation e{static_cast<int>(l), static_cast<int>(m), false, judgements[m].no_caustic};
      const Role role = judgements[m].role.role;
      if (is_caster(role)) {
        const Mesh& mesh = scene.meshes[m];
        e.reason = unreachable(scene, scene.lights[l], mesh, role == Role::Mirror, effects.surfaces);
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
      if (role != Role::Receiver) continue;
      if (!is_backdrop(scene, m, light)) return true;
    }
  }
  return false;
}

void add_light_effects(const Scene& scene, const Settings& settings, Effects& effects) {
  const std::size_t lit = static_cast<std::size_t>(std::count_if(
      scene.lights.begin(), scene.lights.end(), [](const Light& light) { return !dark(light); }));
  const std::size_t receivers = count_roles(effects, Role::Receiver);
  const std::size_t refractors = count_roles(effects, Role::Refractor);
  const std::size_t mirrors = count_roles(effects, Role::Mirror);
  const std::string diffuse_surfaces = count(receivers, "diffuse surface", "diffuse surfaces");
  const auto add = [&](const char* name, bool active, const std::string& reason) {
    effects.list.push_back({name, active, reason});
  };
  add("light", lit > 0, lit > 0 ? count(lit, "light", "lights") : "no light shines");
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

// The material of the refractor whose index depends most on the wavelength; null where none does.
const Material* most_dispersive(const Scene& scene, const Effects& effects) {
  const Material* most = nullptr;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    if (effects.surfaces[i].role != Role::Refractor) continue;
    const Material& material = scene.materials[static_cast<std::size_t>(scene.meshes[i].material)];
    if (!(main_dispersion(material) != 0.0f)) continue;
    if (!most || std::fabs(main_dispersion(material)) > std::fabs(main_dispersion(*most))) most = &material;
  }
  return most;
}

void add_dispersion(const Scene& scene, const Settings& settings, Effects& effects) {
  const Material* most = most_dispersive(scene, effects);
  const auto add = [&](bool active, const std::string& reason) {
    effects.list.push_back({"dispersion", active, reason});
  };
  if (!most) return add(false, "no refractor's index depends on the wavelength");
  const std::string what =
      quoted_name("material", most->name, static_cast<std::size_t>(most - scene.materials.data())) +
      " has dispersion " + number_text(most->dispersion);
  if (!effects.active("caustics")) return add(false, what + ", but there is no caustic");
  if (settings.wavelengths == 1) return add(false, what + ", but one wavelength was asked for");
  add(true, what + ": " + std::to_string(settings.wavelengths) +
                (settings.wavelengths == 3 ? " wavelengths, the C, d and F lines" : " wavelengths"));
}

void add_reflections(const Settings& settings, Effects& effects) {
  const auto add = [&](bool active, const std::string& reason) {
    effects.list.push_back({"reflections", active, reason});
  };
  if (count_roles(effects, Role::Refractor) == 0) return add(false, "no refractor in the scene");
  if (!settings.reflections) return add(false, "what refractors mirror is left out; -D reflections=yes");
  if (settings.weights == Weights::Paper) return add(false, "the paper's weights know no Fresnel share");
  if (!effects.active("caustics")) return add(false, "there is no caustic");
  add(true, "what refractors mirror throws a caustic, as asked for");
}

std::vector<Branch> branches_of(const Settings& settings, const Effects& effects) {
  std::vector<Branch> branches;
  if (effects.active("dispersion")) {
    for (const Wavelength& w :
         settings.wavelengths == 3 ? fraunhofer_lines() : spectrum(settings.wavelengths))
      branches.push_back({.name = number_text(w.nanometres, 4) + "nm",
                          .bend = bend_of(w.nanometres),
                          .color = w.color});
  } else {
    branches.push_back({});
  }
  if (effects.active("reflections")) branches.push_back({.name = "reflected", .reflected = true});
  return branches;
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
  add_dispersion(scene, settings, effects);
  add_reflections(settings, effects);
  add_missing_effects(judgements, effects);
  effects.branches = branches_of(settings, effects);
  return effects;
}

}  // namespace caustics
