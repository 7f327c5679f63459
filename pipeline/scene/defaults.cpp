#include "pipeline/scene/defaults.hpp"

#include <algorithm>

#include "pipeline/scene/exact.hpp"

namespace caustics {

namespace {

constexpr double kSunLux = 10.0;
// Down, and to the right and front: the sine and cosine of 30 degrees; the horizontal part points
// along (0.8, 0, 0.6), so that shadow and caustic fall beside the object and towards the camera.
const glm::dvec3 kSunDirection{0.5 * 0.8, -0.86602540378443865, 0.5 * 0.6};
const glm::dvec3 kViewFrom{0.48, 0.6, 0.64};  // unit: from the objects to the camera
// Sine of half the camera's field of view of 0.7 radians.
constexpr double kFov = 0.7, kSinHalfFov = 0.34289780745545137;
constexpr double kGroundWidths = 6.0;
constexpr float kGroundGrey = 0.7f;
constexpr double kSkyShare = 0.3;

bool has_receiver(const Scene& scene) {
  return std::any_of(scene.meshes.begin(), scene.meshes.end(), [&](const Mesh& mesh) {
    return is_receiver(scene.materials[static_cast<std::size_t>(mesh.material)]);
  });
}

// What the picture is about: the meshes that throw caustics, else all of them.
Bounds subject_of(const Scene& scene) {
  Bounds casters;
  for (const Mesh& mesh : scene.meshes) {
    const Material& material = scene.materials[static_cast<std::size_t>(mesh.material)];
    if (!is_receiver(material)) casters.add(bounds_of(mesh));
  }
  return casters.empty() ? bounds_of(scene) : casters;
}

double widest(const Bounds& bounds) {
  const glm::dvec3 size = bounds.upper - bounds.lower;
  const double width = std::max({size.x, size.y, size.z});
  return width > 0 ? width : 1.0;
}

int add_ground_material(Scene& scene) {
  Material material;
  material.name = "ground (added)";
  material.base_color = glm::vec4(kGroundGrey, kGroundGrey, kGroundGrey, 1.0f);
  material.metallic = 0.0f;
  scene.materials.push_back(material);
  return static_cast<int>(scene.materials.size()) - 1;
}

void add_ground(Scene& scene, const Bounds& subject) {
  const Bounds all = bounds_of(scene);
  const glm::dvec3 centre = subject.centre();
  const double half = 0.5 * kGroundWidths * widest(subject);
  // A hair below, so that a flat underside does not lie in the ground.
  const float y = static_cast<float>(all.lower.y - 1e-4 * widest(subject));
  const auto x0 = static_cast<float>(centre.x - half), x1 = static_cast<float>(centre.x + half);
  const auto z0 = static_cast<float>(centre.z - half), z1 = static_cast<float>(centre.z + half);
  Mesh mesh;
  mesh.name = "ground (added)";
  mesh.material = add_ground_material(scene);
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
  scene.notes.push_back("Nothing in the scene can show a caustic: a grey ground was added below it.");
}

void add_sun(Scene& scene, const Bounds& subject) {
  Light sun;
  sun.name = "sun (added)";
  sun.intensity = static_cast<float>(kSunLux);
  sun.direction = kSunDirection;
  sun.position = subject.centre() - kSunDirection * (4.0 * widest(subject));
  sun.source = 0;
  scene.sources = {sun};
  scene.lights = {sun};
  scene.notes.push_back("The scene has no light: a sun of 10 lux, 30 degrees off the vertical, was added.");
}

// Where the light that passes a corner of the bounds meets the floor, for directional and other
// lights; no further away than three times the size, so that low lights do not shrink the objects
// to a dot.
void add_shadow(const Light& light, const Bounds& subject, double floor, Bounds& view) {
  const double reach = 3.0 * widest(subject);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p((corner & 1) ? subject.upper.x : subject.lower.x,
                       (corner & 2) ? subject.upper.y : subject.lower.y,
                       (corner & 4) ? subject.upper.z : subject.lower.z);
    const glm::dvec3 direction = light.type == LightType::Directional
                                     ? light.direction
                                     : exact::normalise(p - light.position, light.direction);
    if (!(direction.y < -0.1)) continue;
    const double way = std::clamp((floor - p.y) / direction.y, 0.0, reach);
    view.add(p + direction * way);
  }
}

void add_camera(Scene& scene, const Bounds& subject) {
  Bounds view = subject;
  const double floor = std::max(bounds_of(scene).lower.y, subject.lower.y - 2 * widest(subject));
  for (const Light& light : scene.lights) add_shadow(light, subject, floor, view);
  const double radius = view.radius() > 0 ? view.radius() : 1.0;
  const double distance = 1.05 * radius / kSinHalfFov;
  Camera camera;
  camera.name = "three-quarter view (added)";
  camera.vertical_fov = kFov;
  camera.position = view.centre() + kViewFrom * distance;
  camera.forward = -kViewFrom;
  camera.right = exact::normalise(exact::cross(camera.forward, {0, 1, 0}), {1, 0, 0});
  camera.up = exact::cross(camera.right, camera.forward);
  camera.near = 0.01 * distance;
  scene.cameras.push_back(camera);
  scene.notes.push_back("The scene has no camera: a three-quarter view from above was added.");
}

void add_sky(Scene& scene) {
  Environment& sky = scene.environment;
  const bool given =
      sky.image || sky.zenith != glm::vec3(0) || sky.horizon != glm::vec3(0) || sky.ground != glm::vec3(0);
  if (given) return;
  // A sky of radiance L everywhere lights a horizontal surface with pi L.
  const double mean = kSkyShare * light_level(scene) / exact::kPi;
  sky.zenith = glm::vec3(static_cast<float>(0.6 * mean));
  sky.horizon = glm::vec3(static_cast<float>(1.8 * mean));
  sky.ground = glm::vec3(static_cast<float>(0.5 * mean));
  scene.notes.push_back(
      "No environment image was given: a neutral sky lights the scene with 30 % of "
      "what its lights give.");
}

}  // namespace

bool is_mirror(const Material& material) { return material.metallic >= 0.5f && material.roughness <= 0.2f; }

bool is_receiver(const Material& material) { return !(material.transmission > 0.0f) && !is_mirror(material); }

double light_level(const Scene& scene) {
  const Bounds subject = subject_of(scene);
  const glm::dvec3 centre = subject.empty() ? glm::dvec3(0) : subject.centre();
  const double nearest = subject.empty() ? 1.0 : std::max(subject.radius(), 1e-6);
  double level = 0;
  for (const Light& light : scene.lights) {
    const double luminance = (0.2126 * light.color.x + 0.7152 * light.color.y) + 0.0722 * light.color.z;
    double strength = luminance * light.intensity;
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

void complete_scene(Scene& scene) {
  Bounds subject = subject_of(scene);
  if (subject.empty()) {
    subject.add(glm::dvec3(-0.5));
    subject.add(glm::dvec3(0.5));
  }
  if (!scene.meshes.empty() && !has_receiver(scene)) add_ground(scene, subject);
  if (scene.lights.empty()) add_sun(scene, subject);
  if (scene.cameras.empty()) add_camera(scene, subject);
  add_sky(scene);
}

}  // namespace caustics
