#include "pipeline/scene/gltf/lights.hpp"

#include <algorithm>

#include "pipeline/scene/gltf/light_size.hpp"

namespace caustics::gltf {

namespace {

constexpr double kBrightest = 1e12;

LightType type_of(const Cursor& light) {
  const Cursor type = light.member("type");
  const std::string name = type.string();
  if (name == "directional") return LightType::Directional;
  if (name == "point") return LightType::Point;
  if (name == "spot") return LightType::Spot;
  type.fail("is \"" + printable(name, 40) + "\"", "use directional, point or spot");
}

void read_strength(Context& context, const Cursor& cursor, Light& light) {
  const std::vector<double> color = cursor.member("color").numbers(3);
  for (int c = 0; c < 3 && !color.empty(); ++c) {
    const double value = color[static_cast<std::size_t>(c)];
    light.color[c] = static_cast<float>(std::clamp(value, 0.0, 1.0));
    if (value < 0 || value > 1) context.note(cursor.path() + ".color is clamped to 0..1.");
  }
  const Cursor intensity = cursor.member("intensity");
  const double value = intensity.number(1.0);
  if (value < 0) context.note(intensity.path() + " is negative; the light is off.");
  if (value > kBrightest) context.note(intensity.path() + " is above 1e12; 1e12 is used.");
  light.intensity = static_cast<float>(std::clamp(value, 0.0, kBrightest));
}

void read_range(Context& context, const Cursor& range, Light& light) {
  if (!range.present()) return;
  const double value = range.number();
  if (value > 0 && value < 1e30) {
    light.range = static_cast<float>(value);
  } else {
    context.note(range.path() + " is not a distance above 0; the light reaches everywhere.");
  }
}

void read_cone(Context& context, const Cursor& spot, Light& light) {
  if (!spot.present()) spot.fail("is missing", "a spot light needs it");
  double inner = spot.member("innerConeAngle").number(0.0);
  double outer = spot.member("outerConeAngle").number(exact::kPi / 4);
  if (!(outer > 0 && outer <= exact::kPi / 2)) {
    outer = outer > 0 ? exact::kPi / 2 : exact::kPi / 4;
    context.note(spot.path() + ".outerConeAngle is not within 0..pi/2 and was put there.");
  }
  if (!(inner >= 0 && inner <= outer)) {
    inner = inner < 0 ? 0 : outer;
    context.note(spot.path() + ".innerConeAngle is not within 0..outerConeAngle and was put there.");
  }
  light.inner_cone = static_cast<float>(inner);
  light.outer_cone = static_cast<float>(outer);
}

Light read_light(Context& context, const Cursor& cursor, const Cursor& node, const Placement& placement,
                 const glm::dvec3& origin) {
  Light light;
  light.name =
      printable(!placement.name.empty() ? placement.name : cursor.member("name").string(cursor.path()));
  light.type = type_of(cursor);
  read_strength(context, cursor, light);
  if (light.type != LightType::Directional) read_range(context, cursor.member("range"), light);
  if (light.type == LightType::Spot) read_cone(context, cursor.member("spot"), light);
  light.position = placement.to_world.translation - origin;
  light.direction = exact::normalise(-placement.to_world.z, glm::dvec3(0));
  if (light.direction == glm::dvec3(0)) {
    if (light.type != LightType::Point) {
      context.fail("nodes[" + std::to_string(placement.node) + "]",
                   "its scale is 0, so its light has no direction", "give it another scale");
    }
    light.direction = {0, 0, -1};
  }
  read_size(context, cursor, node, placement.to_world, light);
  return light;
}

void read_planes(const Cursor& cursor, bool orthographic, Camera& camera) {
  const Cursor near = cursor.member("znear"), far = cursor.member("zfar");
  camera.near = near.number();
  if (camera.near < 0 || (camera.near == 0 && !orthographic) || !(camera.near < 1e15)) {
    near.fail("must be above 0", "correct the camera");
  }
  if (far.present()) camera.far = far.number();
  if (orthographic && !far.present()) far.fail("is missing", "correct the camera");
  if (!(camera.far > camera.near)) far.fail("must be beyond znear", "correct the camera");
}

// Right, up and back from the node's axes; its scale does not count, and a mirrored node does not
// mirror the picture.
void read_axes(Context& context, const Placement& placement, Camera& camera) {
  const exact::Affine& m = placement.to_world;
  camera.forward = exact::normalise(-m.z, glm::dvec3(0));
  const glm::dvec3 up = exact::normalise(m.y, glm::dvec3(0));
  const glm::dvec3 right = exact::normalise(exact::cross(camera.forward, up), glm::dvec3(0));
  if (camera.forward == glm::dvec3(0) || right == glm::dvec3(0)) {
    context.fail("nodes[" + std::to_string(placement.node) + "]",
                 "its transform is flat, so its camera has no direction", "give it another scale");
  }
  camera.right = right;
  camera.up = exact::cross(right, camera.forward);
}

void read_perspective(const Cursor& cursor, Camera& camera) {
  const Cursor angle = cursor.member("yfov");
  camera.vertical_fov = angle.number();
  if (!(camera.vertical_fov > 1e-6 && camera.vertical_fov < 3.14)) {
    angle.fail("must be an angle above 0 and below pi", "correct the camera");
  }
  read_planes(cursor, false, camera);
}

void read_orthographic(Context& context, const Cursor& cursor, Camera& camera) {
  camera.orthographic = true;
  const double x = cursor.member("xmag").number(), y = cursor.member("ymag").number();
  camera.half_width = x < 0 ? -x : x;
  camera.half_height = y < 0 ? -y : y;
  if (x < 0 || y < 0) context.note(cursor.path() + ": negative magnification was made positive.");
  const double least = std::min(camera.half_width, camera.half_height);
  const double most = std::max(camera.half_width, camera.half_height);
  if (!(least > 1e-12 && most < 1e12)) {
    cursor.member("xmag").fail("xmag and ymag must not be 0", "correct the camera");
  }
  read_planes(cursor, true, camera);
}

}  // namespace

std::vector<Light> read_lights(Context& context, const Document& document,
                               const std::vector<Placement>& placements, const glm::dvec3& origin) {
  const Cursor all =
      document.root(context).member("extensions").member("KHR_lights_punctual").member("lights");
  const Cursor nodes = document.root(context).member("nodes");
  std::vector<Light> lights;
  for (const Placement& placement : placements) {
    const Cursor light = all.element(static_cast<std::size_t>(placement.index));
    const Cursor node = nodes.element(static_cast<std::size_t>(placement.node));
    lights.push_back(read_light(context, light, node, placement, origin));
  }
  return lights;
}

std::vector<Camera> read_cameras(Context& context, const Document& document,
                                 const std::vector<Placement>& placements, const glm::dvec3& origin) {
  const Cursor all = document.root(context).member("cameras");
  std::vector<Camera> cameras;
  for (const Placement& placement : placements) {
    const Cursor cursor = all.element(static_cast<std::size_t>(placement.index));
    Camera camera;
    camera.name =
        printable(!placement.name.empty() ? placement.name : cursor.member("name").string(cursor.path()));
    const Cursor type = cursor.member("type");
    const std::string name = type.string();
    if (name == "perspective") {
      read_perspective(cursor.member("perspective"), camera);
    } else if (name == "orthographic") {
      read_orthographic(context, cursor.member("orthographic"), camera);
    } else {
      type.fail("is \"" + printable(name, 40) + "\"", "use perspective or orthographic");
    }
    camera.position = placement.to_world.translation - origin;
    read_axes(context, placement, camera);
    cameras.push_back(camera);
  }
  return cameras;
}

}  // namespace caustics::gltf
