// `--physics full`: every reflection, every caster.
#include <algorithm>
#include <limits>
#include <optional>

#include "lab/reference/tracer/paths_common.hpp"

namespace caustics::tracer {

namespace {

constexpr double kNoEnd = std::numeric_limits<double>::infinity();
constexpr int kMostNested = 8;

}  // namespace

// A body that the light is in.
struct Inside {
  int body = -1, mesh = -1;
  double index = 1.0;  // of refraction, absolute
};

// The bodies that the light is in, the last entered last. They may overlap; the last one counts.
struct Media {
  std::array<Inside, kMostNested> list{};
  int count = 0;

  double index() const { return count > 0 ? list[static_cast<std::size_t>(count - 1)].index : 1.0; }
  int find(int body) const {
    for (int i = count - 1; i >= 0; --i)
      if (list[static_cast<std::size_t>(i)].body == body) return i;
    return -1;
  }
  void enter(const Inside& inside) {
    if (count < kMostNested) list[static_cast<std::size_t>(count++)] = inside;
  }
  // Once more, where there is room, beside the first time: what counts stays so.
  void enter_again(int at) {
    if (count == kMostNested) return;
    for (int i = count++; i > at; --i)
      list[static_cast<std::size_t>(i)] = list[static_cast<std::size_t>(i - 1)];
  }
  void leave(int at) {
    for (int i = at + 1; i < count; ++i)
      list[static_cast<std::size_t>(i - 1)] = list[static_cast<std::size_t>(i)];
    --count;
  }
};

namespace {

double largest(const glm::dvec3& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

// An index below 1 is relative to what surrounds the body, as of a bubble; others are absolute.
double absolute_index(double ior, double around) { return ior < 1.0 ? ior * around : ior; }

// Rough glass: a microfacet, drawn by GGX's density times its cosine to the normal, and what else of the
// light it sends on than one that is drawn so has for its share (Walter, Marschner, Li and Torrance 2007, eq.
// 34 to 41).
struct Facet {
  glm::dvec3 normal;
  double cosine;  // to the light; not above 0: it faces away
};

Facet drawn_facet(const glm::dvec3& n, const glm::dvec3& d, double alpha, Numbers& numbers) {
  const double u = numbers.next();
  double sine = 0.0, cosine = 1.0;
  exact::sin_cos(2.0 * exact::kPi * numbers.next(), sine, cosine);
  const double slope = alpha * std::sqrt(u / (1.0 - u));
  const glm::dvec3 x = exact::perpendicular(n), y = exact::cross(n, x);
  const glm::dvec3 m = exact::normalise(n + x * (slope * cosine) + y * (slope * sine), n);
  return {m, -exact::dot(d, m)};
}

// Smith's masking of one direction, cosine c to the normal.
double unmasked(double c, double alpha) {
  const double squared = c * c;
  return squared > 0.0 ? 2.0 / (1.0 + std::sqrt(1.0 + alpha * alpha * (1.0 - squared) / squared)) : 0.0;
}

double facet_weight(const Facet& facet, const glm::dvec3& n, const glm::dvec3& d, const glm::dvec3& o,
                    double alpha) {
  const double in = std::fabs(exact::dot(d, n)), leaning = exact::dot(facet.normal, n);
  if (!(in > 0.0) || !(leaning > 0.0)) return 0.0;
  const double out = std::fabs(exact::dot(o, n));
  return facet.cosine * unmasked(in, alpha) * unmasked(out, alpha) / (in * leaning);
}

// Light leaves a rough wall as its facet would mirror it, on the other side (KHR_materials_transmission).
glm::dvec3 past_wall(const glm::dvec3& d, const glm::dvec3& n, const glm::dvec3& facet) {
  const glm::dvec3 mirrored = reflected(d, facet);
  return mirrored - n * (2.0 * exact::dot(mirrored, n));
}

}  // namespace

struct Paths::Moving {
  Ray ray;
  glm::dvec3 flux{0.0};
  double first = 0.0;  // largest channel of what entered
  Media media;
  int surfaces = 0;      // met so far
  bool crossed = false;  // the last of them, instead of being mirrored
};

void Paths::full(const Arrival& arrival, const Way& way, Numbers& numbers, std::vector<Landing>& landings,
                 Account& account) const {
  Moving start;
  start.ray = arrival.ray;
  start.flux = way.share * arrival.flux;
  start.first = largest(start.flux);
  if (!(start.first > 0.0)) return;
  std::vector<Moving> pending;
  meet(start, arrival.hit, way.bend, numbers, pending, account);
  while (!pending.empty()) {
    Moving moving = pending.back();
    pending.pop_back();
    SurfaceHit met;
    if (!advance(moving, met, landings, account)) continue;
    meet(moving, met, way.bend, numbers, pending, account);
  }
}

// To the next caster: false where the light lands, misses or is given up.
bool Paths::advance(Moving& moving, SurfaceHit& met, std::vector<Landing>& landings, Account& account) const {
  if (moving.surfaces >= kMostSurfaces || largest(moving.flux) < kLeastShare * moving.first) {
    account.cut += moving.flux;
    return false;
  }
  auto caster = lit_.casters.nearest(moving.ray, world_.nearest(), kNoEnd);
  const auto wall = world_.walls().nearest(moving.ray, world_.nearest(), caster ? caster->distance : kNoEnd);
  if (wall) caster = wall;
  const auto receiver = receiver_on(moving.ray, moving.crossed);
  const double reach = caster ? caster->distance - world_.nearest() : kNoEnd;
  const bool lands = receiver && receiver->distance < reach;
  if (!lands && !caster) {
    account.missed += moving.flux;
    return false;
  }
  const double distance = lands ? receiver->distance : caster->distance;
  const Inside* in =
      moving.media.count > 0 ? &moving.media.list[static_cast<std::size_t>(moving.media.count - 1)] : nullptr;
  const glm::dvec3 left = moving.flux * (in ? after(world_.optics(in->mesh).absorption, distance)
                                            : world_.through_air(moving.ray, distance));
  account.absorbed += moving.flux - left;
  moving.flux = left;
  if (lands) {
    account.landed += moving.flux;
    landings.push_back({*receiver, moving.ray.direction, moving.flux});
    return false;
  }
  met = *caster;
  return true;
}

void Paths::meet(const Moving& moving, const SurfaceHit& met, double bend, Numbers& numbers,
                 std::vector<Moving>& pending, Account& account) const {
  const Optics optics = world_.optics_at(met);
  const glm::dvec3& d = moving.ray.direction;
  const Facing smooth = facing(met, d);
  const bool rough = optics.alpha > 0.0;
  Facing f = smooth;
  const glm::dvec3 outer = met.front ? met.plane : -met.plane;  // the plane's normal against the light
  Moving next = moving;
  next.ray.origin = met.position;
  ++next.surfaces;
  Facet facet{smooth.normal, smooth.cosine};
  const auto send = [&](Moving onward, const glm::dvec3& direction, bool crosses) {
    onward.ray.direction = direction;
    if (rough) {
      const glm::dvec3 all = onward.flux;
      onward.flux *= facet_weight(facet, smooth.normal, d, direction, optics.alpha);
      account.absorbed += all - onward.flux;  // masked
    }
    onward.crossed = crosses;
    // An interpolated normal can send light to the wrong side of its own surface.
    const double side = exact::dot(direction, outer);
    if (crosses ? side < 0.0 : side > 0.0)
      pending.push_back(onward);
    else
      (rough ? account.absorbed : account.cut) += onward.flux;
  };
  if (optics.role == Role::Mirror) {
    next.flux = moving.flux * metal(optics.color, f.cosine);
    account.absorbed += moving.flux - next.flux;
    return send(next, reflected(d, f.normal), false);
  }
  const int within = optics.thin ? -1 : moving.media.find(optics.body);
  Moving through = next;
  if (within >= 0) {
    if (met.front)
      through.media.enter_again(within);
    else
      through.media.leave(within);
    if (met.front || through.media.find(optics.body) >= 0) {  // a second skin of the same body
      through.crossed = true;
      pending.push_back(through);
      return;
    }
  }
  double n1 = moving.media.index(), n2 = n1;
  if (optics.thin) {
    n2 = optics.ior * n1;
  } else if (met.front) {
    n2 = absolute_index(optics.index(bend), n1);
    through.media.enter({optics.body, met.mesh, n2});
  } else if (within >= 0) {
    n2 = through.media.index();
  } else {  // the light began inside
    n1 = absolute_index(optics.index(bend), n2);
  }
  if (rough) {
    facet = drawn_facet(smooth.normal, d, optics.alpha, numbers);
    if (!(facet.cosine > 0.0)) {
      account.absorbed += moving.flux;
      return;
    }
    f = {facet.normal, std::min(facet.cosine, 1.0)};
  }
  const auto bent = optics.thin ? std::optional(past_wall(d, smooth.normal, f.normal))
                                : refract_direction(d, f.normal, n1 / n2);
  double r = bent ? fresnel(f.cosine, n1, n2).mean() : 1.0;
  if (bent) r *= optics.fresnel;
  if (optics.thin) r = optics.there * 2.0 * r / (1.0 + r);  // both faces
  // The tint counts once for each body, as light gets in; or out, where it began inside; and at each wall.
  glm::dvec3 tint = met.front || within < 0 ? optics.color : glm::dvec3(1.0);
  if (optics.there < 1.0) tint = ((1.0 - optics.there) + tint * (optics.there - r)) / (1.0 - r);
  const double weaker = std::min(r, 1.0 - r) * largest(moving.flux);
  // Microfacets send each part to another place anyway: more rays tell more than more parts of one.
  const bool both = !rough && weaker > kSplitShare * moving.first && next.surfaces <= kSplits;
  const bool mirrors = both || (!bent || (r > 0.0 && numbers.next() < r));
  if (mirrors) {
    Moving back = next;
    if (both) back.flux = moving.flux * r;
    send(back, reflected(d, f.normal), false);
  }
  if (both || !mirrors) {
    const glm::dvec3 share = both ? moving.flux * (1.0 - r) : moving.flux;
    through.flux = share * tint;
    account.absorbed += share - through.flux;
    send(through, *bent, true);
  }
}

}  // namespace caustics::tracer
