// The light tracer against closed forms, box by box, in the errors that it states itself. The boxes are the
// picture's pixels, wide enough to hold many rays; the truth of each is the closed form's mean over it, folds
// included.
#include <array>
#include <cmath>
#include <cstdio>

#include "lab/reference/glass_bar.hpp"
#include "lab/reference/ring_floor.hpp"
#include "lab/reference/tracer/tracer.hpp"
#include "pipeline/effects/spectrum.hpp"
#include "pipeline/scene/light_samples.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/ray_queries.hpp"
#include "tests/support/scenes.hpp"
#include "tests/truth/prism.hpp"

namespace caustics::tracer {

namespace {

constexpr double kPi = 3.14159265358979323846;

// How fine and how long.
struct Effort {
  int boxes;  // a side of the picture
  int side;   // side^2 rays a batch
  int batches;
};
// 16.8 million rays a scene for the figures in docs/reference.md, 0.2 million for a run of the tests.
constexpr Effort kLong{40, 512, 64}, kShort{16, 128, 16};

// A scene seen straight from above, and the floor's irradiance in it, lux.
struct Case {
  std::string name;
  Scene scene{};
  std::vector<ExactShape> exact{};
  std::array<std::vector<double>, 3> truth{};  // by channel and the picture's pixels; empty: not compared
  std::vector<bool> hidden{};  // boxes that the closed form or the camera leaves out; empty: none
};

// Of one channel.
struct Figures {
  int channel = 0;
  int boxes = 0;          // that count
  double left_out = 0.0;  // share of the light in boxes that too few rays reach
  double stray = 0.0;     // share of the light where there should be none
  double l1 = 0.0;        // sum |difference| over the sum of the truth
  double stated = 0.0;    // 0.80 of the sum of the stated errors over the same: what l1 is if they are right
  double chi_square = 0.0;              // mean of (difference / stated error)^2
  double expected = 0.0, spread = 0.0;  // of chi_square, if they are right: mean and standard deviation
  double flux = 0.0,
         flux_error = 0.0;  // of all boxes over the truth's, and its standard error, from batch to batch
};

// A box that fewer rays of a batch reach has no normal error.
constexpr double kLeastRays = 8.0;

// The error of each box is estimated from as many batches: its square is distributed as F(1, n), n = batches
// - 1, with mean n / (n - 2) and variance 2 n^2 (n - 1) / ((n - 2)^2 (n - 4)). What one box has too much a
// neighbour may have too little: four correlations of -1/4 at most add a quarter to the variance of the mean.
void expect(int boxes, int batches, Figures& f) {
  const double n = batches - 1.0;
  f.expected = n / (n - 2.0);
  const double variance = 2.0 * n * n * (n - 1.0) / ((n - 2.0) * (n - 2.0) * (n - 4.0));
  f.spread = std::sqrt(1.25 * variance / boxes);
}

// One channel of the picture.
std::vector<double> channel_of(const std::vector<float>& values, int channel) {
  std::vector<double> result;
  for (std::size_t i = static_cast<std::size_t>(channel); i < values.size(); i += 3)
    result.push_back(static_cast<double>(values[i]));
  return result;
}

bool counts(const Case& c, std::size_t box) { return c.hidden.empty() || !c.hidden[box]; }

// Over all boxes that are not hidden, of the sums that the tracer keeps.
glm::dvec3 light_in(const Case& c, const std::vector<double>& sums) {
  glm::dvec3 light(0.0);
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (counts(c, i / 3)) light[static_cast<int>(i % 3)] += sums[i];
  return light;
}

// Of the batches' light in the picture: mean and standard error.
struct Flux {
  glm::dvec3 mean{0.0}, error{0.0};
};

// A tracer that has done its batches.
Flux trace(const Case& c, int batches, Tracer& tracer) {
  glm::dvec3 squares(0.0), before(0.0);
  for (int i = 0; i < batches; ++i) {
    REQUIRE(tracer.run_batch());
    const glm::dvec3 all = light_in(c, tracer.state().sum);
    squares += (all - before) * (all - before);
    before = all;
  }
  const double n = batches;
  const glm::dvec3 mean = before / n;
  return {mean, glm::sqrt(glm::max(squares / n - mean * mean, glm::dvec3(0.0)) / (n - 1.0))};
}

Figures compared(const Case& c, int channel, const Tracer& tracer, const Flux& flux, double lux_of_ray) {
  const std::vector<double>& truth = c.truth[static_cast<std::size_t>(channel)];
  const std::vector<double> picture = channel_of(tracer.caustic(), channel);
  const std::vector<double> error = channel_of(tracer.caustic_error(), channel);
  Figures f{.channel = channel};
  double light = 0.0, counted = 0.0, differences = 0.0, errors = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (!counts(c, i)) continue;
    light += truth[i];
    if (truth[i] == 0.0) f.stray += picture[i];
    if (!(truth[i] >= kLeastRays * lux_of_ray)) continue;
    const double difference = picture[i] - truth[i];
    ++f.boxes;
    counted += truth[i];
    differences += std::fabs(difference);
    errors += error[i];
    f.chi_square += difference * difference / (error[i] * error[i]);
  }
  f.left_out = 1.0 - counted / light;
  f.stray /= light;
  f.l1 = differences / counted;
  f.stated = 0.7979 * errors / counted;  // sqrt(2 / pi)
  f.chi_square /= f.boxes;
  f.flux = flux.mean[channel] / light;
  f.flux_error = flux.error[channel] / light;
  return f;
}

// Of each channel that is compared.
std::vector<Figures> figures_of(const Case& c, const Effort& effort) {
  Scene scene = c.scene;
  Settings settings;
  settings.width = settings.height = effort.boxes;
  sample_lights(scene, 1);
  const Effects effects = effects_of(scene, settings);
  TraceSettings wanted;
  wanted.width = wanted.height = effort.boxes;
  wanted.side = effort.side;
  wanted.exact = c.exact;
  Tracer tracer(scene, effects, scene.cameras.at(0), wanted);
  const Flux flux = trace(c, effort.batches, tracer);
  const Account& account = tracer.state().accounts.at(0);
  const double width = 2.0 * scene.cameras[0].half_width / effort.boxes;
  std::vector<Figures> figures;
  for (int channel = 0; channel < 3; ++channel) {
    if (c.truth[static_cast<std::size_t>(channel)].empty()) continue;
    const double lux_of_ray = account.entered[channel] / account.hits *
                              static_cast<double>(scene.lights[0].intensity) / (width * width);
    figures.push_back(compared(c, channel, tracer, flux, lux_of_ray));
    expect(figures.back().boxes, effort.batches, figures.back());
  }
  return figures;
}

// Rays start a scene's diameter before their caster, 12 m, where single precision places them to 7e-7 m: some
// that pass a silhouette as near as that meet the far side of its edge first. The prism has 1.6 m of
// silhouettes around 0.27 m^2.
constexpr double kAstray = 1e-5;

// No error that is not there is stated, and none hidden.
void check(const std::string& name, const Figures& f) {
  INFO(name << ", channel " << f.channel << ": " << f.boxes << " boxes, chi-square " << f.chi_square << " of "
            << f.expected << " +- " << f.spread << ", flux " << f.flux << " +- " << f.flux_error
            << ", left out " << f.left_out << ", stray " << f.stray);
  CHECK(f.boxes > 30);
  CHECK(std::fabs(f.chi_square - f.expected) < 3.0 * f.spread);
  CHECK(std::fabs(f.flux - 1.0) < 3.0 * f.flux_error + kAstray);
  CHECK(f.left_out < 0.05);
  CHECK(f.stray < kAstray);
}

void check(const Case& c) {
  test::need_ray_queries();
  for (const Figures& f : figures_of(c, kShort)) check(c.name, f);
}

FloorSquare square(double middle, double half, int boxes) {
  return {.lower = {middle - half, -half}, .side = 2.0 * half, .pixels = boxes};
}

// ---- The scenes, with the numbers of the sample scenes (scenes/README.md) but for the prism's light.

Case sphere_case(int boxes) {
  Case c{.name = "sphere", .scene = test::sphere_scene(1.5f, 2)};  // 320 triangles
  c.exact = {exact_shape_of(c.scene, 1, ShapeKind::Sphere)};
  const GlassSphere sphere{.radius = 0.5, .index = 1.5, .distance = 0.8};
  c.truth[1] = irradiance_average(sphere, square(0.0, 1.0, boxes), 64).values;
  return c;
}

Case slab_case(int boxes) {
  const double lean = 40.0 * kPi / 180.0;
  Case c{.name = "slab"};
  c.scene.materials = {test::diffuse(0.8f), test::glass(1.5f)};
  c.scene.meshes = {test::floor(4.0, 0.0, 0), test::box({-0.5, 0.5, -0.5}, {0.5, 0.8, 0.5}, 1)};
  c.scene.lights = {test::sun({std::sin(lean), -std::cos(lean), 0.0}, 1.0f)};
  c.scene.cameras = {test::camera_down(0.4, 1.0)};
  c.scene.cameras[0].position.x = 0.5;
  const GlassBar bar{.corners = {{-0.5, 0.5}, {0.5, 0.5}, {0.5, 0.8}, {-0.5, 0.8}},
                     .half_length = 0.5,
                     .travel = {std::sin(lean), -std::cos(lean)},
                     .index = 1.5};
  c.truth[1] = irradiance_average(bar, square(0.5, 1.0, boxes));
  return c;
}

// Gold, in its green; boxes that the ring stands on do not count.
Case ring_case(int boxes) {
  const MetalRing ring{.inner = 0.5,
                       .outer = 0.54,
                       .height = 0.18,
                       .elevation = std::atan(0.8),
                       .reflectance = static_cast<double>(0.78f)};
  Case c{.name = "ring"};
  c.scene.materials = {test::diffuse(0.8f), test::metal({1.0f, 0.78f, 0.34f})};
  c.scene.meshes = {test::floor(8.0, 0.0, 0), test::ring(ring.inner, ring.outer, ring.height, 64, 1)};
  c.scene.lights = {test::sun({1.0, -0.8, 0.0}, 1.0f)};
  c.scene.cameras = {test::camera_down(0.6, 0.8)};
  c.exact = {exact_shape_of(c.scene, 1, ShapeKind::Cylinder)};
  const FloorSquare floor = square(0.0, 0.8, boxes);
  c.truth[1] = irradiance_average(ring, floor);
  const double width = floor.side / boxes;
  for (int i = 0; i < boxes * boxes; ++i) {
    const glm::dvec2 p = floor.lower + width * glm::dvec2(i % boxes, i / boxes), q = p + width;
    const double farthest = glm::length(glm::max(glm::abs(p), glm::abs(q)));
    const double nearest = glm::length(glm::clamp(glm::dvec2(0.0), p, q));
    c.hidden.push_back(!(farthest < ring.inner || nearest > ring.outer));
  }
  return c;
}

Case water_case(int boxes) {
  WaterWave wave{.amplitude = 0.3 * 0.5 / (2.0 * kPi), .wave_number = 4.0 * kPi, .index = 1.33};
  wave.depth = 0.6 * wave.first_focus();
  Case c{.name = "water"};
  c.scene.materials = {test::diffuse(0.8f), test::glass(1.33f)};
  c.scene.meshes = {test::floor(2.5, 0.0, 0),
                    test::wave_sheet(1.0, wave.depth, wave.amplitude, wave.wave_number, 32, 1)};
  c.scene.stated_shapes = {
      {.mesh = 1,
       .kind = ShapeKind::Waves,
       .field = {.level = wave.depth, .waves = {{wave.amplitude, {wave.wave_number, 0.0}, 0.5 * kPi}}}}};
  c.scene.lights = {test::sun({0.0, -1.0, 0.0}, 1.0f)};
  // Not a whole number of cells wide, or no ray would ever cross the picture's border, and its flux have no
  // error.
  const double half = 0.47;
  c.scene.cameras = {test::camera_down(0.5 * wave.depth, half)};
  c.exact = {exact_shape_of(c.scene, 1, ShapeKind::Waves)};
  const std::vector<double> strips = irradiance_average(wave, -half, half, boxes, 1.0);
  for (int y = 0; y < boxes; ++y) c.truth[1].insert(c.truth[1].end(), strips.begin(), strips.end());
  return c;
}

// Vertical light: it enters by two sides.
Case prism_case(int boxes) {
  Material material = test::glass(1.5168f);
  material.dispersion = 0.3117f;
  const test::Prism prism(material);
  Case c{.name = "prism", .scene = prism.scene};
  c.scene.cameras = {test::camera_down(0.3, 1.0)};
  GlassBar bar{.half_length = 0.4};
  for (const auto& [a, b] :
       {std::pair{prism.base, prism.entry}, {prism.entry, prism.exit}, {prism.exit, prism.base}})
    bar.corners.push_back(prism.corner(a, b) + glm::dvec2(0.0, prism.height));
  const double n = static_cast<double>(material.ior), dispersion = static_cast<double>(material.dispersion);
  for (std::size_t i = 0; i < 3; ++i) {
    bar.index = dispersive_index(n, dispersion, std::array{kLineC, kLineD, kLineF}[i]);
    c.truth[i] = irradiance_average(bar, square(0.0, 1.0, boxes));
  }
  return c;
}

}  // namespace

TEST_CASE("tracer truth: an exact sphere's light, box by box in the error stated") {
  check(sphere_case(kShort.boxes));
}

TEST_CASE("tracer truth: a slab's light, box by box in the error stated") { check(slab_case(kShort.boxes)); }

TEST_CASE("tracer truth: an exact ring's light, box by box in the error stated") {
  check(ring_case(kShort.boxes));
}

TEST_CASE("tracer truth: exact waves' light, box by box in the error stated") {
  check(water_case(kShort.boxes));
}

TEST_CASE("tracer truth: a prism's three colours, box by box in the error stated") {
  check(prism_case(kShort.boxes));
}

TEST_CASE("tracer truth: figures of the reference against closed forms", "[.figures]") {
  // Not part of a run by default: it prints the figures of docs/reference.md.
  test::need_ray_queries();
  const int n = kLong.boxes;
  std::printf(
      "| scene | boxes | relative L1 | 0.80 x stated | chi-square | expected, +- 3 sigma | flux / truth | "
      "stray |\n"
      "|---|---|---|---|---|---|---|---|\n");
  for (const Case& c : {sphere_case(n), slab_case(n), ring_case(n), water_case(n), prism_case(n)})
    for (const Figures& f : figures_of(c, kLong)) {
      const char* const channels[] = {"red", "green", "blue"};
      std::printf("| %s, %s | %d | %.5f | %.5f | %.3f | %.3f +- %.3f | %.6f +- %.6f | %.0e |\n",
                  c.name.c_str(), channels[f.channel], f.boxes, f.l1, f.stated, f.chi_square, f.expected,
                  3.0 * f.spread, f.flux, f.flux_error, f.stray);
      check(c.name, f);
    }
}

}  // namespace caustics::tracer
