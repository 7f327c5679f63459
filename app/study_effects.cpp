#include "app/study_effects.hpp"

#include <algorithm>

#include "app/frame.hpp"
#include "app/loaded_scene.hpp"
#include "passes/registry.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/scene/material_optics.hpp"

namespace caustics::app {

namespace {

bool any_caster(const Scene& scene, const Effects& effects,
                bool (*has)(const Material&, const SurfaceRole&)) {
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const SurfaceRole& surface = effects.surfaces[i];
    const auto material = static_cast<std::size_t>(scene.meshes[i].material);
    if (is_caster(surface.role) && has(scene.materials[material], surface)) return true;
  }
  return false;
}

void change_casters(Scene& scene, const Effects& effects, void (*change)(Material&)) {
  for (std::size_t i = 0; i < scene.meshes.size(); ++i)
    if (is_caster(effects.surfaces[i].role))
      change(scene.materials[static_cast<std::size_t>(scene.meshes[i].material)]);
}

bool mirrors_in_part(const Material& material, const SurfaceRole& surface) {
  return surface.role == Role::Refractor && material.ior != 1.0f;
}

bool absorbs(const Material& material, const SurfaceRole& surface) {
  return surface.role == Role::Refractor && absorption_of(material) != glm::vec3(0.0f);
}

template <Effect Effects::*effect>
bool called_for(const Scene&, const Effects& effects, const Settings&) {
  return (effects.*effect).active;
}

const Omission kOmissions[] = {
    {.name = "fresnel",
     .called_for = [](const Scene& s, const Effects& e,
                      const Settings&) { return any_caster(s, e, mirrors_in_part); },
     .scene = [](Scene& s,
                 const Effects& e) { change_casters(s, e, [](Material& m) { m.fresnel_factor = 0.0f; }); }},
    {.name = "absorption",
     .called_for = [](const Scene& s, const Effects& e,
                      const Settings&) { return any_caster(s, e, absorbs); },
     .scene =
         [](Scene& s, const Effects& e) {
           change_casters(s, e, [](Material& m) { m.attenuation_color = glm::vec3(1.0f); });
         }},
    {.name = "second surface",
     .called_for = called_for<&Effects::exit_surface>,
     .settings = [](Settings& s) { s.interfaces = Interfaces::One; }},
    {.name = "shadows", .called_for = called_for<&Effects::occluders>, .effect = &Effects::occluders},
    {.name = "hidden receivers",
     .called_for = called_for<&Effects::hidden_receivers>,
     .settings = [](Settings& s) { s.hidden_receivers = false; }},
    {.name = "cells",
     .called_for = called_for<&Effects::cells>,
     .settings = [](Settings& s) { s.splat = Splat::Gaussian; }},
    {.name = "cascades",
     .called_for = called_for<&Effects::cascades>,
     .settings = [](Settings& s) { s.cascades = false; }},
    {.name = "pixel means",
     .called_for = [](const Scene&, const Effects&, const Settings& s) { return s.pixel_means; },
     .settings = [](Settings& s) { s.pixel_means = false; }},
    {.name = "dispersion",
     .called_for = called_for<&Effects::dispersion>,
     .settings = [](Settings& s) { s.wavelengths = 1; }},
    {.name = "reflections",
     .called_for = called_for<&Effects::reflections>,
     .settings = [](Settings& s) { s.reflections = false; }},
    {.name = "size of lights",
     .called_for = called_for<&Effects::area_lights>,
     .settings = [](Settings& s) { s.light_samples = 1; }},
    {.name = "cubes",
     .called_for = called_for<&Effects::all_around>,
     .settings = [](Settings& s) { s.cube = Cube::Off; }},
    {.name = "normal maps",
     .called_for = called_for<&Effects::normal_mapped_casters>,
     .scene = [](Scene& s,
                 const Effects& e) { change_casters(s, e, [](Material& m) { m.normal_texture = {}; }); }},
    {.name = "medium",
     .called_for = called_for<&Effects::medium>,
     .scene = [](Scene& s, const Effects&) { s.medium = {}; }},
};

}  // namespace

std::vector<std::string> omissions_for(const FrameRequest& request) {
  const std::unique_ptr<LoadedScene> loaded = load_scene(request);
  const std::unique_ptr<Device> pilot = make_pilot_device(request.backend);
  const Effects effects = plan_frame(loaded->scene(), request.settings, pass_registry(), *pilot,
                                     {{"aov_caustic"}}, &loaded->camera())
                              .effects;
  if (!effects.caustics.active)
    throw Error(ExitCode::WrongUsage, "--effects: there is no caustic; 'caustics plan' says why");
  std::vector<std::string> names;
  for (const Omission& each : kOmissions)
    if (each.called_for(loaded->scene(), effects, request.settings)) names.emplace_back(each.name);
  return names;
}

const Omission& omission(const std::string& name) {
  for (const Omission& each : kOmissions)
    if (each.name == name) return each;
  throw Error(ExitCode::InternalError, "no effect '" + name + "' can be left out");
}

}  // namespace caustics::app
