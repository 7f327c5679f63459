// The parts that a scene is completed with where its file leaves them out (pipeline/renderer/stage.hpp).
#pragma once
#include "pipeline/scene/scene.hpp"

namespace caustics {

// A mesh that shows a caustic rather than throwing one: neither transmissive nor a mirror.
bool is_mirror(const Material& material);    // metallic >= 0.5 and roughness <= 0.2
bool is_receiver(const Material& material);  // not transmissive, not a mirror

// Those that light neither goes through nor is mirrored by: indices into Scene::meshes.
std::vector<int> opaque_receivers(const Scene& scene);

// Where the light matters: the bounds of the meshes that are no receivers, else of all but an added ground.
Bounds subject_of(const Scene& scene);
// The largest extent along an axis, metres; 1 where there is none.
double widest(const Bounds& bounds);

// Of its mesh and material.
inline constexpr const char* kGroundName = "ground (added)";
// The last mesh and material: a square of light grey (0.7) at this height (y, scene space), twelve times as
// wide as the subject, that fades into the background (Material::fade).
void add_ground(Scene& scene, const Bounds& subject, double height);

// Of an added sun: ten lux, or where an image lights the scene as much stronger than it as than a studio.
float sun_lux(const Environment& environment);

// One directional light in the place of all others. `direction`: unit, the way its light travels.
void set_sun(Scene& scene, const glm::dvec3& direction, float lux);

// A studio's light, unless there is an environment image or one was already set: lighting a horizontal
// surface with 30 % of what the scene's lights give. False where nothing was added.
bool add_sky(Scene& scene);

// What the scene's lights together give at its centre on a surface facing each of them, in lux; or without
// casters and sun the lamps' level (lamp_level.hpp).
double light_level(const Scene& scene);

}  // namespace caustics
