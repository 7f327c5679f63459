// Ray queries on the scene's triangles: Embree finds the triangle in single precision, and the ray meets its
// plane once more in double precision. Exact shapes are met in double precision from the start; Embree finds
// their boxes. The only room that knows Embree, of version 3 or 4.
#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "lab/reference/tracer/exact_shapes.hpp"
#include "lab/reference/tracer/ray.hpp"
#include "pipeline/scene/scene.hpp"

namespace caustics::tracer {

struct SurfaceHit {
  int mesh = -1, triangle = -1;  // of Scene::meshes
  double distance = 0.0;
  glm::dvec3 position{0.0};  // on the triangle's plane
  glm::dvec3 plane{0.0};     // unit normal of the triangle, outward
  glm::dvec3 normal{0.0};    // unit, interpolated between its vertices' as the renderer does
  glm::dvec2 uv{0.0};        // texture coordinates, interpolated likewise
  bool front = true;         // the ray meets the outer side
};

// Is this build able to trace rays? Otherwise making a RaySet throws Error (BackendUnavailable).
bool has_ray_queries();
// "3.13.5", or "none".
const char* ray_queries_version();

class RaySet {
 public:
  // Of these meshes; the scene must outlive the set and keep its vertices. No meshes are fine: nothing is
  // hit. Those in `exact` are traced as the shapes given there; a hit's triangle is -1 then. `dressed`: their
  // textures lean normals. Rays pass the holes that alpha masks cut, and of blended surfaces that are not
  // dressed all that is not opaque.
  RaySet(const Scene& scene, const std::vector<int>& meshes, const std::vector<ExactShape>& exact = {},
         bool dressed = false);
  ~RaySet();
  RaySet(RaySet&&) noexcept;
  RaySet& operator=(RaySet&&) noexcept;

  // The nearest hit with from <= distance <= to, up to single precision's rounding.
  std::optional<SurfaceHit> nearest(const Ray& ray, double from, double to) const;
  bool blocked(const Ray& ray, double from, double to) const;
  bool empty() const { return meshes_.empty(); }

 private:
  struct Handles;
  std::optional<SurfaceHit> nearest_surface(const Ray& ray, double from, double to) const;
  bool is_hole(const SurfaceHit& hit) const;
  bool may_have_holes(int mesh) const;
  SurfaceHit met_again(const Ray& ray, int mesh, int triangle, double distance) const;
  const ExactShape* shape_of(int mesh) const;

  const Scene* scene_;
  std::vector<int> meshes_;  // by Embree's geometry number
  std::vector<ExactShape> exact_;
  bool dressed_ = false, has_holes_ = false;
  std::unique_ptr<Handles> handles_;
};

}  // namespace caustics::tracer
