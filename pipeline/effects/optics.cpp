#include "pipeline/effects/optics.hpp"

#include <map>
#include <utility>

#include "pipeline/scene/material_optics.hpp"

namespace caustics {

namespace {

constexpr NamedEffect kNotInTriangles[] = {{"medium", &Effects::medium},
                                           {"water waves", &Effects::water_waves}};

Optics optics_of_surface(const Material& material, const SurfaceRole& surface) {
  Optics o{.role = surface.role, .solid = surface.two_interfaces, .ior = static_cast<double>(material.ior)};
  if (surface.role == Role::Mirror) {
    o.color = glm::dvec3(metal_reflectance(material));
    return o;
  }
  o.spread = static_cast<double>(main_dispersion(material));
  o.color = glm::dvec3(glm::vec3(material.base_color) * transmitted_share(material));
  if (surface.role == Role::Refractor && surface.rough)
    o.alpha = static_cast<double>(material.roughness) * static_cast<double>(material.roughness);
  o.fresnel = static_cast<double>(material.fresnel_factor);
  o.thin = surface.thin;
  if (surface.role == Role::Refractor && !surface.thin) o.absorption = glm::dvec3(absorption_of(material));
  return o;
}

}  // namespace

std::vector<Optics> optics_of(const Scene& scene, const Effects& effects) {
  std::vector<Optics> all;
  std::map<std::pair<int, int>, int> bodies;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const Mesh& mesh = scene.meshes[i];
    Optics o =
        optics_of_surface(scene.materials[static_cast<std::size_t>(mesh.material)], effects.surfaces[i]);
    o.body = bodies.try_emplace({mesh.object, mesh.material}, static_cast<int>(bodies.size())).first->second;
    all.push_back(o);
  }
  return all;
}

std::string not_in_triangles(const Scene& scene, const Effects& effects) {
  for (const NamedEffect& named : kNotInTriangles) {
    const Effect& effect = effects.*named.effect;
    if (effect.active) return std::string(named.name) + " (" + effect.reason + ")";
  }
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const Material& m = scene.materials[static_cast<std::size_t>(scene.meshes[i].material)];
    const Role role = effects.surfaces[i].role;
    if (role == Role::Receiver && m.alpha_mode == AlphaMode::Mask && m.base_color_texture.present())
      return "alpha masks (material '" + m.name + "' has one)";
    if (effects.surfaces[i].blended && m.base_color_texture.present())
      return "textured coverage (material '" + m.name + "' has it)";
    if (role == Role::ThinPane && (m.base_color_texture.present() || m.transmission_texture.present()))
      return "textured panes (material '" + m.name + "' is one)";
  }
  return {};
}

}  // namespace caustics
