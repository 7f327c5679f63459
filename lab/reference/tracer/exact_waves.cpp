#include "lab/reference/tracer/exact_waves.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/gpu/error.hpp"
#include "pipeline/scene/exact.hpp"

namespace caustics::tracer {

namespace {

constexpr double kTolerance = 1e-3;
// More turns of one wave across the rectangle are no water, and would take for ever.
constexpr double kMostRadians = 1e5;
constexpr int kMostSteps = 1'000'000;

// The ray's height above the waves, f(t), as it is needed to step along it.
class Descent {
 public:
  // Of a ray in the field's coordinates.
  Descent(const HeightField& field, const Ray& ray) : field_(field), ray_(ray) {
    for (const SineWave& wave : field.waves) {
      const double turns = turning(wave);
      sharpest_ += std::fabs(wave.amplitude) * turns * turns;
      scale_ += std::fabs(wave.amplitude);
    }
    scale_ += std::fabs(field.level) + std::fabs(ray.origin.y);
  }

  struct Value {
    double height, slope;  // f, f'
  };
  Value at(double t) const {
    const glm::dvec3 p = ray_.at(t);
    Value value{p.y - field_.level, ray_.direction.y};
    for (const SineWave& wave : field_.waves) {
      double sine, cosine;
      exact::sin_cos(wave.k.x * p.x + wave.k.y * p.z + wave.phase, sine, cosine);
      value.height -= wave.amplitude * sine;
      value.slope -= wave.amplitude * turning(wave) * cosine;
    }
    return value;
  }

  // Before which f, that has one sign at t, cannot reach 0, for |f''| <= sharpest_.
  double safe_step(const Value& value) const {
    const double f = std::fabs(value.height), falls = value.height > 0.0 ? -value.slope : value.slope;
    const double root = std::sqrt(falls * falls + 2.0 * sharpest_ * f);
    if (falls > 0.0) return 2.0 * f / (falls + root);
    return sharpest_ > 0.0 ? (root - falls) / sharpest_ : std::numeric_limits<double>::infinity();
  }
  // Is f nothing but rounding?
  bool is_zero(double f, double t) const {
    return std::fabs(f) <= 1e-15 * (scale_ + std::fabs(t * ray_.direction.y));
  }

 private:
  double turning(const SineWave& wave) const {
    return wave.k.x * ray_.direction.x + wave.k.y * ray_.direction.z;
  }
  const HeightField& field_;
  const Ray& ray_;
  double sharpest_ = 0.0, scale_ = 0.0;
};

// Keeps of from..to what lies within lower..upper of one coordinate.
bool clip(double origin, double direction, double lower, double upper, double& from, double& to) {
  if (direction == 0.0) return origin >= lower && origin <= upper;
  const double a = (lower - origin) / direction, b = (upper - origin) / direction;
  from = std::max(from, std::min(a, b));
  to = std::min(to, std::max(a, b));
  return from <= to;
}

[[noreturn]] void refuse(const Mesh& mesh, const std::string& why) {
  throw Error(ExitCode::BadInput, "mesh '" + mesh.name + "' is not the waves that its file states: " + why);
}

}  // namespace

double ExactWaves::reach() const {
  double sum = 0.0;
  for (const SineWave& wave : field.waves) sum += std::fabs(wave.amplitude);
  return sum;
}

double ExactWaves::height(const glm::dvec2& p) const {
  double sum = field.level;
  for (const SineWave& wave : field.waves) {
    double sine, cosine;
    exact::sin_cos(wave.k.x * p.x + wave.k.y * p.y + wave.phase, sine, cosine);
    sum += wave.amplitude * sine;
  }
  return sum;
}

std::optional<ShapeMeeting> ExactWaves::nearest(const Ray& ray, double from, double to) const {
  const Ray local{to_field * (ray.origin - field.origin), to_field * ray.direction};
  const double thick = reach() * (1.0 + 1e-9) + 1e-9 * (upper.x - lower.x + upper.y - lower.y);
  if (!clip(local.origin.y, local.direction.y, field.level - thick, field.level + thick, from, to) ||
      !clip(local.origin.x, local.direction.x, lower.x, upper.x, from, to) ||
      !clip(local.origin.z, local.direction.z, lower.y, upper.y, from, to))
    return std::nullopt;
  const Descent descent(field, local);
  double t = from;
  Descent::Value value = descent.at(t);
  const bool above = value.height > 0.0;
  for (int i = 0; i < kMostSteps && (value.height > 0.0) == above && !descent.is_zero(value.height, t); ++i) {
    const double step = descent.safe_step(value);
    if (!(t + step <= to)) return std::nullopt;
    if (t + step == t) break;
    t += step;
    value = descent.at(t);
  }
  const glm::dvec3 p = local.at(t);
  glm::dvec3 up(0.0, 1.0, 0.0);
  for (const SineWave& wave : field.waves) {
    double sine, cosine;
    exact::sin_cos(wave.k.x * p.x + wave.k.y * p.z + wave.phase, sine, cosine);
    up -= glm::dvec3(wave.k.x, 0.0, wave.k.y) * (wave.amplitude * cosine);
  }
  const glm::dvec3 normal = exact::normalise(glm::transpose(to_field) * up * side, -ray.direction);
  return ShapeMeeting{t, normal, exact::dot(normal, ray.direction) < 0.0};
}

Bounds ExactWaves::bounds() const {
  Bounds bounds;
  const double thick = reach();
  for (int i = 0; i < 8; ++i)
    bounds.add(field.origin + field.axes * glm::dvec3(i & 1 ? upper.x : lower.x,
                                                      field.level + (i & 2 ? thick : -thick),
                                                      i & 4 ? upper.y : lower.y));
  return bounds;
}

void ExactWaves::append_numbers(std::vector<double>& numbers) const {
  for (const SineWave& wave : field.waves)
    numbers.insert(numbers.end(), {wave.amplitude, wave.k.x, wave.k.y, wave.phase});
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) numbers.push_back(field.axes[column][row]);
  numbers.insert(numbers.end(), {field.level, field.origin.x, field.origin.y, field.origin.z, lower.x,
                                 lower.y, upper.x, upper.y, side});
}

ExactWaves waves_of(const Mesh& mesh, const HeightField& field) {
  ExactWaves waves{.field = field, .to_field = glm::inverse(field.axes)};
  waves.lower = glm::dvec2(std::numeric_limits<double>::infinity());
  waves.upper = -waves.lower;
  std::vector<glm::dvec3> points;  // in the field's coordinates
  for (const Vertex& v : mesh.vertices) {
    points.push_back(waves.to_field * (glm::dvec3(v.position) - field.origin));
    const glm::dvec2 p(points.back().x, points.back().z);
    waves.lower = glm::min(waves.lower, p);
    waves.upper = glm::max(waves.upper, p);
  }
  const glm::dvec2 size = waves.upper - waves.lower;
  if (!(size.x > 0.0 && size.y > 0.0)) refuse(mesh, "it covers no rectangle of x and z");
  for (const SineWave& wave : field.waves)
    if (!(std::fabs(wave.k.x) * size.x + std::fabs(wave.k.y) * size.y <= kMostRadians))
      refuse(mesh, "more than ten thousand waves lie side by side");
  // Single precision's rounding, of a place far from the origin too.
  const double rounding =
      4e-7 * (size.x + size.y + std::fabs(field.level) + exact::length(waves.to_field * field.origin));
  for (const glm::dvec3& p : points)
    if (!(std::fabs(p.y - waves.height({p.x, p.z})) <= kTolerance * waves.reach() + rounding))
      refuse(mesh, "its vertices must lie on them to a thousandth of their height");
  double covered = 0.0, upward = 0.0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::dvec3 &a = points[mesh.indices[i]], &b = points[mesh.indices[i + 1]],
                     &c = points[mesh.indices[i + 2]];
    const double up = 0.5 * exact::cross(b - a, c - a).y;
    covered += std::fabs(up);
    upward += up;
  }
  if (!(std::fabs(covered - size.x * size.y) <= kTolerance * size.x * size.y) ||
      !(std::fabs(upward) >= (1.0 - kTolerance) * covered))
    refuse(mesh, "it must cover a rectangle of x and z once");
  waves.side = (upward > 0.0) == (glm::determinant(field.axes) > 0.0) ? 1.0 : -1.0;
  return waves;
}

}  // namespace caustics::tracer
