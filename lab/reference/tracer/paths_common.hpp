// What the files of paths.hpp share.
#pragma once
#include <cmath>

#include "lab/reference/closed_forms.hpp"
#include "lab/reference/tracer/paths.hpp"
#include "pipeline/scene/exact.hpp"

namespace caustics::tracer {

struct Paths::Arrival {
  Ray ray;
  SurfaceHit hit;
  glm::dvec3 flux{0.0};  // what panes before it have left
};

inline glm::dvec3 after(const glm::dvec3& absorption, double metres) {
  const double d = std::max(metres, 0.0);
  return {beer_lambert(absorption.x, d), beer_lambert(absorption.y, d), beer_lambert(absorption.z, d)};
}

inline glm::dvec3 reflected(const glm::dvec3& d, const glm::dvec3& normal) {
  return exact::normalise(d - normal * (2.0 * exact::dot(d, normal)), -d);
}

// Schlick (1994), as glTF 2.0 has it (appendix B.2).
inline glm::dvec3 metal(const glm::dvec3& straight_on, double cosine) {
  const double s = 1.0 - cosine, grazing = (s * s) * (s * s) * s;
  return straight_on * (1.0 - grazing) + glm::dvec3(grazing);
}

// A surface as the light meets it.
struct Facing {
  glm::dvec3 normal;  // against the light
  double cosine;      // of incidence
};
inline Facing facing(const SurfaceHit& hit, const glm::dvec3& direction) {
  const glm::dvec3 n = facing_normal(hit.normal, direction, !hit.front);
  return {n, std::min(std::max(-exact::dot(direction, n), 0.0), 1.0)};
}

}  // namespace caustics::tracer
