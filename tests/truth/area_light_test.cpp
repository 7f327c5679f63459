// Area lights against what is known of them in closed form.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "pipeline/scene/emitter.hpp"
#include "pipeline/scene/light_samples.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

constexpr double kPi = 3.14159265358979323846;

Light sun_disk(double half_angle) {
  Light light = sun({0.0, -1.0, 0.0}, 1.0f);
  light.shape = LightShape::Disk;
  light.angular_radius = half_angle;
  return light;
}

Light lamp(const glm::dvec3& position) {
  Light light{.name = "lamp", .type = LightType::Point, .intensity = 2.0f};
  light.position = position;
  light.shape = LightShape::Sphere;
  light.radius = 0.1;
  return light;
}

// The ledger of one light by `count` samples, relative to the light's own intensity.
Ledger sampled_ledger(Scene scene, int count) {
  sample_lights(scene, count);
  const Settings settings = through_two_surfaces(small_settings(96, 96, 16));
  const Rendering r = render(scene, settings, {kCausticMap, kLandingFresnel, kLandingAbsorbed});
  Ledger sum;
  for (int i = 0; i < count; ++i) add(sum, ledger_of(r, settings, i), 1.0 / count);
  return sum;
}

// Lux on the floor, from the light and its caustics.
double irradiance(const Rendering& r, int x, int y) {
  return double(r["aov_direct"].at(x, y, 0)) + double(r["aov_caustic"].at(x, y, 0));
}

double brightest(Scene scene, int count, int pixels) {
  sample_lights(scene, count);
  const Settings settings = through_two_surfaces(small_settings(192, 192, pixels));
  const Rendering r = render(scene, settings, {"aov_direct", "aov_caustic"});
  double most = 0.0;
  for (int y = 0; y < pixels; ++y)
    for (int x = 0; x < pixels; ++x) most = std::max(most, irradiance(r, x, y));
  return most;
}

// Of a disk, the part on one side of a chord at `s` radii from the middle.
double disk_share(double s) {
  s = std::clamp(s, -1.0, 1.0);
  return (0.5 * kPi + std::asin(s) + s * std::sqrt(1.0 - s * s)) / kPi;
}

// A level floor in the light of `lights`, seen from above over 2 half x 2 half m; nothing else.
Scene open_floor(double half) {
  Scene scene;
  scene.materials = {diffuse(0.8f)};
  scene.meshes = {floor(6.0, 0.0, 0)};
  scene.cameras = {camera_down(0.5, half)};
  return scene;
}

// The form factor from a level patch at the origin to a rectangle h above it, from x0 to x1 and z0 to z1: the
// signed sum of that of rectangles over their corner (Hottel and Sarofim 1967).
double form_factor(double h, double x0, double x1, double z0, double z1) {
  const auto corner = [h](double a, double b) {
    a /= h;
    b /= h;
    const double p = std::sqrt(1.0 + a * a), q = std::sqrt(1.0 + b * b);
    return (a / p * std::atan(b / p) + b / q * std::atan(a / q)) / (2.0 * kPi);
  };
  return corner(x1, z1) - corner(x0, z1) - corner(x1, z0) + corner(x0, z0);
}

// A floor below a square panel of half side 0.5 m that shines downwards, 100 nit.
Scene under_panel(double height, double seen) {
  Scene scene = open_floor(seen);
  Mesh panel = floor(0.5, height, 1);
  std::reverse(panel.indices.begin(), panel.indices.end());
  scene.meshes.push_back(panel);
  scene.materials.push_back(diffuse(0.5f));
  scene.materials[1].double_sided = false;
  scene.materials[1].emissive = glm::vec3(100.0f);
  scene.cameras = {camera_down(0.5 * height, seen)};
  add_emissive_lights(scene);
  return scene;
}

}  // namespace

TEST_CASE("area light: the flux does not depend on the number of samples") {
  // A sphere has the silhouette pi r^2 from everywhere, so what enters differs only by the sampling
  // of the silhouette on a grid of 96 x 96: some 5e-4 of it for each sample.
  for (const double half_angle : {0.00465, 0.1}) {
    Scene scene = sphere_scene(1.5f);
    scene.lights = {sun_disk(half_angle)};
    for (const int count : {1, 4, 16}) {
      const Ledger l = sampled_ledger(scene, count);
      INFO(count << " samples of half angle " << half_angle);
      CHECK(l.entered[0] == Approx(0.25 * kPi).epsilon(2e-3));
      CHECK(l.in_map[0] / l.entered[0] == Approx(0.8355).epsilon(0.01));
      CHECK(l.residual() < 1e-5);
    }
  }
}

TEST_CASE("area light: a lamp near the glass gives each sample the cone that it sees") {
  // From d the sphere fills 2 pi (1 - sqrt(1 - (r / d)^2)). Over a lamp of radius 0.1 m at 2 m the
  // mean of that is the lamp's middle's, but for how far the samples' own middle lies aside: a
  // tenth of the radius, 2 * 0.01 / 2 of the flux.
  const auto cone = [](double d) { return 2.0 * kPi * (1.0 - std::sqrt(1.0 - 0.25 / (d * d))); };
  Scene scene = sphere_scene(1.5f);
  scene.lights = {lamp({0.0, 2.8, 0.0})};
  for (const int count : {1, 4, 16}) {
    Scene sampled = scene;
    sample_lights(sampled, count);
    double expected = 0.0;
    for (const Light& sample : sampled.lights)
      expected += cone(glm::length(sample.position - glm::dvec3(0.0, 0.8, 0.0))) / count;
    const double entered = sampled_ledger(scene, count).entered[0];
    INFO(count << " samples");
    CHECK(entered == Approx(expected).epsilon(2e-3));
    CHECK(entered == Approx(cone(2.0)).epsilon(0.01));
  }
}

TEST_CASE("area light: the penumbra of an edge is as wide as the sun seen from it") {
  // A square sheet 1 m above the floor, its edge at x = 1, under a sun of half angle 5 degrees: the
  // penumbra is 2 h tan a wide, and within it the sun is a disk cut by a chord.
  const double half_angle = 5.0 * kPi / 180.0, reach = std::tan(half_angle);
  Scene scene = open_floor(1.4);
  scene.meshes.push_back(floor(1.0, 1.0, 0));
  scene.lights = {sun_disk(half_angle)};
  sample_lights(scene, 64);
  const int pixels = 280;
  Settings settings = small_settings(8, 8, pixels);
  settings.shadow = 512;
  const Rendering r = render(scene, settings, {"aov_direct"});
  const double full = 0.5 * (1.0 + std::cos(half_angle));
  double first = 0.0, last = 0.0, worst = 0.0;
  for (int x = pixels / 2; x < pixels; ++x) {
    const double at = (x + 0.5) / pixels * 2.8 - 1.4;
    const double lit = double(r["aov_direct"].at(x, pixels / 2, 0)) / full;
    if (lit < 0.004) first = at;
    if (lit < 0.996) last = at;
    worst = std::max(worst, std::fabs(lit - disk_share((at - 1.0) / reach)));
  }
  INFO("penumbra " << last - first << " m, expected " << 2.0 * reach << "; worst " << worst);
  // Texels of pixel and shadow map are 1 cm each; the outermost samples stand just within the rim.
  CHECK(last - first == Approx(2.0 * reach).margin(0.015));
  CHECK(0.5 * (first + last) == Approx(1.0).margin(0.01));
  // 64 samples: each step of the stair is a 64th, and some fall together.
  CHECK(worst < 0.06);
}

TEST_CASE("area light: no caustic is brighter than its sun") {
  // The brightness theorem: in air at most E / sin^2 a. A sun without a size knows no bound; in the
  // focus of the sphere it is far above what one of 20 degrees may give.
  const double half_angle = 20.0 * kPi / 180.0;
  const double bound = 1.0 / (std::sin(half_angle) * std::sin(half_angle));
  Scene scene = sphere_scene(1.5f);
  scene.lights = {sun_disk(half_angle)};
  const double sharp = brightest(scene, 1, 128), soft = brightest(scene, 64, 128);
  INFO("without a size " << sharp << ", with it " << soft << ", bound " << bound);
  CHECK(sharp > 2.0 * bound);
  CHECK(soft < bound);
  CHECK(soft > 0.2 * bound);
}

TEST_CASE(
    "area light: a panel that shines lights the floor by its form factor, near and far, below and aside") {
  struct Case {
    double height;
    int samples;
    // Of the irradiance below the middle. The middle of few samples lies some centimetres aside: 9 % by 16.
    double tolerance;
  };
  for (const Case& c : {Case{0.5, 64, 0.05}, Case{1.0, 64, 0.02}, Case{1.0, 16, 0.10}, Case{4.0, 4, 0.02}}) {
    Scene scene = under_panel(c.height, 1.0);
    sample_lights(scene, c.samples);
    const int pixels = 9;
    Settings settings = small_settings(8, 8, pixels);
    settings.shadow = 16;
    const Rendering r = render(scene, settings, {"aov_direct"});
    const double middle = 100.0 * kPi * form_factor(c.height, -0.5, 0.5, -0.5, 0.5);
    for (int y = 0; y < pixels; ++y) {
      for (int x = 0; x < pixels; ++x) {
        const double px = (x + 0.5) * 2.0 / pixels - 1.0, pz = (y + 0.5) * 2.0 / pixels - 1.0;
        const double expected = 100.0 * kPi * form_factor(c.height, -0.5 - px, 0.5 - px, -0.5 - pz, 0.5 - pz);
        INFO(c.samples << " samples " << c.height << " m above, " << px << ", " << pz << " aside");
        CHECK(double(r["aov_direct"].at(x, y, 0)) == Approx(expected).margin(c.tolerance * middle));
      }
    }
  }
}

TEST_CASE("area light: nothing is lit more than pi times the luminance of what shines, however near it is") {
  // Half a millimetre below the panel every place sees nothing but the panel, so that E = pi L; the samples,
  // some centimetres apart, show as spots, none of them brighter than that.
  Scene scene = under_panel(0.0005, 0.3);
  scene.cameras = {camera_down(0.5, 0.3)};  // the panel's back is not drawn
  sample_lights(scene, 16);
  Settings settings = small_settings(8, 8, 64);
  settings.shadow = 16;
  settings.highlights = true;
  const Rendering r = render(scene, settings, {"aov_direct", "beauty"});
  double most = 0.0, radiance = 0.0;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      most = std::max(most, double(r["aov_direct"].at(x, y, 0)));
      radiance = std::max(radiance, double(r["beauty"].at(x, y, 0)));
    }
  }
  CHECK(most > 0.0);
  CHECK(most <= 100.0 * kPi * 1.0001);
  CHECK(radiance < 150.0);
}

TEST_CASE("area light: a flat lamp lights neither itself nor the ceiling that it is flush with") {
  // The camera looks at the panel and the ceiling around it, both in one plane, level or so tilted that
  // rounding lifts places of the ceiling before the panel.
  const double angle = GENERATE(0.0, 0.3, 1.1);
  const glm::dmat3 turn(glm::rotate(glm::dmat4(1.0), angle, glm::dvec3(1.0, 0.0, 0.0)));
  Scene scene = open_floor(1.0);
  Mesh panel = floor(0.5, 1.0, 1);
  std::reverse(panel.indices.begin(), panel.indices.end());
  scene.materials.push_back(diffuse(0.5f));
  scene.materials[1].emissive = glm::vec3(100.0f);
  scene.meshes = {panel, floor(2.0, 1.0, 0)};
  for (Mesh& mesh : scene.meshes) {
    for (Vertex& v : mesh.vertices) {
      v.position = glm::vec3(turn * glm::dvec3(v.position));
      v.normal = glm::vec3(turn * glm::dvec3(v.normal));
    }
    finish(mesh, 0.0f);
  }
  Camera up = camera_down(0.0, 1.0);
  up.forward = turn * glm::dvec3(0.0, 1.0, 0.0);
  up.right = {-1.0, 0.0, 0.0};
  up.up = turn * glm::dvec3(0.0, 0.0, -1.0);
  up.position = 0.5 * up.forward;
  scene.cameras = {up};
  add_emissive_lights(scene);
  sample_lights(scene, 16);
  Settings settings = small_settings(8, 8, 33);
  settings.shadow = 16;
  const Rendering r = render(scene, settings, {"aov_direct"});
  INFO("turned by " << angle);
  for (int y = 0; y < 33; ++y)
    for (int x = 0; x < 33; ++x) REQUIRE(r["aov_direct"].at(x, y, 0) == 0.0f);
}

TEST_CASE("area light: a ball that shines lights the floor as a disk of its size") {
  // Luminance 1000, radius 0.1, its centre 0.9 m above the floor: E = pi L (R / d)^2. Half the
  // samples look away, and 64 of them are good to a percent.
  Scene scene = open_floor(0.05);
  scene.materials.push_back(diffuse(0.5f));
  scene.materials[1].emissive = glm::vec3(1000.0f);
  scene.meshes.push_back(sphere({0.0, 0.9, 0.0}, 0.1, 4, 1));
  scene.cameras = {camera_down(0.2, 0.05)};
  add_emissive_lights(scene);
  sample_lights(scene, 64);
  Settings settings = small_settings(8, 8, 3);
  settings.shadow = 16;
  const Rendering r = render(scene, settings, {"aov_direct"});
  CHECK(double(r["aov_direct"].at(1, 1, 0)) == Approx(1000.0 * kPi / 81.0).epsilon(0.015));
}

TEST_CASE("area light: the light that the camera sees is the sum of each sample drawn alone, to the bit") {
  constexpr int kSamples = 3;
  Settings settings = small_settings(32, 32, 24);
  settings.drawn = false;
  Scene scene = sphere_scene(1.5f, 4);
  scene.lights[0].shape = LightShape::Disk;
  scene.lights[0].angular_radius = 0.05;
  sample_lights(scene, kSamples);
  const auto drawn = [&](const Scene& lit) { return render(lit, settings, {"direct", "caustic"}); };
  const Rendering all = drawn(scene);
  std::map<std::string, std::vector<float>> sums;
  for (int k = 0; k < kSamples; ++k) {
    Scene alone = scene;
    alone.lights = {scene.lights[static_cast<std::size_t>(k)]};
    const Rendering one = drawn(alone);
    for (const char* name : {"direct", "caustic"}) {
      std::vector<float>& sum = sums[name];
      sum.resize(one[name].values.size());
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += one[name].values[i];
    }
  }
  for (const auto& [name, sum] : sums) {
    CHECK(std::any_of(sum.begin(), sum.end(), [](float value) { return value > 0.0f; }));
    CHECK(all[name].values == sum);
  }
}

TEST_CASE("area light: a caustic that is drawn at once is that of many samples") {
  // By blocks of 4 x 4 pixels.
  const auto caustic = [](bool drawn) {
    Settings settings = small_settings(256, 64, 32);
    settings.drawn = drawn;
    settings.further_share = 0.0f;
    Scene scene = sphere_scene(1.5f, 4);
    scene.lights = {sun_disk(0.1)};
    sample_lights(scene, 16);
    const Rendering drawing = render(scene, settings, {"aov_caustic"});
    std::vector<double> blocks(64, 0.0);
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 32; ++x)
        blocks[static_cast<std::size_t>(y / 4 * 8 + x / 4)] += double(drawing["aov_caustic"].at(x, y, 0));
    return blocks;
  };
  const std::vector<double> at_once = caustic(true), sampled = caustic(false);
  double all = 0.0, once = 0.0, differences = 0.0;
  for (std::size_t i = 0; i < sampled.size(); ++i) {
    all += sampled[i];
    once += at_once[i];
    differences += std::fabs(at_once[i] - sampled[i]);
  }
  CHECK(once == Approx(all).epsilon(0.015));
  CHECK(differences < 0.04 * all);
}
