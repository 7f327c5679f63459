// A scene as the tracer sees it: which surfaces do what to light, and rays that find them.
#pragma once
#include <memory>
#include <vector>

#include "lab/reference/tracer/optics.hpp"
#include "lab/reference/tracer/rays.hpp"

namespace caustics::tracer {

// What takes part in one light's paths: all but the mesh that shines it.
struct LitSet {
  RaySet casters, receivers;
  std::vector<int> caster_meshes;
  Bounds caster_bounds;
};

class World {
 public:
  // Throws Error (BadInput) naming what the tracer cannot simulate.
  World(const Scene& scene, const Effects& effects, const std::vector<ExactShape>& exact = {});

  const Scene& scene() const { return scene_; }
  const Effects& effects() const { return effects_; }
  const Optics& optics(int mesh) const { return optics_[static_cast<std::size_t>(mesh)]; }
  // What the surface does there, with its textures.
  Optics optics_at(const SurfaceHit& hit) const;
  // `source`: index into Scene::sources.
  const LitSet& lit_by(int source) const { return sets_[set_of_[static_cast<std::size_t>(source)]]; }
  // Does any caster throw a caustic of this light? If not, casters let it pass as if they were not there.
  bool throws_caustic(int source) const { return throws_[static_cast<std::size_t>(source)]; }
  const std::vector<ExactShape>& exact() const { return exact_; }
  const RaySet& casters() const { return sets_.front().casters; }
  const RaySet& receivers() const { return sets_.front().receivers; }
  // The panes, which light also meets behind its first caster.
  const RaySet& walls() const { return walls_; }
  // The share that panes and blended surfaces leave of light along a ray: of panes both faces and all
  // reflections between them, (1 - r) / (1 + r), times transmission and colour; of blended surfaces what they
  // do not cover.
  glm::dvec3 through_panes(const Ray& ray, double distance) const;
  // And what the medium leaves of it there, where the scene has one.
  glm::dvec3 through_air(const Ray& ray, double distance) const;
  // Metres; what is nearer than this to where a ray starts is the surface that it starts from.
  double nearest() const { return nearest_; }
  double size() const { return size_; }  // diameter of everything, lights and cameras included

 private:
  LitSet set_without(int emitter) const;

  const Scene& scene_;
  const Effects& effects_;
  std::vector<ExactShape> exact_;
  std::vector<Optics> optics_;
  std::unique_ptr<const Scene> overlapping_;  // null: no bodies touch
  std::vector<LitSet> sets_;
  std::vector<std::size_t> set_of_;
  std::vector<bool> throws_;
  RaySet panes_, walls_;
  Bounds medium_;
  double nearest_ = 1e-6, size_ = 1.0;
};

// The shading normal turned against the light and, where an interpolated one faces away from its own
// surface, tilted to just within the horizon: as passes/shared/optics.glsl has it. `flip`: met from inside.
glm::dvec3 facing_normal(const glm::dvec3& normal, const glm::dvec3& direction, bool flip);

}  // namespace caustics::tracer
