// Light followed through a scene's triangles all its way: what the passes leave out can be told from it
// (docs/accuracy.md). The pass light_step takes it from surface to surface.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "pipeline/effects/ray_tables.hpp"
#include "pipeline/plan/pass.hpp"
#include "pipeline/scene/triangle_tree.hpp"
#include "pipeline/scene/view.hpp"

namespace caustics {

// A ray of light before it meets anything. `flux`: by channel.
struct LightRay {
  glm::dvec3 origin{0.0}, direction{0.0, 0.0, -1.0};
  glm::dvec3 flux{1.0};
  int emitter = -1;       // Light::emitter, which its light passes before its first caster
  std::uint64_t key = 0;  // the ray's number: what it draws depends on that alone
  int own = -1;           // number of the triangle that it starts on, -1: none
};

// The ray of light through the middle of a texel of the light's view, `side` texels a side. Without its flux.
LightRay light_ray(const Light& light, const View& view, int side, int x, int y);

// Where a part of it met a receiver.
struct LightLanding {
  glm::dvec3 position{0.0}, flux{0.0};
  bool followed = false;  // on the way that the passes take: in, out where the caster is solid, and on
  int surfaces = 0;       // of casters, on its way
  int mesh = -1;          // the receiver, an index into Scene::meshes
  int triangle = -1;      // its triangle, by number (RayTables)
  bool front = true;      // it is met from outside
  std::size_t ray = 0;    // which it was part of
  int first = -1;         // the caster that the ray met first, an index into Scene::meshes
};

// The sum over its channels.
inline double flux_of(const LightLanding& landing) {
  return (landing.flux.x + landing.flux.y) + landing.flux.z;
}

// A path is followed both ways at a surface until it has met kBothWays of them or the weaker way has less
// than kWeakShare of the ray's flux; from then on one way is drawn, in proportion to Fresnel's shares. It is
// given up after kMostSurfaces, and below kLeastShare of its flux.
class LightPaths {
 public:
  static constexpr int kBothWays = 4, kMostSurfaces = 48;
  static constexpr double kWeakShare = 0.02, kLeastShare = 1e-4;

  // Tables, settings and registry must outlive it; the scene must keep its vertices.
  LightPaths(const RayTables& tables, Effects effects, const Settings& settings, const Registry& registry);
  LightPaths(const LightPaths&) = delete;
  LightPaths& operator=(const LightPaths&) = delete;

  // Adds where the rays' light lands behind casters, by any number of surfaces; to `astray` what the passes
  // would land although another caster stands before the receiver. `bend`: Branch::bend.
  void follow(std::span<const LightRay> rays, std::vector<LightLanding>& landings, double bend = 0.0,
              std::vector<LightLanding>* astray = nullptr) const;
  // Where the rays meet the first receivers if casters do not stand in their way; nothing of those that meet
  // none.
  std::vector<LightLanding> first_receivers(std::span<const LightRay> rays) const;
  // Do the passes follow it all its way too?
  bool followed_by_passes() const { return effects_.further_surfaces.active; }
  // Does a caster stand on the way from p in this direction, up to that distance?
  bool casters_block(const glm::dvec3& p, const glm::dvec3& direction, double distance) const;

 private:
  struct Part;      // of a ray's light, on its way to the next surface
  struct Meeting;   // what the pass tells of it there
  class Stepping;   // runs the pass
  class Following;  // of many rays

  // On a part's way to what it meets.
  glm::dvec3 left_by_air(const Part& part, const Meeting& met) const;

  const RayTables& tables_;
  const Effects effects_;
  const Settings& settings_;
  const Pass& pass_;
  const PassDefinition definition_;
  const Bounds medium_;
  mutable std::optional<TriangleTree> casters_;  // made when it is first asked for
};

}  // namespace caustics
