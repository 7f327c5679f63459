// What the light of one ray does at the casters, and where it lands.
#pragma once
#include <array>
#include <vector>

#include "lab/reference/tracer/emission.hpp"

namespace caustics::tracer {

enum class Physics : std::uint8_t {
  Single,  // what `render` simulates: in, out, land
  Full,    // every reflection and every caster on the way
};

// Where the light went, by channel, relative to the light's intensity (LightRay::flux).
// entered = the sum of all others.
struct Account {
  glm::dvec3 entered{0.0};           // fell on casters
  glm::dvec3 landed{0.0};            // on receivers, seen by the camera or not
  glm::dvec3 fresnel{0.0};           // mirrored by dielectrics and not followed
  glm::dvec3 absorbed{0.0};          // by glass, water, metal
  glm::dvec3 total_reflection{0.0};  // and not followed
  glm::dvec3 missed{0.0};            // left the casters, met no receiver
  glm::dvec3 lost{0.0};              // entered a body and found no way out of it
  glm::dvec3 cut{0.0};               // given up: too many surfaces, too weak, or bent through its own surface
  double rays = 0.0, hits = 0.0, landings = 0.0;  // numbers of them

  void add(const Account& other);
  glm::dvec3 gap() const;  // entered less all others
};

struct Landing {
  SurfaceHit on;
  glm::dvec3 direction{0.0};  // unit, the way the light travels
  glm::dvec3 flux{0.0};       // relative to the light's intensity
};

// Of `--physics full`: a path is followed both ways at a surface until it has met kSplits of them or the
// weaker way has less than kSplitShare of the ray's flux; from then on one way is drawn, in proportion to
// Fresnel's shares.
inline constexpr int kSplits = 4, kMostSurfaces = 64;
inline constexpr double kSplitShare = 0.02, kLeastShare = 1e-6;

class Paths {
 public:
  Paths(const World& world, int source, Physics physics);
  // Adds to both.
  void follow(const LightRay& light, Numbers& numbers, std::vector<Landing>& landings,
              Account& account) const;

 private:
  // One kind of light.
  struct Way {
    double bend = 0.0;  // Branch::bend
    glm::dvec3 share{1.0};
  };
  struct Arrival;  // light at its first caster
  struct Moving;   // light between two surfaces
  void single(const Arrival& arrival, const Way& way, std::vector<Landing>& landings, Account& account) const;
  void mirrored(const Arrival& arrival, std::vector<Landing>& landings, Account& account) const;
  void off_dielectric(const Arrival& arrival, std::vector<Landing>& landings, Account& account) const;
  void through_body(const Arrival& arrival, const Way& way, const glm::dvec3& inside, const glm::dvec3& flux,
                    std::vector<Landing>& landings, Account& account) const;
  std::optional<SurfaceHit> way_out(const Ray& inside, int body) const;
  void full(const Arrival& arrival, const Way& way, Numbers& numbers, std::vector<Landing>& landings,
            Account& account) const;
  bool advance(Moving& moving, SurfaceHit& met, std::vector<Landing>& landings, Account& account) const;
  void meet(const Moving& moving, const SurfaceHit& met, double bend, Numbers& numbers,
            std::vector<Moving>& pending, Account& account) const;
  void land(const Ray& ray, bool crossed, const glm::dvec3& flux, const Optics* medium,
            std::vector<Landing>& landings, Account& account) const;
  std::optional<SurfaceHit> receiver_on(const Ray& ray, bool crossed) const;

  const World& world_;
  const LitSet& lit_;
  // The receivers that light can meet behind its first caster. In `full` the mesh that shines is among them.
  const RaySet& behind_casters_;
  Physics physics_;
  std::vector<Way> ways_;
  glm::dvec3 white_{0.0};  // what the shares of all ways add up to
  bool reflections_ = false;
  bool dispersion_ = false;
};

}  // namespace caustics::tracer
