#include "pipeline/measure/light_groups.hpp"

#include <algorithm>
#include <limits>

#include "pipeline/gpu/interrupt.hpp"
#include "pipeline/scene/exact.hpp"

namespace caustics {

namespace {

// No light that is chosen is as far from those for which its caustic stands; those of another kind are
// farther.
constexpr double kFar = 1.0, kOfAnotherKind = 4.0;

// A source of light that throws caustics.
struct DrawnSource {
  int number = 0;             // by Scene::sources
  const Light* light;         // its first sample
  double to_casters = 1.0;    // metres to the nearest caster
  double on_casters = 0.0;    // LightShare::on_casters
  glm::dvec3 intensity{0.0};  // of all its samples
  int samples = 0;
};

double brightest(const glm::dvec3& color) { return std::max({color.x, color.y, color.z}); }

// To the nearest box around a caster; at least a tenth of the box's radius.
double to_nearest_caster(const Scene& scene, const Effects& effects, const Light& light) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
    if (!is_caster(effects.surfaces[m].role)) continue;
    const glm::dvec3 lower(scene.meshes[m].lower), upper(scene.meshes[m].upper);
    const glm::dvec3 off = light.position - glm::clamp(light.position, lower, upper);
    nearest = std::min(nearest, std::max(exact::length(off), 0.05 * exact::length(upper - lower)));
  }
  return std::max(nearest, 1e-15);
}

std::vector<DrawnSource> sources_of(const Scene& scene, const Effects& effects,
                                    const std::vector<LightShare>& shares) {
  std::vector<DrawnSource> found(shares.size());
  for (std::size_t l = 0; l < scene.lights.size(); ++l) {
    const Light& light = scene.lights[l];
    DrawnSource& source = found[light.source < 0 ? l : static_cast<std::size_t>(light.source)];
    if (source.samples++ == 0) source.light = &light;
    source.intensity += glm::dvec3(light.color) * static_cast<double>(light.intensity);
  }
  std::vector<DrawnSource> drawn;
  for (std::size_t s = 0; s < shares.size(); ++s) {
    if (shares[s].left_out || !(shares[s].on_casters > 0.0) || !(brightest(found[s].intensity) > 0.0))
      continue;
    drawn.push_back(found[s]);
    drawn.back().number = static_cast<int>(s);
    drawn.back().on_casters = shares[s].on_casters;
    drawn.back().to_casters = to_nearest_caster(scene, effects, *found[s].light);
  }
  return drawn;
}

double distance(const DrawnSource& a, const DrawnSource& b) {
  const Light &one = *a.light, &other = *b.light;
  if (one.type != other.type || one.lambertian != other.lambertian) return kOfAnotherKind;
  const double turned =
      one.type == LightType::Point && !one.lambertian ? 0.0 : exact::length(one.direction - other.direction);
  if (one.type == LightType::Directional) return turned;
  return turned + exact::length(one.position - other.position) / std::min(a.to_casters, b.to_casters);
}

// Indices of those that are chosen, and for each source the nearest of them.
struct Groups {
  std::vector<std::size_t> chosen;
  std::vector<std::size_t> of;  // index into chosen
};

Groups farthest_apart(const std::vector<DrawnSource>& sources, std::size_t most) {
  Groups groups{{}, std::vector<std::size_t>(sources.size(), 0)};
  std::vector<double> nearest(sources.size(), kOfAnotherKind);
  for (;;) {
    stop_if_interrupted();
    const bool enough = groups.chosen.size() >= most;
    std::size_t next = 0;
    double largest = 0.0;
    for (std::size_t i = 0; i < sources.size(); ++i)
      if (const double gain = sources[i].on_casters * nearest[i] * nearest[i];
          gain > largest && !(enough && nearest[i] < kFar)) {
        largest = gain;
        next = i;
      }
    if (!(largest > 0.0)) break;
    for (std::size_t i = 0; i < sources.size(); ++i)
      if (const double away = distance(sources[i], sources[next]);
          groups.chosen.empty() || away < nearest[i]) {
        nearest[i] = away;
        groups.of[i] = groups.chosen.size();
      }
    groups.chosen.push_back(next);
  }
  return groups;
}

// Chooses in each group the source to which all of it is nearest.
void choose_middles(const std::vector<DrawnSource>& sources, Groups& groups) {
  std::vector<std::vector<std::size_t>> members(groups.chosen.size());
  for (std::size_t i = 0; i < sources.size(); ++i) members[groups.of[i]].push_back(i);
  for (std::size_t g = 0; g < members.size(); ++g) {
    stop_if_interrupted();
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t middle : members[g]) {
      double sum = 0.0;
      for (const std::size_t other : members[g]) {
        const double away = distance(sources[middle], sources[other]);
        sum += sources[other].on_casters * away * away;
      }
      if (sum < least) {
        least = sum;
        groups.chosen[g] = middle;
      }
    }
  }
}

// The light that reaches the casters for each lux or candela.
double reach(const DrawnSource& source) { return source.on_casters / brightest(source.intensity); }

}  // namespace

void group_lights(const Scene& scene, const Effects& effects, int most, std::vector<LightShare>& shares) {
  if (most <= 0 || shares.size() <= static_cast<std::size_t>(most)) return;
  const std::vector<DrawnSource> sources = sources_of(scene, effects, shares);
  if (sources.size() <= static_cast<std::size_t>(most)) return;
  Groups groups = farthest_apart(sources, static_cast<std::size_t>(most));
  choose_middles(sources, groups);
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const DrawnSource& middle = sources[groups.chosen[groups.of[i]]];
    if (middle.number == sources[i].number) continue;
    LightShare &own = shares[static_cast<std::size_t>(sources[i].number)],
               &other = shares[static_cast<std::size_t>(middle.number)];
    own.drawn_with = middle.number;
    other.of_others += glm::vec3(sources[i].intensity *
                                 (reach(sources[i]) / reach(middle) / static_cast<double>(middle.samples)));
    other.share += own.share;
  }
}

}  // namespace caustics
