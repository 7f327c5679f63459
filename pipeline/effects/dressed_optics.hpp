// What its material's textures change where a ray meets a caster, for whoever follows rays on the CPU. In
// double precision.
#pragma once
#include "pipeline/effects/optics.hpp"
#include "pipeline/scene/scene.hpp"

namespace caustics {

// Does the material have textures that change what light does at a caster?
bool is_dressed(const Material& material);

// Is the surface cut out there by its alpha mask (glTF 2.0, 3.9.4)? By the nearest texel, as `render` has it.
bool is_cut_out(const Scene& scene, const Material& material, const glm::dvec2& uv);

// The unit normal as the normal texture leans it around the unit normal n (glTF 2.0, 3.9.3), kept on n's
// side.
glm::dvec3 leaned(const Scene& scene, const Material& material, const glm::dvec3& n,
                  const glm::dvec4& tangent, const glm::dvec2& uv);

// `plain`: what the material does where its textures are white.
Optics dressed(const Scene& scene, const Material& material, const Optics& plain, const glm::dvec2& uv);

}  // namespace caustics
