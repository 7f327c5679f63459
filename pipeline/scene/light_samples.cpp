#include "pipeline/scene/light_samples.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/scene/emitter.hpp"
#include "pipeline/scene/exact.hpp"
#include "pipeline/scene/low_discrepancy.hpp"

namespace caustics {

namespace {

constexpr double kTwoPi = 2.0 * exact::kPi;

// From anywhere, the samples fill a disk evenly, as a sphere of one brightness looks: three
// coordinates of a point spread evenly on the sphere of four dimensions have this property.
void sample_sphere(Light& sample, int k, int count) {
  const double u = stratum(k, count);
  double sine, cosine, third, unused;
  exact::sin_cos(kTwoPi * stepped(k, kPairStep1), sine, cosine);
  exact::sin_cos(kTwoPi * stepped(k, kPairStep2), third, unused);
  const double a = std::sqrt(u) * sample.radius, b = std::sqrt(1.0 - u) * sample.radius;
  sample.position += glm::dvec3(a * cosine, a * sine, b * third);
}

void sample_rectangle(Light& sample, int k, int count) {
  sample.position +=
      (stratum(k, count) - 0.5) * sample.width + (stepped(k, kGoldenStep) - 0.5) * sample.height;
}

// Evenly over the solid angle of the disk: 1 - cos is uniform.
void sample_disk(Light& sample, int k, int count) {
  double sine, cosine;
  exact::sin_cos(0.5 * sample.angular_radius, sine, cosine);
  const double down = 2.0 * sine * sine * stratum(k, count);
  const double across = std::sqrt(std::max(down * (2.0 - down), 0.0));
  exact::sin_cos(kTwoPi * stepped(k, kGoldenStep), sine, cosine);
  const glm::dvec3 x = exact::perpendicular(sample.direction);
  const glm::dvec3 y = exact::cross(sample.direction, x);
  sample.direction = exact::normalise(
      sample.direction * (1.0 - down) + (x * (across * cosine) + y * (across * sine)), sample.direction);
}

void place(Light& sample, int k, int count) {
  if (sample.is_ball()) return sample_sphere(sample, k, count);
  switch (sample.shape) {
    case LightShape::Rectangle:
      return sample_rectangle(sample, k, count);
    case LightShape::Disk:
      return sample_disk(sample, k, count);
    case LightShape::Sphere:
    case LightShape::Mesh:
    case LightShape::None:
      return;
  }
}

std::string numbered(const std::string& name, int k, int count) {
  std::string digits = std::to_string(k);
  digits.insert(
      0,
      std::to_string(count - 1).size() > digits.size() ? std::to_string(count - 1).size() - digits.size() : 0,
      '0');
  return name + "." + digits;
}

// No point is smaller than this share of the scene's radius.
constexpr double kSmallest = 1e-4;

// Light::sample_radius: of a sphere or disk that looks as large as a sample's share of the light.
double sample_radius(const Scene& scene, const Light& source, int count, double least) {
  if (source.is_ball()) return std::max(source.radius / std::sqrt(static_cast<double>(count)), least);
  switch (source.shape) {
    case LightShape::Rectangle:
      return std::sqrt(exact::length(exact::cross(source.width, source.height)) / (count * exact::kPi));
    case LightShape::Mesh:
      return std::sqrt(Emitter(scene, source.emitter).area() / (count * exact::kPi));
    case LightShape::Sphere:
    case LightShape::Disk:
    case LightShape::None:
      return source.lambertian ? 0.0 : least;
  }
  return least;
}

// The sample that is nearest to the light's middle comes first.
void put_middle_first(const Light& source, std::vector<Light>& samples) {
  const auto away = [&](const Light& sample) {
    return exact::length(sample.position - source.position) +
           exact::length(sample.direction - source.direction);
  };
  std::iter_swap(samples.begin(),
                 std::min_element(samples.begin(), samples.end(),
                                  [&](const Light& a, const Light& b) { return away(a) < away(b); }));
}

// A sample's own intensity and name; it has no size any more.
void finish(Light& sample, int k, int count) {
  // A ball shows a quarter of its surface to each side.
  if (sample.shape == LightShape::Mesh && sample.is_ball()) sample.intensity *= 0.25f;
  sample.shape = LightShape::None;
  if (count == 1) return;
  sample.intensity = static_cast<float>(static_cast<double>(sample.intensity) / count);
  sample.name = numbered(sample.name, k, count);
}

std::vector<Light> samples_of(const Scene& scene, const Light& source, int count, double least) {
  std::vector<Light> samples(static_cast<std::size_t>(count), source);
  std::vector<SurfacePoint> points;
  if (source.shape == LightShape::Mesh && !source.is_ball())
    points = Emitter(scene, source.emitter).spread(count);
  const double radius = sample_radius(scene, source, count, least);
  for (int k = 0; k < count; ++k) {
    Light& sample = samples[static_cast<std::size_t>(k)];
    if (!points.empty()) {
      sample.position = points[static_cast<std::size_t>(k)].position;
      sample.direction = points[static_cast<std::size_t>(k)].normal;
      sample.lambertian = true;
    } else if (count > 1) {
      place(sample, k, count);
    }
    sample.sample_radius = radius;
  }
  if (points.empty()) put_middle_first(source, samples);
  for (int k = 0; k < count; ++k) finish(samples[static_cast<std::size_t>(k)], k, count);
  return samples;
}

}  // namespace

void sample_lights(Scene& scene, int count) {
  scene.sources = std::move(scene.lights);
  scene.lights.clear();
  const Bounds bounds = bounds_of(scene);
  const double least = bounds.empty() ? 0.0 : kSmallest * bounds.radius();
  for (std::size_t i = 0; i < scene.sources.size(); ++i) {
    scene.sources[i].source = static_cast<int>(i);
    const Light& source = scene.sources[i];
    const int own = source.shape == LightShape::None ? 1 : source.samples > 0 ? source.samples : count;
    for (Light& sample : samples_of(scene, source, own, least)) scene.lights.push_back(std::move(sample));
  }
}

}  // namespace caustics
