#include "pipeline/scene/gltf/light_size.hpp"

#include "pipeline/scene/gltf/extras.hpp"

namespace caustics::gltf {

namespace {

constexpr double kLargest = 1e9;  // metres

// The node counts more.
Cursor extra(const Cursor& node, const Cursor& light, const char* key) {
  const Cursor of_node = extra(node, key);
  return of_node.present() ? of_node : extra(light, key);
}

void check_size(const Cursor& cursor, double value, double most, const char* what) {
  if (value >= 0.0 && value <= most) return;
  cursor.fail(std::string("must be ") + what, "correct it, or leave it out for a light without a size");
}

void read_radius(const Cursor& cursor, Light& light) {
  light.radius = cursor.number();
  check_size(cursor, light.radius, kLargest, "a radius from 0 to 1e9 metres");
  if (light.radius > 0.0) light.shape = LightShape::Sphere;
}

void read_rectangle(const Cursor& cursor, const exact::Affine& to_world, Light& light) {
  const std::vector<double> size = cursor.numbers(2);
  for (const double side : size) check_size(cursor, side, kLargest, "two sides from 0 to 1e9 metres");
  if (!(size[0] > 0.0 || size[1] > 0.0)) return;
  light.shape = LightShape::Rectangle;
  // The node's scale does not count, as for everything of a light.
  const glm::dvec3 up = exact::normalise(to_world.y, glm::dvec3(0));
  const glm::dvec3 right =
      exact::normalise(exact::cross(light.direction, up), exact::perpendicular(light.direction));
  light.width = right * size[0];
  light.height = exact::cross(right, light.direction) * size[1];
  light.lambertian = light.type == LightType::Point;
}

void read_angular_diameter(const Cursor& cursor, Light& light) {
  const double degrees = cursor.number();
  check_size(cursor, degrees, 180.0, "an angle from 0 to 180 degrees");
  if (!(degrees > 0.0)) return;
  light.shape = LightShape::Disk;
  light.angular_radius = degrees * (exact::kPi / 360.0);
}

}  // namespace

void read_size(Context& context, const Cursor& cursor, const Cursor& node, const exact::Affine& to_world,
               Light& light) {
  const Cursor radius = extra(node, cursor, "radius");
  const Cursor rectangle = extra(node, cursor, "rectangle");
  const Cursor angle = extra(node, cursor, "angular_diameter");
  const bool directional = light.type == LightType::Directional;
  for (const Cursor& other : {directional ? radius : angle, directional ? rectangle : angle}) {
    if (!other.present()) continue;
    context.note(other.path() +
                 (directional ? " is not for directional lights: " : " is for directional lights: ") +
                 "it is ignored.");
  }
  if (directional) {
    if (angle.present()) read_angular_diameter(angle, light);
    return;
  }
  if (radius.present() && rectangle.present()) {
    rectangle.fail("stands beside a radius", "give the light one of both");
  }
  if (radius.present()) read_radius(radius, light);
  if (rectangle.present()) read_rectangle(rectangle, to_world, light);
}

}  // namespace caustics::gltf
