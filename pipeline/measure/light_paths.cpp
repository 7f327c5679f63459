#include "pipeline/measure/light_paths.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "pipeline/effects/dressed_optics.hpp"
#include "pipeline/gpu/interrupt.hpp"
#include "pipeline/scene/exact.hpp"

namespace caustics {

namespace {

constexpr int kMostNested = 8;
constexpr int kMostHoles = 256;  // that light passes before it meets a caster

double largest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

// An index below 1 is relative to what surrounds the body, as of a bubble; others are absolute.
double absolute_index(double ior, double around) { return ior < 1.0 ? ior * around : ior; }

std::vector<int> meshes_of(const std::vector<Optics>& optics, bool casters) {
  std::vector<int> meshes;
  for (int m = 0; m < static_cast<int>(optics.size()); ++m) {
    const Role role = optics[static_cast<std::size_t>(m)].role;
    if (casters ? is_caster(role) : role == Role::Receiver) meshes.push_back(m);
  }
  return meshes;
}

// The shading normal against the light. One that faces away from its own surface is tilted to just within the
// horizon (passes/shared/optics.glsl, facing_normal).
glm::dvec3 normal_against(const glm::dvec3& normal, const glm::dvec3& direction) {
  const double along = exact::dot(normal, direction);
  if (along < -1e-4) return normal;
  return exact::normalise(normal - direction * (along + 1e-3), -direction);
}

glm::dvec3 mirrored(const glm::dvec3& direction, const glm::dvec3& normal) {
  return exact::normalise(direction - normal * (2.0 * exact::dot(direction, normal)), -direction);
}

// Unpolarised light at an interface. Snell's law as t = eta d - mu N, with
// mu = cos_t - eta cos_i as a quotient, so that nothing cancels at eta = 1.
struct Interface {
  double reflectance = 1.0;
  bool total = true;
  glm::dvec3 bent{0.0};

  Interface(const glm::dvec3& d, const glm::dvec3& n, double n1, double n2) {
    const double eta = n1 / n2, ci = std::clamp(-exact::dot(d, n), 0.0, 1.0);
    const double squared = 1.0 - eta * eta * (1.0 - ci * ci);
    if (!(squared > 0.0)) return;
    const double ct = std::sqrt(squared);
    total = false;
    bent = exact::normalise(d * eta - n * ((1.0 - eta * eta) / (ct + eta * ci)), d);
    const double s = (n1 * ci - n2 * ct) / (n1 * ci + n2 * ct), p = (n1 * ct - n2 * ci) / (n1 * ct + n2 * ci);
    reflectance = 0.5 * (s * s + p * p);
  }
};

// Schlick (1994), as glTF 2.0 has it (appendix B.2).
glm::dvec3 metal(const glm::dvec3& straight_on, double cosine) {
  const double s = 1.0 - cosine, grazing = (s * s) * (s * s) * s;
  return straight_on * (1.0 - grazing) + glm::dvec3(grazing);
}

// Smith's masking of one direction, cosine c to the normal.
double unmasked(double c, double alpha) {
  const double squared = c * c;
  return squared > 0.0 ? 2.0 / (1.0 + std::sqrt(1.0 + alpha * alpha * (1.0 - squared) / squared)) : 0.0;
}

glm::dvec3 left_after(const glm::dvec3& absorption, double metres) {
  return {exact::exp(-absorption.x * metres), exact::exp(-absorption.y * metres),
          exact::exp(-absorption.z * metres)};
}

}  // namespace

LightRay light_ray(const Light& light, const View& view, int side, int x, int y) {
  LightRay ray{.origin = view.origin, .direction = view.forward, .emitter = light.emitter};
  const glm::dvec2 middle(x + 0.5, y + 0.5);
  if (view.cube) {
    const int column = x / view.cube->tile_width(), row = y / view.cube->tile_height();
    const int face = 3 * row + column;
    const glm::dvec2 corner = view.cube->texel(glm::dvec2(-1.0), face);
    const glm::dvec2 tangents =
        (middle - corner) / glm::dvec2(view.cube->face_width(), view.cube->face_height()) * 2.0 - 1.0;
    const glm::dvec3 q = turned_from_face({tangents.x, tangents.y, 1.0}, face);
    ray.direction = exact::normalise((view.right * q.x + view.up * q.y) + view.forward * q.z, view.forward);
    return ray;
  }
  const glm::dvec2 window =
      view.window_lower + (view.window_upper - view.window_lower) * (middle / static_cast<double>(side));
  const glm::dvec3 aside = view.right * window.x + view.up * window.y;
  if (view.perspective) {
    ray.direction = exact::normalise(view.forward + aside, view.forward);
  } else {
    ray.origin = view.origin + aside;
  }
  return ray;
}

// Random numbers by counter: SplitMix64 (Steele, Lea, Flood 2014) from the ray's own number.
class LightPaths::Draws {
 public:
  explicit Draws(std::uint64_t key) : state_(key * 0x9e3779b97f4a7c15ull) {}
  // In [0, 1).
  double next() {
    std::uint64_t x = state_ += 0x9e3779b97f4a7c15ull;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return static_cast<double>((x ^ (x >> 31)) >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

// A body that the light is in. Bodies may overlap: the last that was entered counts.
struct LightPaths::Body {
  int number = -1, mesh = -1;
  double index = 1.0;  // of refraction, absolute
};

struct LightPaths::Bodies {
  std::array<Body, kMostNested> list{};
  int count = 0;

  const Body* last() const { return count > 0 ? &list[static_cast<std::size_t>(count) - 1] : nullptr; }
  double index() const { return count > 0 ? last()->index : 1.0; }
  bool has(int number) const {
    return std::any_of(list.begin(), list.begin() + count,
                       [&](const Body& body) { return body.number == number; });
  }
  void enter(const Body& body) {
    if (count < kMostNested) list[static_cast<std::size_t>(count++)] = body;
  }
  // Where light is in a second skin of it, once more below all others.
  void enter_again(const Body& body) {
    if (count == kMostNested) return;
    std::copy_backward(list.begin(), list.begin() + count, list.begin() + count + 1);
    list.front() = body;
    ++count;
  }
  // Once.
  void leave(int number) {
    int at = count - 1;
    while (at >= 0 && list[static_cast<std::size_t>(at)].number != number) --at;
    if (at < 0) return;
    std::copy(list.begin() + at + 1, list.begin() + count, list.begin() + at);
    --count;
  }
};

// A microfacet, drawn by GGX's density of slopes; what it sends on of its share (Walter, Marschner, Li and
// Torrance 2007, equations 34 to 41).
struct LightPaths::Facet {
  glm::dvec3 normal;

  explicit Facet(const glm::dvec3& n) : normal(n) {}
  Facet(const glm::dvec3& n, const glm::dvec3& d, double alpha, Draws& draws) {
    const double share = draws.next();
    double sine = 0.0, cosine = 1.0;
    exact::sin_cos(2.0 * exact::kPi * draws.next(), sine, cosine);
    const double slope = alpha * std::sqrt(share / (1.0 - share));
    const glm::dvec3 x = exact::perpendicular(n), y = exact::cross(n, x);
    normal = normal_against(exact::normalise(n + x * (slope * cosine) + y * (slope * sine), n), d);
  }
  double weight(const glm::dvec3& n, const glm::dvec3& d, const glm::dvec3& o, double alpha) const {
    const double in = std::fabs(exact::dot(d, n)), leaning = exact::dot(normal, n);
    if (!(in > 0.0) || !(leaning > 0.0)) return 0.0;
    return -exact::dot(d, normal) * unmasked(in, alpha) * unmasked(std::fabs(exact::dot(o, n)), alpha) /
           (in * leaning);
  }
};

struct LightPaths::Moving {
  glm::dvec3 origin{0.0}, direction{0.0}, flux{0.0};
  double first = 0.0;    // the largest channel of what the light began with
  TriangleId on{};       // where it starts
  bool crossed = false;  // that surface, instead of being mirrored
  int surfaces = 0;      // met so far
  bool followed = true;  // by the passes too, so far
  bool let_go = false;   // the passes land it on the next receiver, whatever caster stands before it
  Bodies bodies{};
};

LightPaths::LightPaths(const Scene& scene, const Effects& effects)
    : scene_(scene),
      optics_(optics_of(scene, effects)),
      casters_(scene, meshes_of(optics_, true)),
      receivers_(scene, meshes_of(optics_, false)),
      followed_by_passes_(effects.further_surfaces.active),
      reflections_(effects.reflections.active) {
  const Bounds bounds = bounds_of(scene);
  if (!bounds.empty()) nearest_ = 4e-6 * std::max(bounds.radius(), 1e-6);
}

int LightPaths::follow(const LightRay& light, std::vector<LightLanding>& landings, glm::dvec3* astray) const {
  stop_if_interrupted();
  glm::dvec3 origin = light.origin;
  auto first = casters_.nearest(origin, light.direction, {}, light.emitter);
  // Light that passes a hole has met nothing. It starts anew a little behind, as two holes may touch.
  for (int holes = 0; first && is_hole(*first); ++holes) {
    if (holes == kMostHoles) return -1;
    origin = position_of(scene_, *first) + light.direction * nearest_;
    first = casters_.nearest(origin, light.direction, first->id, light.emitter);
  }
  if (!first) return -1;
  Draws draws(light.key);
  std::vector<Moving> pending;
  meet({.origin = origin, .direction = light.direction, .flux = light.flux, .first = largest(light.flux)},
       *first, light.bend, draws, pending);
  while (!pending.empty()) {
    Moving moving = pending.back();
    pending.pop_back();
    TriangleHit met;
    if (advance(light, moving, met, landings, astray)) meet(moving, met, light.bend, draws, pending);
  }
  return first->id.mesh;
}

bool LightPaths::is_hole(const TriangleHit& hit) const {
  const Material& m = material(hit);
  return m.alpha_mode == AlphaMode::Mask && is_cut_out(scene_, m, uv_of(scene_, hit));
}

bool LightPaths::casters_block(const glm::dvec3& p, const glm::dvec3& direction, double distance) const {
  const auto caster = casters_.nearest(p + direction * nearest_, direction);
  return caster && caster->distance < distance;
}

// To the next caster: false where the light lands, misses or is given up.
bool LightPaths::advance(const LightRay& light, Moving& moving, TriangleHit& met,
                         std::vector<LightLanding>& landings, glm::dvec3* astray) const {
  if (moving.surfaces >= kMostSurfaces || largest(moving.flux) < kLeastShare * moving.first) return false;
  const auto caster = casters_.nearest(moving.origin, moving.direction, moving.on, light.emitter);
  // Light that crossed a surface may start on a receiver that touches it; light that was mirrored may not.
  const double back = moving.crossed ? nearest_ : -nearest_;
  const auto receiver =
      receivers_.nearest(moving.origin - moving.direction * back, moving.direction, {}, light.emitter);
  const double to_receiver = receiver ? std::max(receiver->distance - back, 0.0) : 0.0;
  const bool lands = receiver && (!caster || to_receiver < caster->distance - nearest_);
  if (!lands && !caster) return false;
  if (const Body* in = moving.bodies.last())
    moving.flux *= left_after(optics_[static_cast<std::size_t>(in->mesh)].absorption,
                              lands ? to_receiver : caster->distance);
  if (lands) {
    landings.push_back(
        {position_of(scene_, *receiver), moving.flux, moving.let_go, moving.surfaces, receiver->id.mesh});
    return false;
  }
  if (receiver && moving.let_go && astray) *astray += moving.flux;
  met = *caster;
  return true;
}

void LightPaths::meet(const Moving& moving, const TriangleHit& met, double bend, Draws& draws,
                      std::vector<Moving>& pending) const {
  const Material& m = material(met);
  const bool has_textures = is_dressed(m);
  const glm::dvec2 uv = has_textures ? uv_of(scene_, met) : glm::dvec2(0.0);
  const Optics o = has_textures ? dressed(scene_, m, optics(met), uv) : optics(met);
  const glm::dvec3& d = moving.direction;
  const double side = met.front ? 1.0 : -1.0;
  const glm::dvec3 plane = plane_normal(scene_, met.id) * side;
  glm::dvec3 outward = shading_normal(scene_, met);
  if (has_textures) outward = leaned(scene_, m, outward, tangent_of(scene_, met), uv);
  const glm::dvec3 normal = normal_against(outward * side, d);
  Moving next = moving;
  next.origin = position_of(scene_, met);
  next.on = met.id;
  ++next.surfaces;
  // What an interpolated normal sends to the wrong side of its own surface is given up.
  const bool mirror = o.role == Role::Mirror;
  const bool rough = o.alpha > 0.0;
  const Facet facet = rough ? Facet(normal, d, o.alpha, draws) : Facet(normal);
  const auto send = [&](Moving onward, const glm::dvec3& direction, bool crosses) {
    if (rough) onward.flux *= facet.weight(normal, d, direction, o.alpha);
    onward.direction = direction;
    onward.crossed = crosses;
    const bool in = next.surfaces == 1 && (crosses != mirror || reflections_);
    const bool out = next.surfaces == 2 && o.solid && crosses && !met.front;
    onward.followed = moving.followed && (in || out);
    onward.let_go = onward.followed && (out || !crosses || !o.solid);
    if ((exact::dot(direction, plane) < 0.0) == crosses) pending.push_back(onward);
  };
  if (has_textures && is_cut_out(scene_, m, uv)) return send(next, d, true);
  if (mirror) {
    next.flux *= metal(o.color, -exact::dot(d, normal));
    return send(next, mirrored(d, normal), false);
  }
  const bool within = !o.thin && moving.bodies.has(o.body);
  Moving through = next;
  if (within && met.front) through.bodies.enter_again({o.body, met.id.mesh, through.bodies.index()});
  if (within && !met.front) through.bodies.leave(o.body);
  if (within && (met.front || through.bodies.has(o.body)))  // a second skin of the same body
    return send(through, d, true);
  double n1 = moving.bodies.index(), n2 = n1;
  if (o.thin) {
    n2 = o.ior * n1;
  } else if (met.front) {
    n2 = absolute_index(o.index(bend), n1);
    through.bodies.enter({o.body, met.id.mesh, n2});
  } else if (within) {
    n2 = through.bodies.index();
  } else {  // the light began inside
    n1 = absolute_index(o.index(bend), n2);
  }
  Interface at(d, facet.normal, n1, n2);
  double r = at.total ? 1.0 : at.reflectance * o.fresnel;
  if (o.thin) {
    // Past both faces of a wall as its facet would mirror it, on the other side.
    const glm::dvec3 back = mirrored(d, facet.normal);
    at.bent = back - normal * (2.0 * exact::dot(back, normal));
    r = 2.0 * r / (1.0 + r);
  }
  const double weaker = std::min(r, 1.0 - r) * largest(moving.flux);
  const bool both = weaker > kWeakShare * moving.first && next.surfaces <= kBothWays;
  const bool mirrors = both || at.total || draws.next() < r;
  if (mirrors) {
    Moving back = next;
    if (both) back.flux *= r;
    send(back, mirrored(d, facet.normal), false);
  }
  if (both || !mirrors) {
    if (both) through.flux *= 1.0 - r;
    // The tint counts once for each body, as light gets in; or out, where it began inside.
    if (met.front || !within) through.flux *= o.color;
    send(through, at.bent, true);
  }
}

}  // namespace caustics
