// What a material's numbers mean for light: absorption, dispersion, a metal's reflectance.
#pragma once
#include <glm/glm.hpp>

#include "pipeline/scene/scene.hpp"

namespace caustics {

// Absorption per metre and channel of a volume: -ln(attenuation colour) / attenuation distance
// (KHR_materials_volume). A colour of 0 absorbs everything within a billionth of the distance.
glm::vec3 absorption_of(const Material& material);

// From which opacity on a surface that is no glass and no mirror is opaque; below it there is a hole, or of a
// blended one a layer, which light that casters throw passes. 0: all of it is opaque.
float opaque_from(const Material& material);

// Of the light that is not mirrored, the share that goes through the material instead of being scattered by
// it or meeting metal: KHR_materials_transmission, by the mean of its texture.
float transmitted_share(const Material& material);
// The same without its texture, by which it may be multiplied texel by texel.
float transmission_factor(const Material& material);

// Main dispersion n_F - n_C = (n_d - 1) / V with the Abbe number V = 20 / dispersion
// (KHR_materials_dispersion).
float main_dispersion(const Material& material);

// Of a dielectric at normal incidence: ((n - 1) / (n + 1))^2, times KHR_materials_specular's colour and
// factor.
glm::vec3 dielectric_reflectance(const Material& material);

// Reflectance of a metal at normal incidence: its base colour, and 0.04 of the dielectric share (glTF 2.0,
// appendix B.2).
glm::vec3 metal_reflectance(const Material& material);
// The dielectric share of that, which base colour does not tint.
float grey_reflectance(const Material& material);

}  // namespace caustics
