// Area lights as samples: where they stand and what they carry.
#include "pipeline/scene/light_samples.hpp"

#include <set>

#include "pipeline/scene/emitter.hpp"
#include "pipeline/scene/exact.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/shapes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

Light ball(double radius) {
  Light light{.name = "ball", .type = LightType::Point, .intensity = 12.0f};
  light.position = {1.0, 2.0, 3.0};
  light.shape = LightShape::Sphere;
  light.radius = radius;
  return light;
}

Light disk(double degrees) {
  Light light = sun({0.3, -1.0, 0.2}, 5.0f);
  light.shape = LightShape::Disk;
  light.angular_radius = degrees * exact::kPi / 360.0;
  return light;
}

Scene sampled(const Light& light, int count) {
  Scene scene;
  scene.lights = {light};
  sample_lights(scene, count);
  return scene;
}

Scene glowing(Mesh mesh, const glm::vec3& nit, bool double_sided = false) {
  Scene scene;
  Material material = diffuse(0.5f);
  material.emissive = nit;
  material.double_sided = double_sided;
  mesh.material = 0;
  scene.materials = {material};
  scene.meshes = {std::move(mesh)};
  add_emissive_lights(scene);
  return scene;
}

}  // namespace

TEST_CASE("A light without a size, and one sample of any light, is the light itself") {
  for (const Light& light : {ball(0.5), disk(10.0), sun({0, -1, 0}, 1.0f)}) {
    const Scene scene = sampled(light, light.shape == LightShape::None ? 16 : 1);
    REQUIRE(scene.lights.size() == 1);
    CHECK(scene.lights[0].name == light.name);
    CHECK(scene.lights[0].intensity == light.intensity);
    CHECK(scene.lights[0].position == light.position);
    CHECK(scene.lights[0].direction == light.direction);
    CHECK(scene.lights[0].source == 0);
    CHECK(scene.sources.at(0).shape == light.shape);
  }
}

TEST_CASE("Samples share the intensity, have names of their own and know their source") {
  Scene scene;
  scene.lights = {sun({0, -1, 0}, 1.0f), ball(0.1), disk(1.0)};
  sample_lights(scene, 12);
  REQUIRE(scene.lights.size() == 25);
  CHECK(scene.sources.size() == 3);
  CHECK(scene.lights[1].name == "ball.00");
  CHECK(scene.lights[24].name == "sun.11");
  std::set<std::string> names;
  double sum = 0.0;
  for (std::size_t i = 1; i <= 12; ++i) {
    names.insert(scene.lights[i].name);
    sum += static_cast<double>(scene.lights[i].intensity);
    CHECK(scene.lights[i].source == 1);
    CHECK(scene.lights[i].shape == LightShape::None);
    CHECK(&source_of(scene, static_cast<int>(i)) == &scene.sources[1]);
  }
  CHECK(names.size() == 12);
  CHECK(sum == Approx(12.0));
}

TEST_CASE("From any side the samples of a sphere fill a disk evenly") {
  // Evenly filled: the mean square of each coordinate is R^2 / 4, and within half the radius lies a
  // quarter of the disk. 256 points of low discrepancy are good to a few percent.
  const Scene scene = sampled(ball(2.0), 256);
  for (int axis = 0; axis < 3; ++axis) {
    double square = 0.0;
    int inner = 0;
    for (const Light& sample : scene.lights) {
      const glm::dvec3 p = (sample.position - glm::dvec3(1, 2, 3)) / 2.0;
      CHECK(exact::length(p) <= 1.0 + 1e-12);
      const double a = p[(axis + 1) % 3], b = p[(axis + 2) % 3];
      square += p[axis] * p[axis] / 256.0;
      inner += a * a + b * b < 0.25 ? 1 : 0;
    }
    CHECK(square == Approx(0.25).epsilon(0.03));
    CHECK(inner / 256.0 == Approx(0.25).epsilon(0.1));
  }
}

TEST_CASE("A sun's samples lie evenly over the solid angle of its disk") {
  const Light light = disk(20.0);
  const Scene scene = sampled(light, 64);
  glm::dvec3 mean(0.0);
  double widest = 0.0;
  for (const Light& sample : scene.lights) {
    CHECK(exact::length(sample.direction) == Approx(1.0));
    widest = std::max(widest, std::acos(exact::dot(sample.direction, light.direction)));
    mean += sample.direction / 64.0;
  }
  CHECK(widest <= light.angular_radius);
  CHECK(widest > 0.98 * light.angular_radius);
  // The mean over a cap of half angle a is (1 + cos a) / 2 along its axis.
  CHECK(exact::dot(mean, light.direction) == Approx(0.5 * (1.0 + std::cos(light.angular_radius))));
  const glm::dvec3 aside = mean - light.direction * exact::dot(mean, light.direction);
  CHECK(exact::length(aside) < 0.005);
}

TEST_CASE("A rectangle's samples stay on it") {
  Light light = ball(0.0);
  light.shape = LightShape::Rectangle;
  light.width = {0.0, 0.0, 4.0};
  light.height = {1.0, 0.0, 0.0};
  glm::dvec3 square(0.0);
  for (const Light& sample : sampled(light, 64).lights) {
    const glm::dvec3 p = sample.position - light.position;
    CHECK(p.y == 0.0);
    CHECK(std::fabs(p.z) <= 2.0);
    CHECK(std::fabs(p.x) <= 0.5);
    square += p * p / 64.0;
  }
  CHECK(square.z == Approx(16.0 / 12.0).epsilon(0.03));
  CHECK(square.x == Approx(1.0 / 12.0).epsilon(0.03));
}

TEST_CASE("A mesh that shines is a light of luminance times area, on its outside") {
  Scene scene = glowing(box({-0.5, 0.5, -0.5}, {0.5, 1.5, 0.5}, 0), {10.0f, 5.0f, 0.0f});
  REQUIRE(scene.lights.size() == 1);
  CHECK(scene.lights[0].color == glm::vec3(1.0f, 0.5f, 0.0f));
  CHECK(scene.lights[0].intensity == Approx(60.0));
  CHECK_FALSE(scene.lights[0].is_ball());
  CHECK_FALSE(scene.lights[0].is_rectangle());
  sample_lights(scene, 100);
  glm::dvec3 mean(0.0);
  for (const Light& sample : scene.lights) {
    const glm::dvec3 out = sample.position - glm::dvec3(0, 1, 0);
    CHECK(sample.emitter == 0);
    CHECK(sample.lambertian);
    CHECK(exact::dot(out, sample.direction) == Approx(0.5));
    mean += sample.direction / 100.0;
  }
  CHECK(exact::length(mean) < 0.05);
}

TEST_CASE("A ball that shines shows a quarter of its area to each side, by samples within it") {
  Scene scene = glowing(sphere({0.0, 1.0, 0.0}, 0.5, 4, 0), {10.0f, 5.0f, 0.0f});
  REQUIRE(scene.lights.size() == 1);
  CHECK(scene.lights[0].is_ball());
  CHECK(scene.lights[0].radius == Approx(0.5).epsilon(0.002));
  CHECK(scene.lights[0].intensity == Approx(10.0 * exact::kPi).epsilon(0.003));
  sample_lights(scene, 16);
  double candela = 0.0, farthest = 0.0;
  for (const Light& sample : scene.lights) {
    CHECK(sample.emitter == 0);
    CHECK_FALSE(sample.lambertian);
    farthest = std::max(farthest, exact::length(sample.position - glm::dvec3(0, 1, 0)));
    candela += static_cast<double>(sample.intensity);
  }
  CHECK(farthest <= 0.5);
  CHECK(farthest > 0.25);
  CHECK(candela == Approx(10.0 * exact::kPi / 4.0).epsilon(0.003));
}

TEST_CASE("A sphere that shines inwards, or has something within it, is no ball of light") {
  Mesh inwards = sphere({0.0, 1.0, 0.0}, 0.5, 4, 0);
  inwards.inside_out = true;
  CHECK_FALSE(glowing(inwards, glm::vec3(3.0f)).lights.at(0).is_ball());
  const auto beside = [](double x) {
    Scene scene = glowing(sphere({0.0, 1.0, 0.0}, 0.5, 4, 0), glm::vec3(3.0f));
    scene.materials.push_back(diffuse(0.5f));
    scene.meshes.push_back(box({x, 0.5, -5.0}, {x + 10.0, 10.0, 5.0}, 1));
    const Bounds bounds = bounds_of(scene.meshes.back());
    scene.meshes.back().lower = bounds.lower;
    scene.meshes.back().upper = bounds.upper;
    return light_of_mesh(scene, 0).is_ball();
  };
  CHECK(beside(0.51));
  CHECK_FALSE(beside(0.45));
}

TEST_CASE("A flat rectangle that shines is known by its middle and its edges, whatever its triangles") {
  // 1 x 2 m, turned and leaning, of one square and of many.
  const glm::dvec3 x = exact::normalise({1.0, 0.5, 0.2}, {}), y = exact::perpendicular(x);
  const glm::dvec3 middle(3.0, 4.0, 5.0);
  for (const int cells : {1, 3}) {
    Mesh mesh = wave_sheet(1.0, 0.0, 0.0, 0.0, cells, 0);
    for (Vertex& v : mesh.vertices)
      v.position = glm::vec3(middle + x * (0.5 * double(v.position.x)) - y * double(v.position.z));
    const Light light = glowing(mesh, glm::vec3(3.0f)).lights.at(0);
    REQUIRE(light.is_rectangle());
    CHECK(exact::length(light.position - middle) < 1e-5);
    CHECK(exact::length(exact::cross(light.width, light.height)) == Approx(2.0));
    CHECK(exact::dot(light.direction, exact::cross(x, y)) == Approx(1.0));
    mesh.vertices.back().position += glm::vec3(0.1 * x);  // a corner that is drawn out
    CHECK_FALSE(glowing(mesh, glm::vec3(3.0f)).lights.at(0).is_rectangle());
  }
}

TEST_CASE("An open, double-sided sheet shines from both sides, a closed mesh outwards only") {
  const Scene one = glowing(floor(0.5, 1.0, 0), glm::vec3(3.0f));
  CHECK(one.lights.at(0).intensity == Approx(3.0));
  Scene two = glowing(floor(0.5, 1.0, 0), glm::vec3(3.0f), true);
  CHECK(two.lights.at(0).intensity == Approx(6.0));
  sample_lights(two, 10);
  int up = 0;
  for (const Light& sample : two.lights) up += sample.direction.y > 0.0 ? 1 : 0;
  CHECK(up == 5);
  const Mesh closed = box({-0.5, 0, -0.5}, {0.5, 1, 0.5}, 0);
  CHECK(glowing(closed, glm::vec3(1.0f), true).lights.at(0).intensity == Approx(6.0));
  CHECK(glowing(closed, glm::vec3(0.0f)).lights.empty());
}

TEST_CASE("A texture of what shines counts by its mean over the mesh, not over the whole picture") {
  // Three of four texels of the picture are white, the fourth black. The square shows the left half alone,
  // where one of two is white.
  Scene scene = glowing(floor(0.5, 1.0, 0), glm::vec3(0.0f));
  Image picture(Format::RGBA16F, 2, 2);
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}})
    for (int c = 0; c < 3; ++c) picture.at(x, y, c) = 1.0f;
  scene.images = {picture};
  scene.materials[0].emissive = {4.0f, 4.0f, 2.0f};
  scene.materials[0].emissive_texture.image = 0;
  Mesh& mesh = scene.meshes[0];
  for (Vertex& vertex : mesh.vertices)
    vertex.uv = {0.25f + 0.5f * vertex.position.x, 0.5f - vertex.position.z};
  add_emissive_lights(scene);
  REQUIRE(scene.lights.size() == 1);
  CHECK(scene.lights[0].intensity == Approx(2.0).epsilon(0.01));
  CHECK(scene.lights[0].color.z == Approx(0.5));
}

TEST_CASE("What is unlit or black does not shine") {
  Scene scene = glowing(floor(0.5, 1.0, 0), glm::vec3(1.0f));
  scene.lights.clear();
  scene.materials[0].unlit = true;
  add_emissive_lights(scene);
  CHECK(scene.lights.empty());
}

TEST_CASE("Samples know the disk or ball that they stand for, points the smallest that there is") {
  Scene scene = glowing(floor(0.5, 1.0, 0), glm::vec3(3.0f));
  Light point = ball(0.0);
  point.shape = LightShape::None;
  scene.lights.push_back(ball(0.4));
  scene.lights.push_back(point);
  scene.lights[0].samples = 2;
  sample_lights(scene, 4);
  REQUIRE(scene.lights.size() == 2 + 4 + 1);
  CHECK(scene.lights[0].sample_radius == Approx(std::sqrt(0.5 / exact::kPi)));
  CHECK(scene.lights[2].sample_radius == Approx(0.2));
  CHECK(scene.lights[6].sample_radius == Approx(1e-4 * std::sqrt(0.5)));
}
