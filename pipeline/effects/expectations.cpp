#include "pipeline/effects/expectations.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "pipeline/scene/exact.hpp"

namespace caustics {

namespace {

// Where a mesh lies, as a sphere.
struct Sphere {
  glm::dvec3 centre{0.0};
  double radius = 0.0;
};

Sphere sphere_of(const Mesh& mesh) {
  const glm::dvec3 lower(mesh.lower), upper(mesh.upper);
  const glm::dvec3 half = 0.5 * (upper - lower);
  return {0.5 * (upper + lower), exact::length(half)};
}

// Of a mesh's box, along a direction: from its middle to its farthest corner, metres.
double half_extent(const Mesh& mesh, const glm::dvec3& d) {
  const glm::dvec3 half = 0.5 * (glm::dvec3(mesh.upper) - glm::dvec3(mesh.lower));
  return half.x * std::fabs(d.x) + half.y * std::fabs(d.y) + half.z * std::fabs(d.z);
}

// Does the mesh lie wholly outside the cone? It does when one of two planes parts them: the one across the
// axis at the tip, or the one that touches the cone on the side of the mesh's sphere.
bool cone_misses(const Light& light, const Mesh& mesh) {
  const Sphere sphere = sphere_of(mesh);
  const glm::dvec3 to = sphere.centre - light.position;
  const double along = exact::dot(to, light.direction);
  const double across = std::sqrt(std::max(exact::dot(to, to) - along * along, 0.0));
  double sine, cosine;
  const double widest = light.lambertian ? 0.5 * exact::kPi : static_cast<double>(light.outer_cone);
  exact::sin_cos(widest, sine, cosine);
  return along < -half_extent(mesh, light.direction) || across * cosine - along * sine > sphere.radius;
}

// Nearest and farthest distance of a box along the light's way: metres along a directional light,
// from the position of the others.
struct Reach {
  double nearest, farthest;
};

Reach reach_of(const Light& light, const Mesh& mesh) {
  const Sphere sphere = sphere_of(mesh);
  if (light.type != LightType::Directional) {
    const glm::dvec3 to = sphere.centre - light.position;
    const double distance = exact::length(to);
    return {std::max(distance - sphere.radius, 0.0), distance + sphere.radius};
  }
  const double middle = exact::dot(sphere.centre, light.direction);
  const double extent = half_extent(mesh, light.direction);
  return {middle - extent, middle + extent};
}

// Why no light of this kind gets from the light by the mesh onto a receiver, or nothing.
// `receivers`: the farthest that any of them reaches from the light; none where there is no receiver.
std::string unreachable(const Scene& scene, const Light& light, std::size_t mesh, bool mirror,
                        std::optional<double> receivers) {
  if (std::string reason = why_not_lit(scene, light, mesh); !reason.empty()) return reason;
  if (!receivers) return "there is no diffuse receiver";
  // A mirror sends light any way.
  if (mirror || *receivers > reach_of(light, scene.meshes[mesh]).nearest) return {};
  return "no receiver lies behind it, seen from the light";
}

// Looked for once a light, not once a light and caster: there may be a million of them.
std::optional<double> farthest_receiver(const Scene& scene, const Light& light,
                                        const std::vector<Judgement>& judgements) {
  std::optional<double> farthest;
  for (std::size_t i = 0; i < judgements.size(); ++i) {
    if (judgements[i].role.role != Role::Receiver) continue;
    const double here = reach_of(light, scene.meshes[i]).farthest;
    farthest = farthest ? std::max(*farthest, here) : here;
  }
  return farthest;
}

}  // namespace

bool is_dark(const Light& light) { return !(brightness(light) > 0.0); }

std::string why_not_lit(const Scene& scene, const Light& light, std::size_t index) {
  const Mesh& mesh = scene.meshes[index];
  if (is_dark(light)) return "the light's intensity or colour is 0";
  if (light.emitter == static_cast<int>(index)) return "it is the light itself";
  if (light.type == LightType::Spot && cone_misses(light, mesh)) return "the spot light's cone misses it";
  if (light.lambertian && cone_misses(light, mesh)) return "it lies behind the light";
  if (light.type != LightType::Directional &&
      reach_of(light, mesh).nearest > static_cast<double>(light.range))
    return "it lies beyond the light's range of " + rounded_text(light.range) + " m";
  return {};
}

std::vector<Expectation> expectations_of(const Scene& scene, const std::vector<Judgement>& judgements) {
  std::vector<Expectation> expectations;
  for (std::size_t l = 0; l < scene.lights.size(); ++l) {
    const std::optional<double> receivers = farthest_receiver(scene, scene.lights[l], judgements);
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
      if (!judgements[m].looks_specular) continue;
      Expectation e{static_cast<int>(l), static_cast<int>(m), false, judgements[m].no_caustic};
      const Role role = judgements[m].role.role;
      if (is_caster(role)) {
        const Mesh& mesh = scene.meshes[m];
        e.reason = unreachable(scene, scene.lights[l], m, role == Role::Mirror, receivers);
        e.expected = e.reason.empty();
        const float ior = scene.materials[static_cast<std::size_t>(mesh.material)].ior;
        if (e.expected && role == Role::Mirror) {
          e.reason = "light reaches it and is mirrored onto what stands around";
        } else if (e.expected) {
          e.reason = ior == 1.0f ? "IOR 1 bends nothing: its light passes, but without a focus"
                                 : "light reaches it and a receiver lies behind it";
        }
      }
      expectations.push_back(std::move(e));
    }
  }
  return expectations;
}

}  // namespace caustics
