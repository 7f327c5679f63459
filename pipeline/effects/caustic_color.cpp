#include "pipeline/effects/caustic_color.hpp"

#include <cmath>

#include "pipeline/effects/surface_role.hpp"

namespace caustics {

namespace {

bool is_grey(const glm::vec3& v) { return v.x == v.y && v.y == v.z; }

// What of a caster's material tints its caustic; empty: nothing.
std::string tint_of(const Material& material, Role role) {
  if (!is_grey(glm::vec3(material.base_color))) return "has a coloured base";
  const bool absorbs = role == Role::Refractor && std::isfinite(material.attenuation_distance);
  if (absorbs && !is_grey(material.attenuation_color)) return "absorbs its colours unequally";
  return {};
}

}  // namespace

void add_caustic_color(const Scene& scene, Effects& effects) {
  const auto add = [&](bool active, const std::string& reason) {
    effects.coloured_caustics = {active, reason};
  };
  if (!effects.caustics.active) return add(false, "there is no caustic");
  if (effects.dispersion.active) return add(true, "wavelengths land in different places");
  if (!is_grey(scene.medium.extinction())) return add(true, "the medium takes its colours unequally");
  if (effects.textured_casters.active) return add(true, "a texture tints them");
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    if (!is_on_the_way(effects.surfaces[i])) continue;
    const auto index = static_cast<std::size_t>(scene.meshes[i].material);
    const std::string tint = tint_of(scene.materials[index], effects.surfaces[i].role);
    if (!tint.empty())
      return add(true, quoted_name("material", scene.materials[index].name, index) + " " + tint);
  }
  add(false, "nothing tints them: one channel is enough");
}

}  // namespace caustics
