#include "lab/reference/tracer/emission.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/scene/exact.hpp"

namespace caustics::tracer {

namespace {

constexpr double kTwoPi = 2.0 * exact::kPi;
// A window wider than this many times its distance to one side gives way to all directions.
constexpr double kWidest = 4.0;
// Silhouettes are not cut by rounding.
constexpr double kMargin = 1e-6;

}  // namespace

Falloff::Falloff(const Light& light) {
  if (light.lambertian || light.shape == LightShape::Mesh) kind_ = Kind::Lambert;
  if (light.type != LightType::Spot) return;
  kind_ = Kind::Cone;
  double sine, outer, inner;
  exact::sin_cos(static_cast<double>(light.outer_cone), sine, outer);
  exact::sin_cos(static_cast<double>(light.inner_cone), sine, inner);
  // Equal cones have an edge a thousandth as wide as the cone.
  scale_ = 1.0 / std::max({inner - outer, 1e-3 * (1.0 - outer), 1e-30});
  offset_ = -outer * scale_;
}

double Falloff::at(const glm::dvec3& direction, const glm::dvec3& axis) const {
  if (kind_ == Kind::Even) return 1.0;
  const double cosine = exact::dot(direction, axis);
  if (kind_ == Kind::Lambert) return std::clamp(cosine, 0.0, 1.0);
  const double ramp = std::clamp(cosine * scale_ + offset_, 0.0, 1.0);
  return ramp * ramp;
}

LightShapePoints::LightShapePoints(const Scene& scene, const Light& light) : scene_(scene), light_(light) {
  if (light.shape != LightShape::Mesh) return;
  const Mesh& mesh = scene.meshes[static_cast<std::size_t>(light.emitter)];
  const bool both = scene.materials[static_cast<std::size_t>(mesh.material)].double_sided && !mesh.closed();
  const std::size_t triangles = mesh.indices.size() / 3;
  double sum = 0.0;
  for (std::size_t i = 0; i < (both ? 2 : 1) * triangles; ++i) {
    const auto at = [&](std::size_t corner) {
      return glm::dvec3(mesh.vertices[mesh.indices[3 * (i % triangles) + corner]].position);
    };
    sum += 0.5 * exact::length(exact::cross(at(1) - at(0), at(2) - at(0)));
    areas_.push_back(sum);
  }
}

LightPoint LightShapePoints::on_mesh(double u, double v, double w) const {
  const Mesh& mesh = scene_.meshes[static_cast<std::size_t>(light_.emitter)];
  const std::size_t triangles = mesh.indices.size() / 3;
  const auto found = std::upper_bound(areas_.begin(), areas_.end(), u * areas_.back());
  const std::size_t side = std::min(static_cast<std::size_t>(found - areas_.begin()), areas_.size() - 1);
  const auto at = [&](std::size_t corner) {
    return glm::dvec3(mesh.vertices[mesh.indices[3 * (side % triangles) + corner]].position);
  };
  if (v + w > 1.0) {
    v = 1.0 - v;
    w = 1.0 - w;
  }
  const glm::dvec3 ab = at(1) - at(0), ac = at(2) - at(0);
  const glm::dvec3 out = exact::normalise(exact::cross(ab, ac), {0.0, -1.0, 0.0});
  return {at(0) + ab * v + ac * w, side < triangles ? out : -out};
}

LightPoint LightShapePoints::point(double u, double v, double w) const {
  LightPoint p{light_.position, light_.direction};
  double sine, cosine;
  switch (light_.shape) {
    case LightShape::None:
      break;
    case LightShape::Sphere: {
      double third, unused;
      exact::sin_cos(kTwoPi * v, sine, cosine);
      exact::sin_cos(kTwoPi * w, third, unused);
      const double a = std::sqrt(u) * light_.radius, b = std::sqrt(1.0 - u) * light_.radius;
      p.position += glm::dvec3(a * cosine, a * sine, b * third);
      break;
    }
    case LightShape::Rectangle:
      p.position += (u - 0.5) * light_.width + (v - 0.5) * light_.height;
      break;
    case LightShape::Disk: {
      exact::sin_cos(0.5 * light_.angular_radius, sine, cosine);
      const double down = 2.0 * sine * sine * u;
      const double across = std::sqrt(std::max(down * (2.0 - down), 0.0));
      exact::sin_cos(kTwoPi * v, sine, cosine);
      const glm::dvec3 x = exact::perpendicular(light_.direction);
      const glm::dvec3 y = exact::cross(light_.direction, x);
      p.direction = exact::normalise(
          light_.direction * (1.0 - down) + (x * (across * cosine) + y * (across * sine)), light_.direction);
      break;
    }
    case LightShape::Mesh:
      return on_mesh(u, v, w);
  }
  return p;
}

Emission::Emission(const World& world, int source)
    : world_(world),
      light_(world.scene().sources[static_cast<std::size_t>(source)]),
      shape_(world.scene(), light_),
      falloff_(light_) {
  const LitSet& lit = world.lit_by(source);
  const Bounds& box = lit.caster_bounds;
  centre_ = box.centre();
  for (int i = 0; i < 8; ++i)
    corners_.emplace_back(i & 1 ? box.upper.x : box.lower.x, i & 2 ? box.upper.y : box.lower.y,
                          i & 4 ? box.upper.z : box.lower.z);
  if (shape_.has_size()) return;
  std::vector<glm::dvec3> vertices;
  // An exact shape bulges beyond its mesh.
  if (!world.exact().empty()) vertices = corners_;
  for (const int m : lit.caster_meshes)
    for (const Vertex& v : world.scene().meshes[static_cast<std::size_t>(m)].vertices)
      vertices.emplace_back(v.position);
  fixed_ = window_of(shape_.point(0.5, 0.5, 0.5), vertices);
}

Emission::Window Emission::window_of(const LightPoint& point, const std::vector<glm::dvec3>& around) const {
  Window window;
  const bool parallel = light_.type == LightType::Directional;
  const glm::dvec3 towards = exact::normalise(centre_ - point.position, point.direction);
  window.view = parallel ? view_along(centre_, point.direction) : view_along(point.position, towards);
  window.lower = glm::dvec2(std::numeric_limits<double>::infinity());
  window.upper = -window.lower;
  for (const glm::dvec3& p : around) {
    const glm::dvec3 c = window.view.coordinates(p);
    const double across = std::max(std::fabs(c.x), std::fabs(c.y));
    window.all_around = !parallel && !(c.z > 0.0 && across <= kWidest * c.z);
    if (window.all_around) return window;
    const glm::dvec2 q = parallel ? glm::dvec2(c.x, c.y) : glm::dvec2(c.x, c.y) / c.z;
    window.lower = glm::min(window.lower, q);
    window.upper = glm::max(window.upper, q);
  }
  const glm::dvec2 margin = kMargin * (window.upper - window.lower);
  window.lower -= margin;
  window.upper += margin;
  return window;
}

LightRay Emission::parallel(const Window& window, double u, double v) const {
  const glm::dvec2 size = window.upper - window.lower;
  const glm::dvec2 q = window.lower + size * glm::dvec2(u, v);
  const View& f = window.view;
  LightRay light;
  // From before everything, but no farther, for the ray queries' sake.
  light.ray.origin = f.origin + f.right * q.x + f.up * q.y - f.forward * (1.01 * world_.size());
  light.ray.direction = f.forward;
  light.flux = size.x * size.y;
  return light;
}

LightRay Emission::from_point(const Window& window, const LightPoint& point, double u, double v) const {
  LightRay light;
  light.ray.origin = point.position;
  if (window.all_around) {
    double sine, cosine;
    exact::sin_cos(kTwoPi * u, sine, cosine);
    const double z = 1.0 - 2.0 * v, across = std::sqrt(std::max(1.0 - z * z, 0.0));
    light.ray.direction = {across * cosine, across * sine, z};
    light.flux = 2.0 * kTwoPi;
  } else {
    const glm::dvec2 size = window.upper - window.lower;
    const glm::dvec2 q = window.lower + size * glm::dvec2(u, v);
    const View& f = window.view;
    const double squared = 1.0 + q.x * q.x + q.y * q.y;
    light.ray.direction = (f.forward + f.right * q.x + f.up * q.y) / std::sqrt(squared);
    light.flux = size.x * size.y / (squared * std::sqrt(squared));
  }
  light.flux *= falloff_.at(light.ray.direction, point.direction);
  return light;
}

LightRay Emission::ray(int index, int side, int batch, Numbers& numbers) const {
  const std::uint64_t count = static_cast<std::uint64_t>(side) * static_cast<std::uint64_t>(side);
  const auto cell = static_cast<std::uint64_t>(index), row = static_cast<std::uint64_t>(side);
  const double per = 1.0 / side;
  const std::uint64_t cell_column = cell % row, cell_row = cell / row;
  const double u = (static_cast<double>(cell_column) + numbers.next()) * per;
  const double v = (static_cast<double>(cell_row) + numbers.next()) * per;
  LightPoint point{light_.position, light_.direction};
  Window own;
  const Window* window = &fixed_;
  if (shape_.has_size()) {
    const std::uint64_t place = shuffled(cell, count, mixed(static_cast<std::uint64_t>(batch) + 0x51ed27));
    const std::uint64_t place_column = place % row, place_row = place / row;
    const double a = (static_cast<double>(place_column) + numbers.next()) * per;
    const double b = (static_cast<double>(place_row) + numbers.next()) * per;
    point = shape_.point(a, b, numbers.next());
    own = window_of(point, corners_);
    window = &own;
  }
  LightRay light =
      light_.type == LightType::Directional ? parallel(*window, u, v) : from_point(*window, point, u, v);
  light.flux /= static_cast<double>(count);
  return light;
}

}  // namespace caustics::tracer
