#include "pipeline/effects/branches.hpp"
#include "pipeline/effects/drawn_sizes.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/effects/spectrum.hpp"
#include "pipeline/effects/surface_role.hpp"
#include "pipeline/scene/material_optics.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

namespace {

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
  const auto add = [&](bool active, const std::string& reason) { effects.dispersion = {active, reason}; };
  if (!most) return add(false, "no refractor's index depends on the wavelength");
  const std::string what =
      quoted_name("material", most->name, static_cast<std::size_t>(most - scene.materials.data())) +
      " has dispersion " + rounded_text(most->dispersion);
  if (!effects.caustics.active) return add(false, what + ", but there is no caustic");
  if (settings.wavelengths == 1) return add(false, what + ", but one wavelength was asked for");
  add(true, what + ": " + std::to_string(settings.wavelengths) +
                (settings.wavelengths == 3 ? " wavelengths, the C, d and F lines" : " wavelengths"));
}

void add_reflections(const Settings& settings, Effects& effects) {
  const auto add = [&](bool active, const std::string& reason) { effects.reflections = {active, reason}; };
  if (std::none_of(effects.surfaces.begin(), effects.surfaces.end(),
                   [](const SurfaceRole& s) { return s.role == Role::Refractor; }))
    return add(false, "no refractor in the scene");
  if (!settings.reflections) return add(false, "what refractors mirror is left out; -D reflections=yes");
  if (settings.weights == Weights::Paper) return add(false, "the paper's weights know no Fresnel share");
  if (!effects.caustics.active) return add(false, "there is no caustic");
  add(true, "what refractors mirror throws a caustic, as asked for");
}

std::vector<Branch> branches_of(const Settings& settings, const Effects& effects) {
  std::vector<Branch> branches;
  if (effects.dispersion.active) {
    for (const Wavelength& w :
         settings.wavelengths == 3 ? fraunhofer_lines() : spectrum(settings.wavelengths))
      branches.push_back(
          {.name = rounded_text(w.nanometres, 4) + "nm", .bend = bend_of(w.nanometres), .color = w.color});
  } else {
    branches.push_back({});
  }
  if (effects.reflections.active) branches.push_back({.name = "reflected", .reflected = true});
  return branches;
}

}  // namespace

bool all_light_is_spread(const Effects& effects) {
  if (all_sizes_are_drawn(effects)) return true;
  return effects.rough_glass.active && effects.further_surfaces.active &&
         std::all_of(effects.surfaces.begin(), effects.surfaces.end(),
                     [](const SurfaceRole& s) { return !is_caster(s.role) || s.rough; });
}

void add_branches(const Scene& scene, const Settings& settings, Effects& effects) {
  add_dispersion(scene, settings, effects);
  add_reflections(settings, effects);
  effects.branches = branches_of(settings, effects);
}

}  // namespace caustics
