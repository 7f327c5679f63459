#include "pipeline/effects/effects.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/effects/all_around.hpp"
#include "pipeline/effects/backdrop.hpp"
#include "pipeline/effects/branches.hpp"
#include "pipeline/effects/camera.hpp"
#include "pipeline/effects/cascades.hpp"
#include "pipeline/effects/caustic_color.hpp"
#include "pipeline/effects/expectations.hpp"
#include "pipeline/effects/further_surfaces.hpp"
#include "pipeline/effects/medium_effects.hpp"
#include "pipeline/effects/smooth_shading.hpp"
#include "pipeline/effects/surface_role.hpp"
#include "pipeline/effects/textured_casters.hpp"
#include "pipeline/effects/water_waves.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/scene/environment.hpp"
#include "pipeline/scene/exact.hpp"
#include "pipeline/scene/hierarchy_tables.hpp"
#include "pipeline/scene/view.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

namespace {

std::string count(std::size_t n, const std::string& singular, const std::string& plural) {
  return std::to_string(n) + " " + (n == 1 ? singular : plural);
}

// The lights as a person knows them.
const std::vector<Light>& known_lights(const Scene& scene) {
  return scene.sources.empty() ? scene.lights : scene.sources;
}

std::string light_name(const Scene& scene, int index) {
  const Light& light = source_of(scene, index);
  return quoted_name("light", light.name, static_cast<std::size_t>(light.source < 0 ? index : light.source));
}

std::size_t count_roles(const Effects& effects, Role role) {
  return static_cast<std::size_t>(std::count_if(effects.surfaces.begin(), effects.surfaces.end(),
                                                [&](const SurfaceRole& s) { return s.role == role; }));
}

// Whether, for some light, a diffuse surface could shadow another or a caster. Casters shadow by their map.
bool anything_shadows(const Scene& scene, const Effects& effects) {
  for (const Light& light : scene.lights) {
    if (is_dark(light)) continue;
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
  const std::size_t sized = static_cast<std::size_t>(std::count_if(lights.begin(), lights.end(), has_size));
  if (sized == 0) {
    effects.area_lights = {false, "no light has a size"};
    return;
  }
  const std::size_t samples = static_cast<std::size_t>(
      std::count_if(scene.lights.begin(), scene.lights.end(), [&](const Light& light) {
        return light.source >= 0 && has_size(scene.sources[static_cast<std::size_t>(light.source)]);
      }));
  effects.area_lights = {
      samples > sized,
      count(sized, "light has a size", "lights have a size") +
          (samples > sized ? ", " + std::to_string(samples) + " samples in all" : "; drawn as a point each")};
}

void add_light_effects(const Scene& scene, const Settings& settings, Effects& effects) {
  const std::vector<Light>& lights = known_lights(scene);
  const std::size_t lit = static_cast<std::size_t>(
      std::count_if(lights.begin(), lights.end(), [](const Light& light) { return !is_dark(light); }));
  const std::size_t receivers = count_roles(effects, Role::Receiver);
  const std::size_t refractors = count_roles(effects, Role::Refractor);
  const std::size_t mirrors = count_roles(effects, Role::Mirror);
  const std::string diffuse_surfaces = count(receivers, "diffuse surface", "diffuse surfaces");
  effects.light = {lit > 0, lit > 0 ? count(lit, "light", "lights") : "no light shines"};
  effects.highlights = {settings.highlights && !scene.meshes.empty(),
                        !settings.highlights   ? "not asked for"
                        : scene.meshes.empty() ? "there is no surface"
                                               : "surfaces mirror the lights, diffuse ones the environment"};
  add_area_lights(scene, effects);
  effects.receivers = {receivers > 0, receivers > 0 ? diffuse_surfaces : "no surface is diffuse"};
  const bool reached = std::any_of(effects.expectations.begin(), effects.expectations.end(),
                                   [](const Expectation& e) { return e.expected; });
  const auto first =
      std::find_if(effects.expectations.begin(), effects.expectations.end(), [&](const Expectation& e) {
        return is_caster(effects.surfaces[static_cast<std::size_t>(e.mesh)].role);
      });
  const auto caster = std::find_if(effects.surfaces.begin(), effects.surfaces.end(),
                                   [](const auto& s) { return is_caster(s.role); });
  if (reached) {
    effects.caustics = {true, caster->reason};
  } else if (refractors + mirrors == 0) {
    effects.caustics = {false, "no surface is smooth metal, or solid glass or water"};
  } else {
    effects.caustics = {false, first == effects.expectations.end()
                                   ? "no light shines"
                                   : light_name(scene, first->light) + ": " + first->reason};
  }
  const bool cells = reached && settings.splat == Splat::Cell;
  effects.cells = {cells, cells     ? "four neighbouring landings share their light by exact overlap"
                          : reached ? "landings are splatted one by one, as asked for"
                                    : "there is no caustic"};
  const auto solid = std::find_if(effects.surfaces.begin(), effects.surfaces.end(),
                                  [](const auto& s) { return s.two_interfaces; });
  const bool exits = solid != effects.surfaces.end();
  effects.exit_surface = {exits, exits ? solid->reason : "no refractor has a second surface"};
  const bool occluders = lit > 0 && anything_shadows(scene, effects);
  effects.occluders = {occluders, occluders ? "an opaque surface can stand in the light's way"
                                            : "no opaque surface can shadow another or a caster"};
  const std::size_t panes = count_roles(effects, Role::ThinPane);
  effects.thin_panes = {panes > 0, panes > 0 ? count(panes, "thin pane", "thin panes") +
                                                   " that tint what passes straight through"
                                             : "none in the scene"};
  effects.mirrors = {mirrors > 0, mirrors > 0 ? count(mirrors, "mirror", "mirrors") + ": smooth metal"
                                              : "none in the scene"};
}

// Surfaces of two triangles are taken to be flat.
void add_blended(const Scene& scene, Effects& effects) {
  std::size_t blended = 0, layered = 0, triangles = 0;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    if (!is_layered(effects.surfaces[i])) continue;
    blended += effects.surfaces[i].blended ? 1u : 0u;
    ++layered;
    triangles += scene.meshes[i].indices.size() / 3;
  }
  const std::string none = "none in the scene";
  const std::string found = count(blended, "surface", "surfaces") + " blended over what lies behind";
  const std::string over =
      count(layered, "surface", "surfaces") + " of which a share lies over what is behind";
  effects.blended = {blended > 0, blended > 0 ? found : none};
  effects.layered = {layered > 0, layered > blended ? over : effects.blended.reason};
  const bool several = layered > 1 || triangles > 2;
  effects.blended_layers = {several, several ? effects.layered.reason + ": where more than " +
                                                   std::to_string(kMostLayers) +
                                                   " lie behind one another, the nearest are shown"
                                     : layered > 0 ? "one flat surface is a layer"
                                                   : none};
  effects.tinted_light = {blended > 0 || effects.thin_panes.active,
                          effects.thin_panes.active ? effects.thin_panes.reason
                          : blended > 0             ? found
                                                    : "no thin pane, nothing blended"};
  const bool tints = effects.tinted_light.active && effects.caustics.active;
  effects.tinted_caustics = {tints,
                             effects.caustics.active ? effects.tinted_light.reason : "there is no caustic"};
}

std::string mesh_name(const Scene& scene, int mesh) {
  const auto index = static_cast<std::size_t>(mesh);
  return quoted_name("mesh", scene.meshes[index].name, index);
}

// "'lamp' lights the scene (4 samples)", "'lamp' (4 samples) and 3 more light the scene".
std::string lamps_text(const Scene& scene, const std::vector<const Light*>& lamps) {
  const auto samples = [&](const Light& lamp) {
    const auto drawn = static_cast<std::size_t>(std::count_if(
        scene.lights.begin(), scene.lights.end(),
        [&](const Light& light) { return lamp.source < 0 ? &light == &lamp : light.source == lamp.source; }));
    return " (" + count(drawn, "sample", "samples") + ")";
  };
  const std::string first = mesh_name(scene, lamps[0]->emitter) + samples(*lamps[0]);
  if (lamps.size() == 1) return first + " lights the scene";
  if (lamps.size() == 2)
    return first + " and " + mesh_name(scene, lamps[1]->emitter) + samples(*lamps[1]) + " light the scene";
  return first + " and " + std::to_string(lamps.size() - 1) + " more light the scene";
}

// "mesh 'led' and 3 more do not: it adds less than ..."
std::string dim_text(const Scene& scene, const std::string& one, const std::string& several) {
  const DimMesh& first = scene.dim_meshes.front();
  const std::size_t others = scene.dim_meshes.size() - 1;
  return mesh_name(scene, first.mesh) +
         (others == 0 ? " " + one : " and " + std::to_string(others) + " more " + several) + ": " +
         first.why + " (-D emissive.lights=on makes lights of all)";
}

void add_emitters(const Scene& scene, Effects& effects) {
  std::size_t shining = 0;
  for (const Mesh& mesh : scene.meshes) {
    const glm::vec3 e = scene.materials[static_cast<std::size_t>(mesh.material)].emissive;
    shining += std::max({e.x, e.y, e.z}) > 0.0f ? 1 : 0;
  }
  std::vector<const Light*> lamps;
  for (const Light& light : known_lights(scene))
    if (light.shape == LightShape::Mesh) lamps.push_back(&light);
  const std::string found = count(shining, "mesh that shines", "meshes that shine");
  effects.emission = {shining > 0, shining > 0 ? found : "nothing in the scene shines"};
  std::string why = found + ", but not on others, as asked for";
  if (!lamps.empty()) {
    why = lamps_text(scene, lamps);
    if (!scene.dim_meshes.empty()) why += "; " + dim_text(scene, "does not", "do not");
  } else if (!scene.dim_meshes.empty()) {
    why = dim_text(scene, "shines, but does not light the scene", "shine, but do not light the scene");
  }
  effects.emissive_lights = {!lamps.empty(), shining == 0 ? "none in the scene" : why};
}

void add_occlusion(const Scene& scene, Effects& effects) {
  std::size_t occluded = 0;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const Material& m = scene.materials[static_cast<std::size_t>(scene.meshes[i].material)];
    occluded +=
        has_diffuse(effects.surfaces[i]) && m.occlusion_texture.present() && m.occlusion_strength > 0.0f;
  }
  effects.occlusion = {occluded > 0, occluded > 0 ? count(occluded, "surface", "surfaces") +
                                                        " whose texture keeps the environment's light away"
                                                  : "no diffuse surface has an occlusion texture"};
}

// After reflecting_receivers, which the camera decides on.
void add_ambient_occlusion(const Scene& scene, const Settings& settings, Effects& effects) {
  const bool lit = upward_irradiance(scene.environment) > 0.0, near = scene.environment.reach > 0.0f;
  const bool alone = scene.meshes.size() < 2 && effects.receivers_are_one_plane;
  std::size_t triangles = 0;
  for (const Mesh& mesh : scene.meshes) triangles += mesh.indices.size() / 3;
  const bool too_many = triangles >= kMostTriangles;
  const bool active =
      settings.ambient_occlusion && lit && near && !alone && !too_many && effects.reflecting_receivers.active;
  effects.ambient_occlusion = {active, active ? "surfaces keep the environment's light from others near by"
                                       : !settings.ambient_occlusion ? "not asked for"
                                       : !effects.reflecting_receivers.active
                                           ? effects.reflecting_receivers.reason
                                       : !lit     ? "no light comes from all around"
                                       : too_many ? "there are too many triangles"
                                       : !near    ? "the scene says nothing about its extent"
                                                  : "there is one plane"};
}

// Receivers that are one plane hide nothing from any light.
void add_hidden_receivers(const Settings& settings, Effects& effects) {
  const bool window = std::any_of(effects.lights.begin(), effects.lights.end(),
                                  [](const LightEffects& light) { return light.all_around.empty(); });
  const bool plane = effects.receivers_are_one_plane;
  const bool active = effects.caustics.active && settings.hidden_receivers && !settings.draw_unconverged &&
                      !plane && window && settings.estimator != Estimator::Impostor;
  effects.hidden_receivers = {
      active, active                       ? "receivers can hide others from a light"
              : !effects.caustics.active   ? "there is no caustic"
              : plane                      ? "all receivers lie in one plane"
              : !settings.hidden_receivers ? "not asked for"
              : settings.draw_unconverged  ? "what has not converged is drawn where its search stopped"
              : settings.estimator == Estimator::Impostor ? "impostors see around the casters"
                                                          : "the lights see all around"};
}

void add_paper_weights(const Settings& settings, Effects& effects) {
  const bool asked = settings.weights == Weights::Paper;
  effects.paper_weights = {asked && effects.caustics.active, !asked ? "not asked for"
                                                             : effects.caustics.active
                                                                 ? "equation 6 was asked for"
                                                                 : "there is no caustic"};
}

void add_sub_pixels(const Settings& settings, Effects& effects) {
  effects.sub_pixels = {samples_a_pixel(settings) > 1,
                        settings.samples > 1   ? std::to_string(settings.samples) + " samples a pixel"
                        : settings.samples > 0 ? "one sample a pixel, as asked for"
                                               : "one sample a pixel, but 4 where render writes nothing but "
                                                 "pictures to look at"};
}

// Light through two surfaces is not spread: where it is not followed rough glass is as smooth for it.
void add_rough_glass(const Settings& settings, Effects& effects) {
  const auto rough = static_cast<std::size_t>(std::count_if(effects.surfaces.begin(), effects.surfaces.end(),
                                                            [](const SurfaceRole& s) { return s.rough; }));
  const bool followed = effects.further_surfaces.reason.empty() && settings.further_share < 1.0f;
  effects.rough_glass = {rough > 0, rough == 0
                                        ? "none in the scene"
                                        : count(rough, "surface", "surfaces") + " of rough glass" +
                                              (followed ? ": light is followed, and spread"
                                                        : ": the view is blurred, but light is not "
                                                          "followed, and goes as through smooth glass")};
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
    case Role::Blended:
      return "blended";
  }
  return "unknown";
}

bool throws_caustic(const Effects& effects, int light) {
  return std::any_of(effects.expectations.begin(), effects.expectations.end(),
                     [&](const Expectation& e) { return e.light == light && e.expected; });
}

bool has_effect(const Effects& effects, int light) {
  return throws_caustic(effects, light) ||
         effects.lights[static_cast<std::size_t>(light)].lights_nothing.empty();
}

std::span<const NamedEffect> named_effects() {
  static constexpr NamedEffect kNames[] = {
      {"light", &Effects::light},
      {"area lights", &Effects::area_lights},
      {"receivers", &Effects::receivers},
      {"reflecting receivers", &Effects::reflecting_receivers},
      {"emission", &Effects::emission},
      {"occlusion", &Effects::occlusion},
      {"ambient occlusion", &Effects::ambient_occlusion},
      {"caustics", &Effects::caustics},
      {"cells", &Effects::cells},
      {"exit surface", &Effects::exit_surface},
      {"occluders", &Effects::occluders},
      {"smooth shading", &Effects::smooth_shading},
      {"thin panes", &Effects::thin_panes},
      {"blended", &Effects::blended},
      {"layered", &Effects::layered},
      {"blended layers", &Effects::blended_layers},
      {"tinted light", &Effects::tinted_light},
      {"tinted caustics", &Effects::tinted_caustics},
      {"mirrors", &Effects::mirrors},
      {"highlights", &Effects::highlights},
      {"seen casters", &Effects::seen_casters},
      {"seen panes", &Effects::seen_panes},
      {"textured casters", &Effects::textured_casters},
      {"normal-mapped casters", &Effects::normal_mapped_casters},
      {"cut-out casters", &Effects::cut_out_casters},
      {"textured receivers", &Effects::textured_receivers},
      {"cut-out receivers", &Effects::cut_out_receivers},
      {"emissive lights", &Effects::emissive_lights},
      {"dispersion", &Effects::dispersion},
      {"reflections", &Effects::reflections},
      {"further surfaces", &Effects::further_surfaces},
      {"coloured caustics", &Effects::coloured_caustics},
      {"water waves", &Effects::water_waves},
      {"medium", &Effects::medium},
      {"scattering", &Effects::scattering},
      {"light shafts", &Effects::light_shafts},
      {"distance impostors", &Effects::distance_impostors},
      {"all around", &Effects::all_around},
      {"cascades", &Effects::cascades},
      {"hidden receivers", &Effects::hidden_receivers},
      {"sub-pixels", &Effects::sub_pixels},
      {"paper weights", &Effects::paper_weights},
      {"rough glass", &Effects::rough_glass},
      {"dim lights", &Effects::dim_lights},
  };
  return kNames;
}

Effects effects_of(const Scene& scene, const Settings& settings, const View* camera) {
  Effects effects;
  std::vector<Judgement> judgements;
  for (const Mesh& mesh : scene.meshes) {
    judgements.push_back(judge(mesh, scene.materials[static_cast<std::size_t>(mesh.material)], settings));
    effects.surfaces.push_back(judgements.back().role);
  }
  effects.expectations = expectations_of(scene, judgements);
  effects.lights.resize(scene.lights.size());
  add_light_effects(scene, settings, effects);
  add_smooth_shading(scene, effects);
  add_textured_casters(scene, settings, effects);
  add_blended(scene, effects);
  add_emitters(scene, effects);
  add_occlusion(scene, effects);
  add_branches(scene, settings, effects);
  add_caustic_color(scene, effects);
  add_water_waves(scene, effects);
  add_medium(scene, effects);
  add_all_around(scene, settings, effects);
  effects.cascades = {false, why_no_cascades(settings)};
  effects.receivers_are_one_plane = receivers_are_one_plane(scene, effects);
  add_hidden_receivers(settings, effects);
  add_sub_pixels(settings, effects);
  add_paper_weights(settings, effects);
  effects.dim_lights = {false, "there are few lights"};
  effects.further_surfaces = {false, why_not_followed(settings, effects)};
  add_rough_glass(settings, effects);
  add_camera(scene, camera, effects);
  add_ambient_occlusion(scene, settings, effects);
  return effects;
}

}  // namespace caustics
