#include "pipeline/scene/material_optics.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/scene/exact.hpp"

namespace caustics {

glm::vec3 absorption_of(const Material& material) {
  glm::vec3 absorption{0.0f};
  const double distance = static_cast<double>(material.attenuation_distance);
  if (!std::isfinite(distance)) return absorption;
  for (int i = 0; i < 3; ++i) {
    const double color = static_cast<double>(material.attenuation_color[i]);
    const double per_distance = color > 0.0 ? -exact::log(color) : 1e9;
    absorption[i] = static_cast<float>(std::min(per_distance / std::max(distance, 1e-12), 1e30));
  }
  return absorption;
}

float transmitted_share(const Material& material) {
  return material.transmission * (1.0f - material.metallic);
}

float transmission_factor(const Material& material) {
  const bool textured = material.transmission_texture.present();
  return (textured ? material.transmission_factor : material.transmission) * (1.0f - material.metallic);
}

float main_dispersion(const Material& material) {
  return (material.ior - 1.0f) * material.dispersion / 20.0f;
}

glm::vec3 dielectric_reflectance(const Material& material) {
  const float r = (material.ior - 1.0f) / (material.ior + 1.0f);
  return glm::min(material.specular_color * (r * r), glm::vec3(1.0f)) * material.fresnel_factor;
}

float opaque_from(const Material& material) {
  return material.alpha_mode == AlphaMode::Mask    ? material.alpha_cutoff
         : material.alpha_mode == AlphaMode::Blend ? kCoversAll
                                                   : 0.0f;
}

float grey_reflectance(const Material& material) { return 0.04f * (1.0f - material.metallic); }

glm::vec3 metal_reflectance(const Material& material) {
  return glm::vec3(grey_reflectance(material)) + glm::vec3(material.base_color) * material.metallic;
}

}  // namespace caustics
