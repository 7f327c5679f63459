// What a scene calls for: which surfaces bend light, which catch it, and which effects follow.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/scene/frame.hpp"
#include "pipeline/scene/scene.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

// What a mesh does to light.
enum class Role : std::uint8_t {
  Receiver,   // diffuse: catches light and caustics, casts a shadow
  Refractor,  // smooth glass or water with a volume: throws a caustic
  ThinPane,   // transmission without a volume: lets light straight through, tinted
  Mirror,     // smooth metal: throws a caustic
};
std::string_view name_of(Role role);
// Does it throw caustics: a Refractor or a Mirror?
constexpr bool is_caster(Role role) { return role == Role::Refractor || role == Role::Mirror; }

struct SurfaceRole {
  Role role = Role::Receiver;
  bool two_interfaces = false;  // a Refractor: closed, so the light leaves through a second surface
  std::string reason;
};

// One effect, called for or not, and why.
struct Effect {
  std::string name;
  bool active = false;
  std::string reason;
};

// Whether a light throws a caustic through a caster, before anything is rendered.
struct Expectation {
  int light = 0;
  int mesh = 0;
  bool expected = false;
  std::string reason;
};

// One way that a light's flux takes through the casters. Each has its own landings; the caustic map of
// the light adds them up.
struct Branch {
  std::string name;        // "" where there is one branch only; "656nm", "reflected"
  bool reflected = false;  // what dielectrics mirror at their first surface, instead of what they let in
  // Index of refraction: n_d + bend * (n_F - n_C). 0 at the d line.
  double bend = 0.0;
  glm::vec3 color{1.0f};   // its share of each channel; over the branches that are not reflected, all add up to 1
};

struct Effects {
  std::vector<SurfaceRole> surfaces;  // by Scene::meshes
  std::vector<Effect> list;
  std::vector<Expectation> expectations;
  std::vector<Branch> branches{Branch{}};  // at least one
  // By Scene::lights: why the light is drawn onto a cube (effect "all around"); empty where it is not.
  std::vector<std::string> all_around;
  // By Scene::lights, once their frames are known: why a light has a cascade, empty where it has none.
  std::vector<std::string> cascades;
  Frame impostors;  // where "distance impostors" is active: the cube around the casters, without an atlas yet
  // The effect of this name, which must be in the list.
  const Effect& find(std::string_view name) const;
  bool active(std::string_view name) const { return find(name).active; }
};

// Effects by name:
//   "light"           any light
//   "area lights"     a light with a size, drawn by more than one sample
//   "receivers"       any diffuse surface
//   "caustics"        a refractor or mirror that a light can reach
//   "cells"           caustics whose landings are joined to cells (Splat::Cell)
//   "exit surface"    a refractor with two interfaces
//   "occluders"       diffuse surfaces that can shadow others or a caster
//   "mirrors"         smooth metal, which reflects light and view
//   "seen casters"    a refractor or mirror, in which the camera sees other things
//   "textured casters"       a caster whose colour or transmission varies by a texture
//   "normal-mapped casters"  a caster with a normal texture
//   "cut-out casters"        a caster with holes by an alpha mask
//   "thin panes"      a transmissive surface without a volume
//   "emissive lights" a mesh that shines and lights the scene
//   "dispersion"      a refractor whose index depends on the wavelength
//   "reflections"     what refractors mirror, on request
//   "coloured caustics"  a caster that tints them: the caustic map has three channels instead of one
//   "water waves"     a mesh that `extras` make water
//   "medium"          haze in the air, which takes light on its way
//   "scattering"      and scatters it towards the camera
//   "light shafts"    caustics in a medium that scatters
//   "distance impostors" asked for by the estimator (Estimator::Impostor)
//   "all around"      a light that stands among its casters, or is asked to see all around
//   "cascades"        a light whose caustic is small in its map, once the lights' frames are known
//   "hidden receivers" caustics on receivers that are not one plane, so that one can hide another from a light
//   "rough glass"     found and left to later; inactive, with the reason
Effects effects_of(const Scene& scene, const Settings& settings);

}  // namespace caustics
