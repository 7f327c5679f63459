// What a scene calls for: which surfaces bend light, which catch it, and which effects follow.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/scene/scene.hpp"
#include "pipeline/scene/view.hpp"

namespace caustics {

struct Settings;

// Blended surfaces that are shown in one place, at most.
inline constexpr int kMostLayers = 4;

// What a mesh does to light.
enum class Role : std::uint8_t {
  Receiver,   // diffuse: catches light and caustics, casts a shadow
  Refractor,  // glass or water with a volume, or a rough wall: throws a caustic
  ThinPane,   // smooth, transmission without a volume: lets light straight through, tinted
  Mirror,     // smooth metal: throws a caustic
  Blended,    // alphaMode BLEND: diffuse where it covers, nothing beside
};
std::string_view name_of(Role role);
// Does it throw caustics: a Refractor or a Mirror?
constexpr bool is_caster(Role role) { return role == Role::Refractor || role == Role::Mirror; }
// Is it shaded by what light falls on it?
constexpr bool is_diffuse(Role role) { return role == Role::Receiver || role == Role::Blended; }

struct SurfaceRole {
  Role role = Role::Receiver;
  bool two_interfaces = false;  // a Refractor: closed, so the light leaves through a second surface
  std::string reason{};
  // Some of it is blended over what lies behind: all but what is opaque of a Receiver, all of a Blended.
  bool blended = false;
  bool rough = false;  // a Refractor: its microfacets spread the light
  bool thin = false;   // a rough Refractor without a volume: a wall that spreads light, but bends none
  // A Refractor or ThinPane that lets a share through: the rest is a diffuse surface in the same place.
  bool partly_diffuse = false;
};

// Is any of it shaded by what light falls on it?
inline bool has_diffuse(const SurfaceRole& surface) {
  return is_diffuse(surface.role) || surface.partly_diffuse;
}
// Is some of it a layer over what lies behind, of which it covers a share?
inline bool is_layered(const SurfaceRole& surface) { return surface.blended || surface.partly_diffuse; }

// Do rays pass it straight: a pane, or a wall of rough glass?
inline bool is_wall(const SurfaceRole& surface) { return surface.role == Role::ThinPane || surface.thin; }
// Does light, or sight, that a caster has sent on go on behind it?
inline bool is_on_the_way(const SurfaceRole& surface) {
  return is_caster(surface.role) || surface.role == Role::ThinPane;
}

// Does it take a share of the light that passes straight through?
inline bool tints_light(const SurfaceRole& surface) {
  return surface.role == Role::ThinPane || surface.blended;
}

// One effect: does the frame call for it, and why or why not.
struct Effect {
  bool active = false;
  std::string reason;
};

// Whether a light throws a caustic through a caster, before anything is rendered.
struct Expectation {
  int light = 0;
  int mesh = 0;
  bool expected = false;
  std::string reason{};
};

// One way that a light's flux takes through the casters. Each has its own landings; the caustic map of
// the light adds them up.
struct Branch {
  std::string name;        // "" where there is one branch only; "656nm", "reflected"
  bool reflected = false;  // what dielectrics mirror at their first surface, instead of what they let in
  // Of light that is followed from surface to surface: where it is mirrored, instead of let through; 0:
  // nowhere. Behind that surface it takes the stronger way at each.
  int mirrored_at = 0;
  // What the others leave behind: of each vertex' light one way is drawn, which parts from theirs.
  bool drawn = false;
  // All of its light is spread by microfacets, which its vertices draw.
  bool spread = false;
  // Do the others part from it? It counts what they have in common.
  bool leads() const { return mirrored_at == 0 && !drawn; }
  // Does the branch that leads go the same way from the first surface? Of what is drawn most does.
  bool has_same_start() const { return mirrored_at >= 2 || drawn; }
  // Index of refraction: n_d + bend * (n_F - n_C). 0 at the d line.
  double bend = 0.0;
  glm::vec3 color{
      1.0f};  // its share of each channel; over the branches that are not reflected, all add up to 1
};

// Which sides of a triangle's mesh: those whose outward normal faces a light, or faces away from it.
enum class OutwardSides : std::uint8_t { Both, Towards, Away };

// Which map has what lands on sides that the light itself cannot shine on: that of the nearest receivers, or,
// where these are lit from before as well, of the farthest.
enum class LitFromBehind : std::uint8_t { No, InNearest, InFarthest };

// Where the light of casters lands, as a pilot has found.
struct LitReceivers {
  // Receivers that only the map of the farthest can have, by Scene::meshes, and which sides of them. Empty
  // where no light is known to land on such: the map then has all.
  std::vector<bool> hidden{};
  OutwardSides hidden_sides = OutwardSides::Both;
  LitFromBehind behind = LitFromBehind::No;
};

// What is judged light by light. A reason is empty where the answer is no.
struct LightEffects {
  std::string lights_nothing;  // why its direct light falls on no receiver that the camera sees
  std::string all_around;      // why the light is drawn onto a cube
  // Which way its caustic map looks, where its casters send its light behind it, or far aside; 0: towards
  // them.
  glm::dvec3 looks{0.0};
  LitReceivers lit{};
  std::string cascade;         // why its caustic has a finer second map; known once a pilot has run
  int divide = 1;              // the sides of its grid and maps, of a light that adds little (dim_lights.hpp)
  glm::vec3 of_others{0.0f};   // lux or candela by which its caustic is brighter, as it stands for others'
  bool size_is_drawn = false;  // its caustic is that of its whole source, of which it is one sample
  int shadow_divide = 1;  // the sides of its shadow map, of a sample whose shadows' edges the others' soften
  bool casters_shadow = false;  // it throws no caustic that would tell their shadow: its shadow map has them
};

// Of the light that lands through a caster: what share does not come through one surface or two, or off the
// first. What would land so if no other caster stood in its way counts as well.
struct FurtherShare {
  int light = 0;
  int mesh = 0;
  double share = 0.0;     // 0..1
  double of_light = 0.0;  // how much of the light's landed flux comes through this caster, 0..1
  double seen = 0.0;      // `share` of what the picture shows of the light, through all casters
  glm::dvec3 looks{0.0};  // LightEffects::looks
  LitReceivers lit{};     // LightEffects::lit
};

// What a light adds to the light on the casters (pipeline/measure/light_shares.hpp).
struct LightShare {
  double share = 1.0;         // 0..1; with those that it stands for
  double on_casters = 0.0;    // irradiance times area, lm or as much by any factor
  bool left_out = false;      // one of the weakest, which throw no caustics
  int drawn_with = -1;        // source whose caustic stands for its own, -1: none does
  glm::vec3 of_others{0.0f};  // LightEffects::of_others
};

// Every effect is a member; named_effects() has their names for people. None depends on the order of the
// others' rows.
struct Effects {
  std::vector<SurfaceRole> surfaces;  // by Scene::meshes
  std::vector<Expectation> expectations;
  std::vector<FurtherShare> further_shares;  // as a pilot has found
  std::vector<Branch> branches{Branch{}};    // at least one
  std::vector<LightEffects> lights;          // by Scene::lights
  bool receivers_are_one_plane = false;      // or there is none
  View impostors;  // where distance_impostors is active: the cube around the casters, without an atlas yet

  Effect light;                  // any light
  Effect area_lights;            // a light with a size, drawn by more than one sample
  Effect receivers;              // any diffuse surface
  Effect reflecting_receivers;   // one that is not black
  Effect emission;               // a surface that shines
  Effect occlusion;              // a diffuse surface whose texture keeps the environment's light away
  Effect ambient_occlusion;      // what surfaces keep from others near by of the environment's light
  Effect caustics;               // a refractor or mirror that a light can reach
  Effect cells;                  // caustics whose landings are joined to cells (Splat::Cell)
  Effect exit_surface;           // a refractor with two interfaces
  Effect occluders;              // diffuse surfaces that can shadow others or a caster
  Effect smooth_shading;         // of a diffuse surface: normals that vary over its triangles
  Effect thin_panes;             // a transmissive surface without a volume
  Effect seen_panes;             // and the camera sees such
  Effect blended;                // a surface that alphaMode BLEND shows over what lies behind
  Effect layered;                // one of those, or glass of which a share is diffuse
  Effect blended_layers;         // several of these in one place
  Effect tinted_light;           // light passes straight through panes or blended surfaces,
  Effect tinted_caustics;        // maybe on its way to casters
  Effect mirrors;                // smooth metal, which reflects light and view
  Effect highlights;             // what smooth surfaces mirror of the lights
  Effect seen_casters;           // a refractor or mirror, in which the camera sees other things
  Effect textured_casters;       // a caster whose colour or transmission varies by a texture
  Effect normal_mapped_casters;  // a caster with a normal texture
  Effect cut_out_casters;        // a caster with holes by an alpha mask
  Effect textured_receivers;     // whose colour glass may show beside the picture
  Effect cut_out_receivers;      // in which an alpha mask has cut holes, for followed light
  Effect emissive_lights;        // a mesh that shines and lights the scene
  Effect dispersion;             // a refractor whose index depends on the wavelength
  Effect reflections;            // what refractors mirror, on request
  Effect further_surfaces;       // light is followed from surface to surface, as a pilot has found
  Effect coloured_caustics;   // a caster that tints them: the caustic map has three channels instead of one
  Effect water_waves;         // a mesh that `extras` make water
  Effect medium;              // haze in the air, which takes light on its way
  Effect scattering;          // and scatters it towards the camera
  Effect light_shafts;        // caustics in a medium that scatters
  Effect distance_impostors;  // asked for by the estimator (Estimator::Impostor)
  Effect all_around;          // a light that stands among its casters, or is asked to see all around
  Effect cascades;            // a light whose caustic is small in its map, as a pilot has found
  Effect hidden_receivers;  // caustics on receivers that are not one plane, so that one can hide another from
                            // a light
  Effect sub_pixels;        // several samples a pixel (Settings::samples)
  Effect paper_weights;     // every grid vertex has an equal part of the light (Weights::Paper)
  Effect rough_glass;       // a refractor whose microfacets spread the light
  Effect dim_lights;        // of many lights, some that add little and are drawn coarsely or not at all
};

// Every effect with its name for people, in the order in which they are shown.
struct NamedEffect {
  std::string_view name;
  Effect Effects::*effect;
};
std::span<const NamedEffect> named_effects();

// The intensity that a light's caustic has, which may stand for those of others: lux (directional) or
// candela, by channel.
inline glm::vec3 caustic_intensity(const Light& light, const LightEffects& of_light) {
  return light.color * light.intensity + of_light.of_others;
}

// Does the light throw a caustic, through any caster?
bool throws_caustic(const Effects& effects, int light);
// Is light followed from surface to surface, or is that not decided yet?
inline bool may_be_followed(const Effects& effects) {
  return effects.further_surfaces.active || effects.further_surfaces.reason.empty();
}
// Does anything that the camera sees depend on the light?
bool has_effect(const Effects& effects, int light);

// Everything but what a pilot finds (with_findings): cascades are inactive. `camera`: the picture's view;
// null: everything counts as seen.
Effects effects_of(const Scene& scene, const Settings& settings, const View* camera = nullptr);

}  // namespace caustics
