#include "pipeline/measure/brightness_bound.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/effects/effects.hpp"
#include "pipeline/scene/cube_view.hpp"
#include "pipeline/scene/exact.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

namespace {

constexpr double kSafety = 4.0;
constexpr double kGuessedNearest = 0.1;  // of the scene's radius
constexpr double kLeastRoughness = 0.2;  // passes/shared/highlight.glsl
constexpr double kBrightestStudio = 100.0;
constexpr double kAllAround = 24.0;  // all faces of a cube, tangent units squared

double brightest(const glm::vec3& color) {
  return static_cast<double>(std::max({color.x, color.y, color.z}));
}

double strength(const Light& light) { return brightest(light.color) * static_cast<double>(light.intensity); }

// Square metres that a candela is spread over at least.
double least_spread(const Scene& scene, const Light& light, BoundBy by) {
  if (light.type == LightType::Directional) return 1.0;
  double nearest = kGuessedNearest * bounds_of(scene).radius();
  if (by == BoundBy::Triangles) {
    const Distances distances = distances_from(
        light.position, scene, [&](std::size_t mesh) { return light.emitter != static_cast<int>(mesh); });
    nearest = distances.empty() ? nearest : std::max(distances.nearest, 0.0);
  }
  return std::max({nearest * nearest, light.sample_radius * light.sample_radius, 1e-20});
}

// How many times the irradiance at the distance of `spread` all flux through the casters' window is in one
// texel. Towards the corners of a perspective window texels fill less than in its middle.
double concentration(const LightViews& views, double texels) {
  double texel = views.caustic.window_area() / texels;
  if (views.cascade) texel = std::min(texel, views.cascade->window_area() / texels);
  const double window = views.caster.cube ? kAllAround : views.caster.window_area();
  double slanted = 1.0;
  if (views.caustic.perspective) {
    const glm::dvec2 corner = views.caustic.cube ? glm::dvec2(1.0)
                                                 : glm::max(glm::abs(views.caustic.window_lower),
                                                            glm::abs(views.caustic.window_upper));
    const double squared = 1.0 + corner.x * corner.x + corner.y * corner.y;
    slanted = squared * std::sqrt(squared);
  }
  return texel > 0.0 ? window / texel * slanted : 0.0;
}

// Of highlight_lobe (passes/shared/highlight.glsl) times the cosine to the light.
double most_mirrored(double roughness) {
  const double alpha = std::max(roughness, kLeastRoughness) * std::max(roughness, kLeastRoughness);
  return 1.0 / (exact::kPi * alpha * alpha * alpha);
}

double smoothest_receiver(const Scene& scene, const Effects& effects) {
  double least = 1.0;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const Material& material = scene.materials[static_cast<std::size_t>(scene.meshes[i].material)];
    if (is_caster(effects.surfaces[i].role)) continue;
    const bool varies = material.metallic_roughness_texture.present();
    least = std::min(least, varies ? 0.0 : static_cast<double>(material.roughness));
  }
  return least;
}

// `direct`: what the lights give at most. A studio is added in proportion to it (add_sky), and its boxes are
// some ten times as bright as its mean.
double brightest_around(const Environment& around, double direct, BoundBy by) {
  double most = std::max({brightest(around.zenith), brightest(around.horizon), brightest(around.ground)});
  if (around.backdrop) most = std::max(most, brightest(*around.backdrop));
  for (const SoftBox& box : around.boxes) most += static_cast<double>(box.radiance);
  if (!around.image) return std::min(most, kBrightestStudio * direct);
  if (by == BoundBy::Guess) return 0.0;
  const Image& image = *around.image;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      for (int c = 0; c < std::min(image.channels(), 3); ++c)
        most = std::max(most, static_cast<double>(image.at(x, y, c)));
  return most;
}

double brightest_surface(const Scene& scene) {
  double most = 0.0;
  for (const Mesh& mesh : scene.meshes)
    most = std::max(most, brightest(scene.materials[static_cast<std::size_t>(mesh.material)].emissive));
  return most;
}

// What the haze along a ray scatters towards the camera: of the light as it arrives anywhere, and of lamps
// that the ray passes, which it sees under at most 180 degrees.
double scattered(const Scene& scene, double irradiance) {
  const Medium& medium = scene.medium;
  if (!medium.scatters()) return 0.0;
  const double g = std::fabs(static_cast<double>(medium.anisotropy));
  const double phase = (1.0 + g) / (4.0 * exact::kPi * (1.0 - g) * (1.0 - g));
  const double way = 2.0 * medium_bounds(scene).radius();
  double sum = irradiance * way;
  for (const Light& light : scene.lights)
    if (light.type != LightType::Directional)
      sum += exact::kPi * strength(light) / std::max(light.sample_radius, 1e-5 * way);
  return sum * brightest(medium.scattering) * phase;
}

}  // namespace

BrightnessBound brightness_bound(const Scene& scene, const Effects& effects, const Settings& settings,
                                 const std::vector<LightViews>& views, BoundBy by) {
  BrightnessBound bound;
  const double texels = static_cast<double>(settings.map) * static_cast<double>(settings.map);
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const double most = strength(scene.lights[i]) / least_spread(scene, scene.lights[i], by);
    bound.direct += kSafety * most;
    if (i < views.size() && throws_caustic(effects, static_cast<int>(i)))
      bound.caustic += kSafety * most * concentration(views[i], texels);
  }
  if (settings.weights == Weights::Paper && bound.caustic > 0.0)
    bound.caustic = std::numeric_limits<double>::infinity();
  const double arriving = bound.direct + bound.caustic;
  // All around once behind, once mirrored, once scattered.
  bound.radiance =
      kSafety * (brightest_surface(scene) + 3.0 * brightest_around(scene.environment, bound.direct, by)) +
      arriving / exact::kPi + scattered(scene, arriving) + bound.direct * most_mirrored(0.0) +
      bound.caustic * most_mirrored(smoothest_receiver(scene, effects));
  return bound;
}

}  // namespace caustics
