#include "pipeline/renderer/exposure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "pipeline/renderer/landed_light.hpp"
#include "pipeline/scene/defaults.hpp"
#include "pipeline/scene/environment.hpp"
#include "pipeline/scene/exact.hpp"
#include "pipeline/scene/far_lights.hpp"
#include "pipeline/scene/triangle_tree.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

namespace {

// Radiance over display white: what glows, the floor, and what glows at most.
constexpr double kWhite = 1.15, kFloor = 0.31, kMostGlow = 7.6;
constexpr double kLargeWhite = 0.8;  // white that fills a tenth of the picture keeps its texture
constexpr double kMostContrast = 6.0;
constexpr double kGlows = 0.999;  // of the picture is darker than what glows
// No more than a tenth of what the camera meets is so many times as bright as the floor: a white table around
// a dark cloth.
constexpr double kBright = 0.9, kMostBright = 2.2;
// And half of the picture not as many times: a low ground before a bright sky.
constexpr double kMostOfHalf = 1.15;
constexpr double kCameraRays = 2304.0;  // of the camera, 64 x 36
// Landed light is told apart four times as finely, where so many rays or more land side by side.
constexpr int kFine = 4, kEnoughRays = 10;
constexpr double kShadowRays = 131072;  // fewer of the camera where there are many lights
constexpr double kOpenFloor = 0.7;      // albedo

// Of a texture, about.
glm::dvec3 mean_color(const Scene& scene, const TextureUse& use) {
  if (!use.present()) return glm::dvec3(1.0);
  const Image& image = scene.images[static_cast<std::size_t>(use.image)];
  constexpr int kSteps = 16;  // a side
  glm::dvec3 sum(0.0);
  for (int j = 0; j < kSteps; ++j)
    for (int i = 0; i < kSteps; ++i)
      for (int c = 0; c < 3; ++c)
        sum[c] += static_cast<double>(image.at((2 * i + 1) * image.width() / (2 * kSteps),
                                               (2 * j + 1) * image.height() / (2 * kSteps), c));
  return sum / static_cast<double>(kSteps * kSteps);
}

// Of rays in cells of a picture: how many there are in a box around a cell, and their light.
class SumsOverBoxes {
 public:
  SumsOverBoxes(int width, int height)
      : width_(width), height_(height), cells_(static_cast<std::size_t>((width + 1) * (height + 1))) {}

  void add(int x, int y, double lumen) {
    Sum& cell = at(std::min(x, width_ - 1) + 1, std::min(y, height_ - 1) + 1);
    cell.lumen += lumen;
    cell.rays += 1;
  }

  // From each cell to the sum of all before it.
  void finish() {
    for (int y = 1; y <= height_; ++y)
      for (int x = 1; x <= width_; ++x) {
        at(x, y).lumen += at(x - 1, y).lumen + at(x, y - 1).lumen - at(x - 1, y - 1).lumen;
        at(x, y).rays += at(x - 1, y).rays + at(x, y - 1).rays - at(x - 1, y - 1).rays;
      }
  }

  // Lumen a cell, over the smallest box that has rays enough: few rays in small boxes are noise.
  double density_at(int x, int y) const {
    double density = 0.0;
    for (const int reach : {0, 1, 2, 4, 6}) {
      const int left = std::max(x - reach, 0), right = std::min(x + reach + 1, width_);
      const int low = std::max(y - reach, 0), high = std::min(y + reach + 1, height_);
      const Sum &a = at(left, low), &b = at(right, low), &c = at(left, high), &d = at(right, high);
      density = std::max((d.lumen - b.lumen) - (c.lumen - a.lumen), 0.0) / ((right - left) * (high - low));
      if ((d.rays - b.rays) - (c.rays - a.rays) >= kEnoughRays) break;
    }
    return density;
  }

 private:
  struct Sum {
    double lumen = 0.0;
    int rays = 0;
  };
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * (static_cast<std::size_t>(width_) + 1) + static_cast<std::size_t>(x);
  }
  const Sum& at(int x, int y) const { return cells_[index(x, y)]; }
  Sum& at(int x, int y) { return cells_[index(x, y)]; }

  int width_, height_;
  std::vector<Sum> cells_;
};

// What the picture shows of the receivers, cell by cell.
class Sketch {
 public:
  Sketch(const Scene& scene, const Settings& settings, const View& camera, const Pilot& pilot)
      : scene_(scene),
        camera_(camera),
        receivers_(scene, opaque_receivers(scene)),
        light_(scene, settings, pilot),
        ambient_(upward_irradiance(scene.environment)) {
    const double lights = std::max<double>(1.0, static_cast<double>(scene.lights.size()));
    const double rays = std::clamp(kShadowRays / lights, 16.0, kCameraRays);
    const double aspect = static_cast<double>(settings.width) / settings.height;
    columns_ = std::max(4, static_cast<int>(std::sqrt(rays * aspect)));
    rows_ = std::max(4, static_cast<int>(rays / columns_));
    for (const Material& material : scene.materials)
      albedo_.push_back(
          exact::luminance(glm::dvec3(material.base_color) * mean_color(scene, material.base_color_texture)) *
          (1.0 - static_cast<double>(material.metallic)));
    cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    const std::vector<Landed> landed = light_.find();
    for (int y = 0; y < rows_; ++y)
      for (int x = 0; x < columns_; ++x) look(x, y);
    add(landed);
  }

  // Of what was met, the share `part` from the darkest; of the whole picture if `whole`.
  double percentile(double part, bool whole) const {
    std::vector<double> values;
    if (whole) values = fine_;
    for (const Cell& cell : cells_)
      if (!whole && cell.area > 0.0) values.push_back(cell.radiance);
    if (values.empty()) return 0.0;
    const auto at = static_cast<std::size_t>(part * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
    return values[at];
  }

 private:
  struct Cell {
    double radiance = 0.0, albedo = 0.0, area = 0.0;  // square metres of the surface; 0: none is met
  };

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x);
  }

  void add(const std::vector<Landed>& landed) {
    SumsOverBoxes sums(kFine * columns_, kFine * rows_);
    for (const Landed& each : landed)
      if (const auto place = seen_at(each.position))
        sums.add(static_cast<int>(place->x * kFine * columns_), static_cast<int>(place->y * kFine * rows_),
                 each.lumen);
    sums.finish();
    for (int y = 0; y < kFine * rows_; ++y)
      for (int x = 0; x < kFine * columns_; ++x) {
        const Cell& cell = cells_[index(x / kFine, y / kFine)];
        const double lux = cell.area > 0.0 ? sums.density_at(x, y) * (kFine * kFine) / cell.area : 0.0;
        fine_.push_back(cell.radiance + cell.albedo / exact::kPi * lux);
      }
  }

  void look(int x, int y) {
    const glm::dvec2 size = camera_.window_upper - camera_.window_lower;
    const glm::dvec2 at = camera_.window_lower + size * glm::dvec2((x + 0.5) / columns_, (y + 0.5) / rows_);
    const glm::dvec3 aside = camera_.right * at.x + camera_.up * at.y;
    const glm::dvec3 origin = camera_.perspective ? camera_.origin : camera_.origin + aside;
    const glm::dvec3 way =
        camera_.perspective ? exact::normalise(camera_.forward + aside, camera_.forward) : camera_.forward;
    const auto hit = receivers_.nearest(origin, way);
    Cell& cell = cells_[index(x, y)];
    if (!hit) {
      cell.radiance = behind();
      return;
    }
    const Mesh& mesh = scene_.meshes[static_cast<std::size_t>(hit->id.mesh)];
    const glm::dvec3 plane = plane_normal(scene_, hit->id), p = origin + way * hit->distance;
    const double turned = exact::dot(plane, way), depth = exact::dot(p - camera_.origin, camera_.forward);
    // A cell at the depth z is z^2 times as large as its window, and its surface more by its slant.
    const double across = camera_.perspective ? depth * depth * exact::dot(way, camera_.forward) : 1.0;
    cell.albedo = albedo_[static_cast<std::size_t>(mesh.material)];
    cell.area = size.x * size.y / (columns_ * rows_) * across / std::max(std::fabs(turned), 0.05);
    const glm::dvec3 normal = turned > 0.0 ? -plane : plane;
    cell.radiance = cell.albedo / exact::kPi * (ambient_ + direct(p, normal, hit->id));
  }

  // About what is seen where nothing is met.
  double behind() const {
    const Environment& sky = scene_.environment;
    return sky.image ? ambient_ / exact::kPi
                     : exact::luminance(glm::dvec3(sky.backdrop.value_or(sky.horizon)));
  }

  double direct(const glm::dvec3& p, const glm::dvec3& normal, const TriangleId& own) const {
    double sum = 0.0;
    for (const Light& light : scene_.lights) {
      const bool is_far = light.type == LightType::Directional;
      const glm::dvec3 to = is_far ? -light.direction : light.position - p;
      const double distance = exact::length(to), cosine = exact::dot(to, normal);
      if (!(cosine > 0.0) || (!is_far && distance > static_cast<double>(light.range))) continue;
      const auto before = receivers_.nearest(p, to, own, light.emitter);
      if (before && (is_far || before->distance < 1.0)) continue;
      if (light_.casters_block(p, to / distance, is_far ? std::numeric_limits<double>::infinity() : distance))
        continue;
      const double falloff = is_far ? 1.0 : cone_falloff(light, -to / distance) / (distance * distance);
      sum += exact::luminance(glm::dvec3(light.color)) * static_cast<double>(light.intensity) * falloff *
             cosine / distance;
    }
    return sum;
  }

  // In parts of the picture's width and height.
  std::optional<glm::dvec2> seen_at(const glm::dvec3& p) const {
    const glm::dvec3 here = camera_.coordinates(p);
    if (!(here.z > 0.0)) return {};
    const glm::dvec2 at =
        (camera_.window(here) - camera_.window_lower) / (camera_.window_upper - camera_.window_lower);
    if (!(at.x >= 0.0 && at.x < 1.0 && at.y >= 0.0 && at.y < 1.0)) return {};
    const glm::dvec3 to = camera_.perspective ? camera_.origin - p : camera_.forward * -here.z;
    if (receivers_.nearest(p + to * 1e-4, to)) return {};
    return at;
  }

  const Scene& scene_;
  const View& camera_;
  TriangleTree receivers_;
  LandedLight light_;
  double ambient_;  // lux
  int columns_ = 0, rows_ = 0;
  std::vector<double> albedo_;  // by Scene::materials
  std::vector<Cell> cells_;
  std::vector<double> fine_;  // radiance, kFine times as finely a side
};

// 2^ev by whole steps and a series for the rest.
double power_of_two(double ev) {
  double whole = std::floor(ev), power = 1.0;
  const double rest = (ev - whole) * 0.69314718055994530942;
  for (int n = 16; n >= 1; --n) power = 1.0 + power * rest / n;
  for (; whole > 0.5; whole -= 1.0) power *= 2.0;
  for (; whole < -0.5; whole += 1.0) power *= 0.5;
  return power;
}

// By which what is `ratio` times as bright as the floor is shown as `white`.
double contrast_for(double ratio, double white) {
  return ratio > 1.001 ? exact::log(white / kFloor) / exact::log(ratio) : kMostContrast;
}

}  // namespace

Exposure exposure_of(const Scene& scene, const Settings& settings, const std::optional<View>& camera,
                     const Pilot& pilot) {
  double floor = 0.0, bright = 0.0, glow = 0.0;
  if (camera && !scene.meshes.empty()) {
    const Sketch sketch(scene, settings, *camera, pilot);
    bright = sketch.percentile(kBright, true);
    floor = std::max(
        {sketch.percentile(0.5, false), sketch.percentile(0.5, true) / kMostOfHalf, bright / kMostBright});
    glow = sketch.percentile(kGlows, true);
  }
  if (!(floor > 0.0))
    floor = kOpenFloor / exact::kPi * (light_level(scene) + upward_irradiance(scene.environment));
  if (!(floor > 0.0)) floor = kFloor;
  const double ratio = std::clamp(glow / floor, 1.0, 1e9);
  const double wanted =
      std::min(contrast_for(ratio, kWhite), contrast_for(std::min(bright / floor, ratio), kLargeWhite));
  const double factor = std::min(kFloor, kMostGlow / ratio) / floor *
                        power_of_two(settings.exposure ? static_cast<double>(*settings.exposure) : 0.0);
  return {.factor = static_cast<float>(std::clamp(factor, 1e-30, 1e30)),
          .contrast = static_cast<float>(std::clamp(wanted, 1.0, kMostContrast))};
}

}  // namespace caustics
