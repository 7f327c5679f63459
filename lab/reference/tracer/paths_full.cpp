// `--physics full`: every reflection, every caster.
#include <algorithm>
#include <limits>

#include "lab/reference/tracer/paths_common.hpp"

namespace caustics::tracer {

namespace {

constexpr double kNoEnd = std::numeric_limits<double>::infinity();
constexpr int kMostNested = 8;

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

double largest(const glm::dvec3& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

// An index below 1 is relative to what surrounds the body, as of a bubble; others are absolute.
double absolute_index(double ior, double around) { return ior < 1.0 ? ior * around : ior; }

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
  const auto caster = lit_.casters.nearest(moving.ray, world_.nearest(), kNoEnd);
  const auto receiver = receiver_on(moving.ray, moving.crossed);
  const double reach = caster ? caster->distance - world_.nearest() : kNoEnd;
  const bool lands = receiver && receiver->distance < reach;
  if (!lands && !caster) {
    account.missed += moving.flux;
    return false;
  }
  if (moving.media.count > 0) {
    const Inside& in = moving.media.list[static_cast<std::size_t>(moving.media.count - 1)];
    const glm::dvec3 left =
        moving.flux * after(world_.optics(in.mesh).absorption, lands ? receiver->distance : caster->distance);
    account.absorbed += moving.flux - left;
    moving.flux = left;
  }
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
  const Optics& optics = world_.optics(met.mesh);
  const glm::dvec3& d = moving.ray.direction;
  const Facing f = facing(met, d);
  const glm::dvec3 outer = met.front ? met.plane : -met.plane;  // the plane's normal against the light
  Moving next = moving;
  next.ray.origin = met.position;
  ++next.surfaces;
  const auto send = [&](Moving onward, const glm::dvec3& direction, bool crosses) {
    onward.ray.direction = direction;
    onward.crossed = crosses;
    // An interpolated normal can send light to the wrong side of its own surface.
    const double side = exact::dot(direction, outer);
    if (crosses ? side < 0.0 : side > 0.0)
      pending.push_back(onward);
    else
      account.cut += onward.flux;
  };
  if (optics.role == Role::Mirror) {
    next.flux = moving.flux * metal(optics.color, f.cosine);
    account.absorbed += moving.flux - next.flux;
    return send(next, reflected(d, f.normal), false);
  }
  const int within = moving.media.find(optics.body);
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
  if (met.front) {
    n2 = absolute_index(optics.index(bend), n1);
    through.media.enter({optics.body, met.mesh, n2});
  } else if (within >= 0) {
    n2 = through.media.index();
  } else {  // the light began inside
    n1 = absolute_index(optics.index(bend), n2);
  }
  const auto bent = refract_direction(d, f.normal, n1 / n2);
  const double r = bent ? fresnel(f.cosine, n1, n2).mean() : 1.0;
  // The tint counts once for each body, as light gets in; or out, where it began inside.
  const glm::dvec3 tint = met.front || within < 0 ? optics.color : glm::dvec3(1.0);
  const double weaker = std::min(r, 1.0 - r) * largest(moving.flux);
  const bool both = weaker > kSplitShare * moving.first && next.surfaces <= kSplits;
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
