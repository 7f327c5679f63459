// What each mesh does to a ray of light, for whoever follows rays through a scene's triangles.
#pragma once
#include <string>
#include <vector>

#include "pipeline/effects/effects.hpp"

namespace caustics {

// The numbers are those that the passes work with (pipeline/renderer/scene_on_device.hpp).
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
  bool thin = false;           // of rough glass: a wall that mirrors by its index, but bends nothing
  double index(double bend) const { return thin ? 1.0 : ior + spread * bend; }
};

// By Scene::meshes.
std::vector<Optics> optics_of(const Scene& scene, const Effects& effects);

// What in the scene following rays does not show: textures that lean normals, tint or cut holes, waves, haze.
// "textured casters (...)", with the reason; empty where it shows everything.
std::string not_in_triangles(const Scene& scene, const Effects& effects);

}  // namespace caustics
