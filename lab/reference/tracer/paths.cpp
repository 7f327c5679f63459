#include "lab/reference/tracer/paths.hpp"

#include <algorithm>
#include <limits>

#include "lab/reference/tracer/paths_common.hpp"

namespace caustics::tracer {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
// Surfaces of other bodies, or entered ones, that light inside a body passes by before its way out.
constexpr int kMostPassed = 256;

}  // namespace

void Account::add(const Account& other) {
  entered += other.entered;
  landed += other.landed;
  fresnel += other.fresnel;
  absorbed += other.absorbed;
  total_reflection += other.total_reflection;
  missed += other.missed;
  lost += other.lost;
  cut += other.cut;
  rays += other.rays;
  hits += other.hits;
  landings += other.landings;
}

glm::dvec3 Account::gap() const {
  return entered - (landed + fresnel + absorbed + total_reflection + missed + lost + cut);
}

Paths::Paths(const World& world, int source, Physics physics)
    : world_(world),
      lit_(world.lit_by(source)),
      behind_casters_(physics == Physics::Full ? world.receivers() : lit_.receivers),
      physics_(physics) {
  for (const Branch& branch : world.effects().branches) {
    if (branch.reflected) {
      reflections_ = true;
      continue;
    }
    white_ += glm::dvec3(branch.color);
    // Ways through rough glass are the passes' affair: here each ray draws its own.
    const auto alike =
        std::find_if(ways_.begin(), ways_.end(), [&](const Way& way) { return way.bend == branch.bend; });
    if (alike == ways_.end())
      ways_.push_back({branch.bend, glm::dvec3(branch.color)});
    else
      alike->share += glm::dvec3(branch.color);
  }
  dispersion_ = ways_.size() > 1;
}

void Paths::follow(const LightRay& light, Numbers& numbers, std::vector<Landing>& landings,
                   Account& account) const {
  account.rays += 1.0;
  if (!(light.flux > 0.0)) return;
  const auto hit = lit_.casters.nearest(light.ray, 0.0, kFar);
  if (!hit) return;
  // A receiver before the caster keeps its light away; panes and blended surfaces take their share.
  if (lit_.receivers.blocked(light.ray, 0.0, hit->distance - world_.nearest())) return;
  account.hits += 1.0;
  const glm::dvec3 reaching = world_.through_panes(light.ray, hit->distance) * light.flux;
  const Arrival arrival{light.ray, *hit, reaching * world_.through_air(light.ray, hit->distance)};
  account.entered += white_ * arrival.flux;
  const Optics& optics = world_.optics(hit->mesh);
  const std::size_t before = landings.size();
  if (physics_ == Physics::Full) {
    if (!dispersion_)
      full(arrival, {0.0, white_}, numbers, landings, account);
    else
      for (const Way& way : ways_) full(arrival, way, numbers, landings, account);
  } else if (optics.role == Role::Mirror) {
    mirrored(arrival, landings, account);
  } else {
    // Colours part where the glass disperses only.
    if (optics.spread == 0.0)
      single(arrival, {0.0, white_}, landings, account);
    else
      for (const Way& way : ways_) single(arrival, way, landings, account);
    if (reflections_ && hit->front) off_dielectric(arrival, landings, account);
  }
  account.landings += static_cast<double>(landings.size() - before);
}

// Metal, from either side. A mirror does not see itself, nor other casters.
void Paths::mirrored(const Arrival& arrival, std::vector<Landing>& landings, Account& account) const {
  const Facing f = facing(arrival.hit, arrival.ray.direction);
  const glm::dvec3 all = white_ * arrival.flux;
  const glm::dvec3 kept = all * metal(world_.optics_at(arrival.hit).color, f.cosine);
  account.absorbed += all - kept;
  land({arrival.hit.position, reflected(arrival.ray.direction, f.normal)}, false, kept, nullptr, landings,
       account);
}

// What glass mirrors at its outer side, where the effect is on. It was booked as Fresnel's.
void Paths::off_dielectric(const Arrival& arrival, std::vector<Landing>& landings, Account& account) const {
  const Facing f = facing(arrival.hit, arrival.ray.direction);
  const double ior = world_.optics(arrival.hit.mesh).index(0.0);
  if (!refract_direction(arrival.ray.direction, f.normal, 1.0 / ior)) return;  // total, booked as such
  const glm::dvec3 flux = white_ * (arrival.flux * fresnel(f.cosine, 1.0, ior).mean());
  account.fresnel -= flux;
  land({arrival.hit.position, reflected(arrival.ray.direction, f.normal)}, false, flux, nullptr, landings,
       account);
}

void Paths::single(const Arrival& arrival, const Way& way, std::vector<Landing>& landings,
                   Account& account) const {
  const SurfaceHit& hit = arrival.hit;
  const Optics optics = world_.optics_at(hit);
  const Facing f = facing(hit, arrival.ray.direction);
  const double ior = optics.index(way.bend);
  const double n1 = hit.front ? 1.0 : ior, n2 = hit.front ? ior : 1.0;
  const glm::dvec3 all = way.share * arrival.flux;
  const auto bent = refract_direction(arrival.ray.direction, f.normal, n1 / n2);
  if (!bent) {
    account.total_reflection += all;
    return;
  }
  const double r = fresnel(f.cosine, n1, n2).mean();
  account.fresnel += all * r;
  const glm::dvec3 passed = all * (1.0 - r) * optics.color;
  account.absorbed += all * (1.0 - r) - passed;
  if (optics.solid && hit.front) return through_body(arrival, way, *bent, passed, landings, account);
  // Through one interface only, the medium reaches down to the receiver (water on its bed).
  land({hit.position, *bent}, true, passed, hit.front ? &optics : nullptr, landings, account);
}

void Paths::through_body(const Arrival& arrival, const Way& way, const glm::dvec3& inside,
                         const glm::dvec3& flux, std::vector<Landing>& landings, Account& account) const {
  const Optics& optics = world_.optics(arrival.hit.mesh);
  const Ray ray{arrival.hit.position, inside};
  const auto exit = way_out(ray, optics.body);
  const double until = exit ? exit->distance - world_.nearest() : kFar;
  // A diffuse thing within the glass, or that the glass is sunk into.
  if (auto within = behind_casters_.nearest(ray, world_.nearest(), until)) {
    const glm::dvec3 left = flux * after(optics.absorption, within->distance);
    account.absorbed += flux - left;
    account.landed += left;
    landings.push_back({*within, inside, left});
    return;
  }
  if (!exit) {
    account.lost += flux;
    return;
  }
  const glm::dvec3 left = flux * after(optics.absorption, exit->distance);
  account.absorbed += flux - left;
  const double ior = optics.index(way.bend);
  const Facing f = facing(*exit, inside);
  const auto bent = refract_direction(inside, f.normal, ior);
  if (!bent) {
    account.total_reflection += left;
    return;
  }
  const double r = fresnel(f.cosine, ior, 1.0).mean();
  account.fresnel += left * r;
  land({exit->position, *bent}, true, left * (1.0 - r), nullptr, landings, account);
}

// The first surface of this body that the ray meets from within.
std::optional<SurfaceHit> Paths::way_out(const Ray& inside, int body) const {
  double from = 0.0;
  for (int passed = 0; passed < kMostPassed; ++passed) {
    auto hit = lit_.casters.nearest(inside, from, kFar);
    if (!hit) return std::nullopt;
    if (!hit->front && world_.optics(hit->mesh).body == body) {
      hit->distance = std::max(hit->distance, 0.0);
      return hit;
    }
    from = std::max(hit->distance, from) * (1.0 + 1e-6) + 0.1 * world_.nearest();
  }
  return std::nullopt;
}

// The first receiver ahead. Light that crossed a surface may start on a receiver that touches it; light that
// was mirrored may not.
std::optional<SurfaceHit> Paths::receiver_on(const Ray& ray, bool crossed) const {
  const double back = crossed ? world_.nearest() : 0.0;
  auto hit = behind_casters_.nearest({ray.at(-back), ray.direction}, crossed ? 0.0 : world_.nearest(), kFar);
  if (hit) hit->distance = std::max(hit->distance - back, 0.0);
  return hit;
}

// `medium`: what fills the way to the landing, if anything.
void Paths::land(const Ray& ray, bool crossed, const glm::dvec3& flux, const Optics* medium,
                 std::vector<Landing>& landings, Account& account) const {
  const auto hit = receiver_on(ray, crossed);
  if (!hit) {
    account.missed += flux;
    return;
  }
  const glm::dvec3 left =
      flux * (medium ? after(medium->absorption, hit->distance) : world_.through_air(ray, hit->distance));
  account.absorbed += flux - left;
  account.landed += left;
  landings.push_back({*hit, ray.direction, left});
}

}  // namespace caustics::tracer
