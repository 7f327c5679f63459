// What each mesh does to a ray of light, and what its textures change where the ray meets it. In double
// precision, and shared with no pass.
#pragma once
#include <vector>

#include "pipeline/effects/effects.hpp"

namespace caustics::tracer {

// The numbers are those that the passes work with (pipeline/effects/ray_tables.hpp).
struct Optics {
  Role role = Role::Receiver;
  bool solid = false;          // light leaves through a second surface
  double ior;                  // at the d line
  double spread = 0.0;         // n_F - n_C
  double fresnel = 1.0;        // of what Fresnel's equations mirror
  double alpha = 0.0;          // of rough glass: GGX's width, its roughness squared
  glm::dvec3 absorption{0.0};  // per metre
  glm::dvec3 color{1.0};       // of what passes; of a mirror its reflectance straight on
  int body = 0;                // primitives of one object and material are one body
  bool thin = false;           // a pane, or a wall of rough glass: it mirrors by its index, but bends nothing
  double there = 1.0;          // of a pane: the share of it that covers what is behind
  double index(double bend) const { return thin ? 1.0 : ior + spread * bend; }
};

// By Scene::meshes.
std::vector<Optics> optics_of(const Scene& scene, const Effects& effects);

// Does the material have textures that change what light does at a caster?
bool is_dressed(const Material& material);

// Is the surface cut out there by its alpha mask (glTF 2.0, 3.9.4), or of alphaMode BLEND not opaque? By the
// nearest texel, as `render` has it.
bool is_cut_out(const Scene& scene, const Material& material, const glm::dvec2& uv);
// The share that a material of alphaMode BLEND covers there.
double opacity_at(const Scene& scene, const Material& material, const glm::dvec2& uv);

// The unit normal as the normal texture leans it around the unit normal n (glTF 2.0, 3.9.3), kept on n's
// side.
glm::dvec3 leaned(const Scene& scene, const Material& material, const glm::dvec3& n,
                  const glm::dvec4& tangent, const glm::dvec2& uv);

// `plain`: what the material does where its textures are white.
Optics dressed(const Scene& scene, const Material& material, const Optics& plain, const glm::dvec2& uv);

}  // namespace caustics::tracer
