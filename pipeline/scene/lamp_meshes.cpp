#include "pipeline/scene/lamp_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "pipeline/scene/defaults.hpp"
#include "pipeline/scene/emitter.hpp"
#include "pipeline/scene/environment.hpp"
#include "pipeline/scene/exact.hpp"
#include "pipeline/scene/low_discrepancy.hpp"
#include "pipeline/scene/triangle_tree.hpp"

namespace caustics {

namespace {

constexpr double kAdds = 0.1, kOnSurfaces = 0.05;         // of the other light; of the surfaces
constexpr double kNeedsNoSun = 0.005, kFillsSky = 0.005;  // of a sun's lux; of a hemisphere
constexpr double kQuarter = 0.25;                         // of a sun's lux; of the surfaces
constexpr double kStudio = 0.3;                           // of the lights, from all around (add_sky)
constexpr std::size_t kMostLamps = 16, kMostJudged = 64;
constexpr std::size_t kMostShadowed = 64;     // lights of the file whose shadows are looked at
constexpr int kChords = 512, kMostHits = 4;   // through the surroundings; on each
constexpr int kPoints = 4, kDirections = 32;  // of a lamp, to places; to find its surroundings
constexpr double kWide = 0.05;                // a lamp's radius over its distance

double luminance(const glm::vec3& color) {
  return (0.2126 * static_cast<double>(color.x) + 0.7152 * static_cast<double>(color.y)) +
         0.0722 * static_cast<double>(color.z);
}

double candela(const Light& light) { return luminance(light.color) * static_cast<double>(light.intensity); }

// A point on a surface, either side of which may be lit.
struct Place {
  glm::dvec3 position{0.0}, normal{0.0};
  TriangleId on;
};

struct LampCandidate {
  Light light;
  std::vector<SurfacePoint> points;
  double radius_squared;      // of the disk that a point stands for
  std::vector<double> lux{};  // by place
};

std::vector<int> shadowing_meshes(const Scene& scene) {
  std::vector<int> meshes;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const Material& material = scene.materials[static_cast<std::size_t>(scene.meshes[i].material)];
    if (!(material.transmission > 0.0f) && material.alpha_mode != AlphaMode::Blend)
      meshes.push_back(static_cast<int>(i));
  }
  return meshes;
}

Bounds bounds_of_casters(const Scene& scene) {
  Bounds all;
  for (const Mesh& mesh : scene.meshes)
    if (!is_receiver(scene.materials[static_cast<std::size_t>(mesh.material)])) all.add(bounds_of(mesh));
  return all;
}

bool holds(const Bounds& box, const glm::dvec3& p) {
  return glm::min(box.lower, p) == box.lower && glm::max(box.upper, p) == box.upper;
}

class LampJudge {
 public:
  LampJudge(const Scene& scene, double sun_lux)
      : scene_(scene), sun_lux_(sun_lux), tree_(scene, shadowing_meshes(scene)), subject_(subject_of(scene)) {
    find_candidates();
    if (candidates_.empty()) return;
    find_places();
    for (LampCandidate& each : candidates_)
      for (const Place& place : places_) each.lux.push_back(lux_at(each, place));
  }

  Lamps judge(int samples) {
    if (candidates_.empty()) return {};
    std::vector<double> together(places_.size(), 0.0);
    for (const LampCandidate& each : candidates_)
      for (std::size_t p = 0; p < places_.size(); ++p) together[p] += each.lux[p];
    result_.instead_of_sun = scene_.lights.empty() && lights_enough(reached_on(together, kQuarter));
    std::vector<double> given(places_.size(), 0.0);
    if (!result_.instead_of_sun)
      for (std::size_t p = 0; p < places_.size(); ++p) given[p] = other_light(places_[p]);
    for (LampCandidate& each : candidates_) {
      std::size_t adds = 0;
      for (std::size_t p = 0; p < places_.size(); ++p) {
        const double others = result_.instead_of_sun ? together[p] - each.lux[p] : given[p];
        adds += each.lux[p] > 0.0 && each.lux[p] >= kAdds * others ? 1 : 0;
      }
      if (static_cast<double>(adds) < kOnSurfaces * static_cast<double>(places_.size()) || adds == 0)
        leave_out(each, "it adds less than a tenth to the other light on nearly all surfaces around it");
      else if (result_.lights.size() == kMostLamps)
        leave_out(each, "only the 16 strongest meshes are made lights");
      else
        result_.lights.push_back(std::move(each.light));
    }
    share_out(samples);
    return std::move(result_);
  }

 private:
  void leave_out(const LampCandidate& candidate, const char* why) {
    result_.dim.push_back({candidate.light.emitter, why});
  }

  // The strongest first.
  void find_candidates() {
    std::vector<Light> lights;
    for (int i = 0; i < static_cast<int>(scene_.meshes.size()); ++i)
      if (shines(scene_, scene_.meshes[static_cast<std::size_t>(i)]))
        lights.push_back(light_of_mesh(scene_, i));
    std::stable_sort(lights.begin(), lights.end(),
                     [](const Light& a, const Light& b) { return candela(a) > candela(b); });
    for (const Light& light : lights) {
      const Emitter emitter(scene_, light.emitter);
      if (!(candela(light) > 0.0))
        result_.dim.push_back({light.emitter, "its texture is black where the mesh shows it"});
      else if (candidates_.size() == kMostJudged)
        result_.dim.push_back({light.emitter, "64 meshes shine more strongly"});
      else
        candidates_.push_back({light, emitter.spread(kPoints), emitter.area() / (kPoints * exact::kPi)});
    }
  }

  // How far half of a lamp's light goes at most.
  double median_way(const LampCandidate& lamp) const {
    std::vector<double> ways;
    for (int k = 0; k < kDirections; ++k) {
      const SurfacePoint& from = lamp.points[static_cast<std::size_t>(k % kPoints)];
      const double up = std::sqrt(stratum(k, kDirections)), level = std::sqrt(1.0 - up * up);
      double sine, cosine;
      exact::sin_cos(2.0 * exact::kPi * stepped(k, kGoldenStep), sine, cosine);
      const glm::dvec3 x = exact::perpendicular(from.normal), y = exact::cross(from.normal, x);
      const auto hit = tree_.nearest(from.position, from.normal * up + (x * cosine + y * sine) * level, {},
                                     lamp.light.emitter);
      if (hit) ways.push_back(hit->distance);
    }
    if (ways.empty()) return 0.0;
    std::sort(ways.begin(), ways.end());
    return ways[ways.size() / 2];
  }

  // Spread evenly over all surfaces near the subject and the lamps: where chords through a sphere around them
  // meet these (Crofton's formula).
  void find_places() {
    const Bounds all = bounds_of(scene_);
    const glm::dvec3 centre = subject_.centre();
    double radius = 0.0;
    for (const LampCandidate& each : candidates_) {
      const double distance = exact::length(each.light.position - centre);
      radius = std::max({radius, distance + 3.0 * subject_.radius(), distance + 2.0 * median_way(each)});
    }
    radius = std::min(radius, exact::length(all.centre() - centre) + all.radius());
    for (int k = 0; k < kChords; ++k) follow_chord(centre, 1.001 * radius, k);
  }

  void follow_chord(const glm::dvec3& centre, double radius, int k) {
    const double down = 1.0 - 2.0 * stratum(k, kChords), level = std::sqrt(std::max(1.0 - down * down, 0.0));
    double sine, cosine;
    exact::sin_cos(2.0 * exact::kPi * stepped(k, kGoldenStep), sine, cosine);
    const glm::dvec3 way(level * cosine, down, level * sine);
    const glm::dvec3 x = exact::perpendicular(way), y = exact::cross(way, x);
    const double squared = stepped(k, kPairStep1), half = radius * std::sqrt(1.0 - squared);
    exact::sin_cos(2.0 * exact::kPi * stepped(k, kPairStep2), sine, cosine);
    glm::dvec3 from = centre + (x * cosine + y * sine) * (radius * std::sqrt(squared)) - way * half;
    double left = 2.0 * half;
    TriangleId on;
    for (int hits = 0; hits < kMostHits; ++hits) {
      const auto hit = tree_.nearest(from, way, on);
      if (!hit || hit->distance > left) return;
      left -= hit->distance;
      on = hit->id;
      from = position_of(scene_, *hit);
      places_.push_back({from, plane_normal(scene_, on), on});
    }
  }

  bool sees(const Place& place, const glm::dvec3& direction, double distance, int without) const {
    const auto hit = tree_.nearest(place.position, direction, place.on, without);
    return !hit || hit->distance >= distance * (1.0 - 1e-6);
  }

  double lux_at(const LampCandidate& lamp, const Place& place) const {
    if (place.on.mesh == lamp.light.emitter) return 0.0;
    double sum = 0.0;
    for (const SurfacePoint& from : lamp.points) {
      const glm::dvec3 path = place.position - from.position;
      const double distance = exact::length(path);
      if (!(distance > 0.0)) continue;
      const double leaving = exact::dot(path, from.normal) / distance;
      const double arriving = std::fabs(exact::dot(path, place.normal)) / distance;
      if (!(leaving * arriving > 0.0) || leaving < 0.0) continue;
      if (!sees(place, -path / distance, distance, lamp.light.emitter)) continue;
      sum += candela(lamp.light) / kPoints * leaving * arriving / (distance * distance + lamp.radius_squared);
    }
    return sum;
  }

  double other_light(const Place& place) const {
    const bool added = scene_.lights.empty();  // a sun will be, whose place is not known yet
    double lights = added ? sun_lux_ : 0.0, all = lights;
    for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
      const Light& light = scene_.lights[i];
      const bool directional = light.type == LightType::Directional;
      const glm::dvec3 path = directional ? light.direction : place.position - light.position;
      const double distance = directional ? 1.0 : exact::length(path);
      if (!(distance > 0.0)) continue;
      const glm::dvec3 travel = path / distance;
      double sine, outer = -1.0;
      if (light.type == LightType::Spot) exact::sin_cos(static_cast<double>(light.outer_cone), sine, outer);
      if (!directional && exact::dot(travel, light.direction) < outer) continue;
      const double arrives =
          candela(light) * std::fabs(exact::dot(travel, place.normal)) / (distance * distance);
      all += arrives;
      const double far = directional ? 1e30 : distance;
      if (i >= kMostShadowed || sees(place, -travel, far, -1)) lights += arrives;
    }
    const Environment& around = scene_.environment;
    return lights + (around.image ? upward_irradiance(around) : kStudio * all);
  }

  // As much as a weak sun, or as what fills a good part of the sky of that place.
  bool lights_enough(double lux) const {
    double brightest = 0.0;  // nit, before any texture
    for (const LampCandidate& each : candidates_) {
      const Mesh& mesh = scene_.meshes[static_cast<std::size_t>(each.light.emitter)];
      brightest =
          std::max(brightest, luminance(scene_.materials[static_cast<std::size_t>(mesh.material)].emissive));
    }
    return lux > 0.0 && lux >= std::min(kNeedsNoSun * sun_lux_, kFillsSky * exact::kPi * brightest);
  }

  // What as large a share of the places has at least.
  static double reached_on(std::vector<double> lux, double share) {
    if (lux.empty()) return 0.0;
    std::sort(lux.begin(), lux.end(), [](double a, double b) { return a > b; });
    return lux[static_cast<std::size_t>(share * static_cast<double>(lux.size()))];
  }

  void share_out(int samples) {
    const Bounds casters = bounds_of_casters(scene_);
    double all = 0.0;
    bool wide = false, among = false;
    for (const Light& light : result_.lights) {
      all += candela(light);
      const Bounds bounds = bounds_of(scene_.meshes[static_cast<std::size_t>(light.emitter)]);
      wide = wide || bounds.radius() > kWide * exact::length(light.position - subject_.centre());
      among = among || holds(casters, light.position);
    }
    const double share = casters.empty() ? 1.0 : !wide ? 0.25 : among ? 0.5 : 1.0;
    for (Light& light : result_.lights) {
      // All samples of a ball shine to every side.
      const bool half = !light.is_ball() && Emitter(scene_, light.emitter).shines_all_around();
      const double both = half ? 2.0 : 1.0;
      const double own = both * share * samples * candela(light) / all;
      light.samples = std::max(static_cast<int>(std::lround(own)), 1);
    }
  }

  const Scene& scene_;
  double sun_lux_;
  TriangleTree tree_;
  Bounds subject_;
  std::vector<LampCandidate> candidates_;
  std::vector<Place> places_;
  Lamps result_;
};

}  // namespace

Lamps choose_lamps(const Scene& scene, double sun_lux, int samples) {
  const bool any = std::any_of(scene.meshes.begin(), scene.meshes.end(),
                               [&](const Mesh& mesh) { return shines(scene, mesh); });
  if (!any) return {};
  return LampJudge(scene, sun_lux).judge(samples);
}

}  // namespace caustics
