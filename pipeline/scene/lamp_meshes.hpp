// Which of the meshes that shine light the scene, where nobody says so (Settings::emissive_lights).
#pragma once
#include <vector>

#include "pipeline/scene/scene.hpp"

namespace caustics {

// What shines, judged.
struct Lamps {
  std::vector<Light> lights;  // LightShape::Mesh, with the number of their samples
  std::vector<DimMesh> dim;   // the other meshes that shine, and why they are no lights
  // A scene without a light needs no sun: these light it.
  bool instead_of_sun = false;
};

// Judges every mesh that shines (emitter.hpp) by what it adds to the other light at some hundred places on
// the surfaces around, past what is opaque. It is a lamp if that is a tenth or more on a twentieth of them.
// The other light is that of Scene::lights and of the environment; where there are none, that of the meshes
// themselves, if on a quarter of the surfaces they give at least a two-hundredth of `sun_lux`, or of what
// they would if they filled all the sky; else that of a sun of `sun_lux` that will be added. At most 16 are
// lamps, the strongest ones.
//
// The lamps share `samples` by their flux, at least one each. Where there is glass or metal, a quarter does
// if none looks wide, since steps of a narrow shadow's edge do not show; half of them, if one is among the
// casters, of which each sample throws a caustic. What shines to opposite sides has twice as many, since half
// of them turn away from any surface.
Lamps choose_lamps(const Scene& scene, double sun_lux, int samples);

}  // namespace caustics
