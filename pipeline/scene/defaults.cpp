#include "pipeline/scene/defaults.hpp"

#include <algorithm>

#include "pipeline/scene/environment.hpp"
#include "pipeline/scene/exact.hpp"
#include "pipeline/scene/lamp_level.hpp"
#include "pipeline/scene/studio.hpp"

namespace caustics {

namespace {

constexpr double kGroundWidths = 12.0;
// The ground fades into what lies behind it between these, widths of the subject from its middle.
constexpr double kFadeFrom = 2.5, kFadeTo = 0.5 * kGroundWidths;
constexpr float kGroundGrey = 0.7f;
constexpr double kSkyShare = 0.3;

int add_ground_material(Scene& scene, const glm::dvec3& centre, double width) {
  Material material;
  material.name = kGroundName;
  material.base_color = glm::vec4(kGroundGrey, kGroundGrey, kGroundGrey, 1.0f);
  material.metallic = 0.0f;
  material.fade = {glm::vec3(centre), static_cast<float>(kFadeFrom * width),
                   static_cast<float>(kFadeTo * width)};
  scene.materials.push_back(material);
  return static_cast<int>(scene.materials.size()) - 1;
}

}  // namespace

std::vector<int> opaque_receivers(const Scene& scene) {
  std::vector<int> meshes;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const Material& material = scene.materials[static_cast<std::size_t>(scene.meshes[i].material)];
    if (is_receiver(material) && material.alpha_mode != AlphaMode::Blend)
      meshes.push_back(static_cast<int>(i));
  }
  return meshes;
}

Bounds subject_of(const Scene& scene) {
  Bounds casters, all;
  for (const Mesh& mesh : scene.meshes) {
    const Material& material = scene.materials[static_cast<std::size_t>(mesh.material)];
    if (mesh.name != kGroundName) all.add(bounds_of(mesh));
    if (!is_receiver(material)) casters.add(bounds_of(mesh));
  }
  return !casters.empty() ? casters : !all.empty() ? all : bounds_of(scene);
}

double widest(const Bounds& bounds) {
  const glm::dvec3 size = bounds.upper - bounds.lower;
  const double width = std::max({size.x, size.y, size.z});
  return width > 0 ? width : 1.0;
}

void add_ground(Scene& scene, const Bounds& subject, double height) {
  const glm::dvec3 centre = subject.centre();
  const double half = 0.5 * kGroundWidths * widest(subject);
  const float y = static_cast<float>(height);
  const auto x0 = static_cast<float>(centre.x - half), x1 = static_cast<float>(centre.x + half);
  const auto z0 = static_cast<float>(centre.z - half), z1 = static_cast<float>(centre.z + half);
  Mesh mesh;
  mesh.name = kGroundName;
  mesh.material = add_ground_material(scene, {centre.x, height, centre.z}, widest(subject));
  for (const Mesh& other : scene.meshes) mesh.object = std::max(mesh.object, other.object + 1);
  for (const glm::vec3& corner :
       {glm::vec3(x0, y, z0), glm::vec3(x0, y, z1), glm::vec3(x1, y, z1), glm::vec3(x1, y, z0)}) {
    Vertex vertex;
    vertex.position = corner;
    vertex.normal = glm::vec3(0, 1, 0);
    mesh.vertices.push_back(vertex);
  }
  mesh.indices = {0, 1, 2, 0, 2, 3};
  mesh.lower = glm::vec3(x0, y, z0);
  mesh.upper = glm::vec3(x1, y, z1);
  scene.meshes.push_back(mesh);
}

float sun_lux(const Environment& environment) {
  constexpr double kUsual = 10.0;
  if (!environment.image) return static_cast<float>(kUsual);
  const double given = upward_irradiance(environment_irradiance(*environment.image));
  return static_cast<float>(given > 0.0 ? std::min(given / kSkyShare, 1e9) : kUsual);
}

void set_sun(Scene& scene, const glm::dvec3& direction, float lux) {
  Light sun;
  sun.name = "sun (added)";
  sun.intensity = lux;
  sun.direction = direction;
  sun.source = 0;
  scene.sources = {sun};
  scene.lights = {sun};
}

bool add_sky(Scene& scene) {
  Environment& sky = scene.environment;
  const bool given =
      sky.image || sky.zenith != glm::vec3(0) || sky.horizon != glm::vec3(0) || sky.ground != glm::vec3(0);
  if (given) return false;
  // A sky of radiance L everywhere lights a horizontal surface with pi L.
  const double mean = kSkyShare * light_level(scene) / exact::kPi;
  sky = studio(mean);
  return true;
}

bool is_mirror(const Material& material) { return material.metallic >= 0.5f && material.roughness <= 0.2f; }

bool is_receiver(const Material& material) { return !(material.transmission > 0.0f) && !is_mirror(material); }

double light_level(const Scene& scene) {
  const bool has_sun = std::any_of(scene.lights.begin(), scene.lights.end(),
                                   [](const Light& light) { return light.type == LightType::Directional; });
  const bool has_casters = std::any_of(scene.meshes.begin(), scene.meshes.end(), [&](const Mesh& mesh) {
    return !is_receiver(scene.materials[static_cast<std::size_t>(mesh.material)]);
  });
  // Among what they light, lamps make it much brighter than in its middle.
  const double lamps = has_sun || has_casters ? 0.0 : lamp_level(scene);
  if (lamps > 0.0) return lamps;
  const Bounds subject = subject_of(scene);
  const glm::dvec3 centre = subject.empty() ? glm::dvec3(0) : subject.centre();
  const double nearest = subject.empty() ? 1.0 : std::max(subject.radius(), 1e-6);
  double level = 0;
  for (const Light& light : scene.lights) {
    double strength = exact::luminance(light.color) * static_cast<double>(light.intensity);
    if (light.type != LightType::Directional) {
      const double distance = std::max(exact::length(light.position - centre), nearest);
      strength /= distance * distance;
      if (light.lambertian) {
        const glm::dvec3 way = exact::normalise(centre - light.position, light.direction);
        strength *= std::max(exact::dot(way, light.direction), 0.0);
      }
    }
    level += strength;
  }
  return level;
}

}  // namespace caustics
