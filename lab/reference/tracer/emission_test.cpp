// Points of lights, drawn evenly over their shapes.
#include "lab/reference/tracer/emission.hpp"

#include <array>
#include <cmath>
#include <functional>

#include "tests/support/catch.hpp"
#include "tests/support/shapes.hpp"

namespace caustics::tracer {

namespace {

constexpr int kSide = 24;

Light shaped(LightShape shape) {
  Light light;
  light.type = shape == LightShape::Disk ? LightType::Directional : LightType::Point;
  light.shape = shape;
  light.position = {0.4, 2.0, -0.7};
  light.direction = glm::normalize(glm::dvec3(0.2, -1.0, 0.3));
  light.radius = 0.3;
  light.width = {0.5, 0.1, 0.0};
  light.height = {-0.1, 0.5, 0.8};
  light.angular_radius = 0.2;
  return light;
}

// The mean of a function of a light's points, of the middles of even cells of u, v and w.
double mean(const LightShapePoints& points, const std::function<double(const LightPoint&)>& of) {
  double sum = 0.0;
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j)
      for (int k = 0; k < kSide; ++k)
        sum += of(points.point((i + 0.5) / kSide, (j + 0.5) / kSide, (k + 0.5) / kSide));
  return sum / (kSide * kSide * kSide);
}

// The mean place on a light, and the mean square of its distance from there along each of three axes.
struct Spread {
  glm::dvec3 middle{0.0};
  std::array<double, 3> squares{};
};

Spread spread_of(const LightShapePoints& points, const std::array<glm::dvec3, 3>& axes) {
  Spread spread;
  for (int c = 0; c < 3; ++c)
    spread.middle[c] = mean(points, [&](const LightPoint& p) { return p.position[c]; });
  for (std::size_t a = 0; a < 3; ++a)
    spread.squares[a] = mean(points, [&](const LightPoint& p) {
      const double along = glm::dot(p.position - spread.middle, axes[a]);
      return along * along;
    });
  return spread;
}

constexpr std::array<glm::dvec3, 3> kAxes{glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)};

}  // namespace

TEST_CASE("tracer emission: a light of every shape lies evenly around its place") {
  const Scene scene;
  for (const LightShape shape : {LightShape::None, LightShape::Sphere, LightShape::Rectangle}) {
    const Light light = shaped(shape);
    const LightShapePoints points(scene, light);
    INFO(static_cast<int>(shape));
    CHECK(points.has_size() == (shape != LightShape::None));
    const Spread spread = spread_of(points, kAxes);
    CHECK(glm::length(spread.middle - light.position) < 1e-12);
    for (int axis = 0; axis < 3; ++axis) {
      // An even sphere has a third of its radius' square along each axis, an even stretch a twelfth of its
      // own.
      const double expected =
          shape == LightShape::None ? 0.0
          : shape == LightShape::Sphere
              ? light.radius * light.radius / 3.0
              : (light.width[axis] * light.width[axis] + light.height[axis] * light.height[axis]) / 12.0;
      CHECK(spread.squares[static_cast<std::size_t>(axis)] ==
            Approx(expected).epsilon(2.0 / (kSide * kSide)));
    }
  }
}

TEST_CASE("tracer emission: a rectangle's corners are half its width and its height from its middle") {
  const Scene scene;
  const Light light = shaped(LightShape::Rectangle);
  const LightShapePoints points(scene, light);
  for (const double u : {0.0, 0.5, 1.0})
    for (const double v : {0.0, 0.5, 1.0}) {
      const glm::dvec3 expected = light.position + (u - 0.5) * light.width + (v - 0.5) * light.height;
      const LightPoint found = points.point(u, v, 0.3);
      INFO(u << " " << v);
      CHECK(glm::length(found.position - expected) < 1e-15);
      CHECK(found.direction == light.direction);
    }
}

TEST_CASE("tracer emission: a sphere's points lie on it") {
  const Scene scene;
  const Light light = shaped(LightShape::Sphere);
  const LightShapePoints points(scene, light);
  const double off = mean(points, [&](const LightPoint& p) {
    return std::fabs(glm::length(p.position - light.position) - light.radius);
  });
  CHECK(off < 1e-12);
}

TEST_CASE("tracer emission: a disk in the sky shines from all of its solid angle evenly") {
  const Scene scene;
  Light light = shaped(LightShape::Disk);
  for (const double wide : {0.0, 0.01, 0.2, 1.5, 3.0}) {
    light.angular_radius = wide;
    const LightShapePoints points(scene, light);
    INFO(wide);
    // A cap's cosines are spread evenly from 1 to that of its rim.
    const double least = std::cos(wide);
    CHECK(mean(points, [&](const LightPoint& p) { return glm::dot(p.direction, light.direction); }) ==
          Approx(0.5 * (1.0 + least)).epsilon(1e-12));
    for (int c = 0; c < 3; ++c)
      CHECK(mean(points, [&](const LightPoint& p) { return p.direction[c]; }) ==
            Approx(0.5 * (1.0 + least) * light.direction[c]).margin(1e-12));
    CHECK(mean(points, [&](const LightPoint& p) { return glm::length(p.position - light.position); }) == 0.0);
    CHECK(glm::dot(points.point(1.0, 0.3, 0.0).direction, light.direction) == Approx(least).margin(1e-12));
  }
}

TEST_CASE("tracer emission: a mesh shines from each of its triangles by its area, and from both sides") {
  Scene scene;
  scene.meshes = {test::floor(1.0, 0.5, 0)};
  Mesh& mesh = scene.meshes[0];
  // The corner that one triangle alone has is drawn out: it has three times the other's area.
  mesh.vertices = {
      {.position = {0, 0, 0}}, {.position = {1, 0, 0}}, {.position = {0, 0, 1}}, {.position = {-3, 0, 0}}};
  mesh.indices = {0, 2, 1, 0, 3, 2};
  Light light = shaped(LightShape::Mesh);
  light.emitter = 0;
  const LightShapePoints points(scene, light);
  // Middles of the triangles: (1/3, 0, 1/3) and (-1, 0, 1/3).
  const Spread spread = spread_of(points, kAxes);
  CHECK(spread.middle.x == Approx(0.25 / 3.0 - 0.75).epsilon(2.0 / kSide));
  CHECK(spread.middle.y == Approx(0.0).margin(1e-15));
  CHECK(spread.middle.z == Approx(1.0 / 3.0).epsilon(2.0 / kSide));
  CHECK(mean(points, [](const LightPoint& p) { return p.position.x > 0.0 ? 1.0 : 0.0; }) == Approx(0.25));
  CHECK(mean(points, [](const LightPoint& p) { return p.direction.y; }) == Approx(0.0).margin(1e-12));
  CHECK(mean(points, [](const LightPoint& p) { return std::fabs(p.direction.y); }) == Approx(1.0));
}

}  // namespace caustics::tracer
