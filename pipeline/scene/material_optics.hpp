// What a material's numbers mean for light: absorption, dispersion, a metal's reflectance.
#pragma once
#include <glm/glm.hpp>

#include "pipeline/scene/scene.hpp"

namespace caustics {

// Absorption per metre and channel of a volume: -ln(attenuation colour) / attenuation distance
// (KHR_materials_volume). A colour of 0 absorbs everything within a billionth of the distance.
glm::vec3 absorption_of(const Material& material);

// What glass lets through of each channel besides: its base colour. A thin wall's transmission counts by its
// mean, which a solid's does not: there it decides the role, and its texture tints texel by texel.
glm::vec3 passing_color(const Material& material, bool thin);

// Main dispersion n_F - n_C = (n_d - 1) / V with the Abbe number V = 20 / dispersion
// (KHR_materials_dispersion).
float main_dispersion(const Material& material);

// Reflectance of a metal at normal incidence: its base colour, and 0.04 of the dielectric share (glTF 2.0,
// appendix B.2).
glm::vec3 metal_reflectance(const Material& material);

}  // namespace caustics
