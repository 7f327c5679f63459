// Light followed through a scene's triangles all its way: what the passes leave out can be told from it
// (docs/accuracy.md).
#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/effects/optics.hpp"
#include "pipeline/scene/triangle_tree.hpp"
#include "pipeline/scene/view.hpp"

namespace caustics {

// A ray of light before it meets anything. `flux`: by channel.
struct LightRay {
  glm::dvec3 origin{0.0}, direction{0.0, 0.0, -1.0};
  glm::dvec3 flux{1.0};
  double bend = 0.0;      // Branch::bend
  int emitter = -1;       // Light::emitter, which its light passes
  std::uint64_t key = 0;  // the ray's number: what it draws depends on that alone
};

// The ray of light through the middle of a texel of the light's view, `side` texels a side. Without its flux.
LightRay light_ray(const Light& light, const View& view, int side, int x, int y);

// Where a part of it met a receiver.
struct LightLanding {
  glm::dvec3 position{0.0}, flux{0.0};
  bool followed = false;  // on the way that the passes take: in, out where the caster is solid, and on
  int surfaces = 0;       // of casters, on its way
  int mesh = -1;          // the receiver, an index into Scene::meshes
};

// A path is followed both ways at a surface until it has met kBothWays of them or the weaker way has less
// than kWeakShare of the ray's flux; from then on one way is drawn, in proportion to Fresnel's shares. It is
// given up after kMostSurfaces, and below kLeastShare of its flux.
class LightPaths {
 public:
  static constexpr int kBothWays = 4, kMostSurfaces = 48;
  static constexpr double kWeakShare = 0.02, kLeastShare = 1e-4;

  // Both must outlive it; the scene must keep its vertices.
  LightPaths(const Scene& scene, const Effects& effects);
  LightPaths(const LightPaths&) = delete;
  LightPaths& operator=(const LightPaths&) = delete;

  // Adds where the light lands behind casters, by any number of surfaces; to `astray` what the passes would
  // land although another caster stands before the receiver. The first caster that it meets, an index into
  // Scene::meshes; -1 where there is none.
  int follow(const LightRay& light, std::vector<LightLanding>& landings, glm::dvec3* astray = nullptr) const;
  // Do the passes follow it all its way too?
  bool followed_by_passes() const { return followed_by_passes_; }
  // Does a caster stand on the way from p in this direction, up to that distance?
  bool casters_block(const glm::dvec3& p, const glm::dvec3& direction, double distance) const;

 private:
  struct Body;
  struct Bodies;  // that the light is in
  struct Moving;  // light between two surfaces
  struct Facet;   // of rough glass
  class Draws;
  bool advance(const LightRay& light, Moving& moving, TriangleHit& met, std::vector<LightLanding>& landings,
               glm::dvec3* astray) const;
  void meet(const Moving& moving, const TriangleHit& met, double bend, Draws& draws,
            std::vector<Moving>& pending) const;
  const Optics& optics(const TriangleHit& hit) const {
    return optics_[static_cast<std::size_t>(hit.id.mesh)];
  }
  bool is_hole(const TriangleHit& hit) const;
  const Material& material(const TriangleHit& hit) const {
    const Mesh& mesh = scene_.meshes[static_cast<std::size_t>(hit.id.mesh)];
    return scene_.materials[static_cast<std::size_t>(mesh.material)];
  }

  const Scene& scene_;
  std::vector<Optics> optics_;
  TriangleTree casters_, receivers_;
  bool followed_by_passes_ = false;
  bool reflections_ = false;  // what glass mirrors at its first surface is followed by the passes too
  double nearest_ = 1e-6;     // metres: surfaces as near to one another touch
};

}  // namespace caustics
