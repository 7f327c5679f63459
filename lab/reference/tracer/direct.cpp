#include "lab/reference/tracer/direct.hpp"

#include <algorithm>
#include <cmath>

#include "lab/reference/closed_forms.hpp"
#include "lab/reference/tracer/emission.hpp"
#include "pipeline/scene/exact.hpp"
#include "pipeline/scene/in_pieces.hpp"
#include "pipeline/scene/material_optics.hpp"

namespace caustics::tracer {

namespace {

// One light as the shadow rays need it.
class Lamp {
 public:
  Lamp(const World& world, int source)
      : world_(world),
        lit_(world.lit_by(source)),
        light_(world.scene().sources[static_cast<std::size_t>(source)]),
        points_(world.scene(), light_),
        falloff_(light_),
        casters_shadow_(world.throws_caustic(source)),
        color_(glm::dvec3(light_.color) * static_cast<double>(light_.intensity)) {}

  glm::dvec3 at(const Seen& seen, std::uint64_t pixel) const {
    if (!points_.has_size()) return color_ * from(seen, points_.point(0.5, 0.5, 0.5));
    Numbers numbers(0x5ad0e5, pixel);
    glm::dvec3 sum(0.0);
    for (int i = 0; i < kShadowRays * kShadowRays; ++i) {
      const int column = i % kShadowRays, row = i / kShadowRays;
      const double u = (column + numbers.next()) / kShadowRays;
      const double v = (row + numbers.next()) / kShadowRays;
      sum += from(seen, points_.point(u, v, numbers.next()));
    }
    return color_ * sum / static_cast<double>(kShadowRays * kShadowRays);
  }

 private:
  // Relative to the intensity.
  glm::dvec3 from(const Seen& seen, const LightPoint& point) const {
    const bool directional = light_.type == LightType::Directional;
    const glm::dvec3 way = seen.position - point.position;
    const double distance = directional ? world_.size() * 1.01 : exact::length(way);
    if (!(distance > 0.0)) return glm::dvec3(0.0);
    const glm::dvec3 travel = directional ? point.direction : way / distance;
    const double facing = -exact::dot(seen.normal, travel);
    if (!(facing > 0.0) || !(exact::dot(seen.plane, travel) < 0.0)) return glm::dvec3(0.0);
    double reaching = facing;
    if (!directional) {
      const double s = distance / static_cast<double>(light_.range);
      reaching *= falloff_.at(travel, point.direction) / (distance * distance) *
                  std::clamp(1.0 - (s * s) * (s * s), 0.0, 1.0);
    }
    if (!(reaching > 0.0)) return glm::dvec3(0.0);
    const Ray back{seen.position, -travel};
    if (lit_.receivers.blocked(back, world_.nearest(), distance)) return glm::dvec3(0.0);
    if (casters_shadow_ && lit_.casters.blocked(back, world_.nearest(), distance)) return glm::dvec3(0.0);
    return reaching * world_.through_panes(back, distance) * world_.through_air(back, distance);
  }

  const World& world_;
  const LitSet& lit_;
  const Light& light_;
  LightShapePoints points_;
  Falloff falloff_;
  bool casters_shadow_;
  glm::dvec3 color_;
};

}  // namespace

std::vector<float> direct_light(const World& world, const Film& film, int threads) {
  std::vector<Lamp> lamps;
  lamps.reserve(world.scene().sources.size());
  for (int i = 0; i < static_cast<int>(world.scene().sources.size()); ++i) lamps.emplace_back(world, i);
  std::vector<float> result(3 * film.pixels());
  const auto width = static_cast<std::size_t>(film.width());
  in_pieces(film.height(), threads, [&](int row) {
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t pixel = static_cast<std::size_t>(row) * width + x;
      const Seen& seen = film.seen(pixel);
      if (seen.mesh < 0 || seen.caster) continue;
      glm::dvec3 sum(0.0);
      for (const Lamp& lamp : lamps) sum += lamp.at(seen, pixel);
      for (int c = 0; c < 3; ++c)
        result[3 * pixel + static_cast<std::size_t>(c)] = static_cast<float>(sum[c]);
    }
  });
  return result;
}

}  // namespace caustics::tracer
