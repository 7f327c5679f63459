// The light tracer against closed forms, within the error that it states itself. All runs are fixed: the same
// numbers every time.
#include <cmath>

#include "lab/reference/closed_forms.hpp"
#include "lab/reference/half_ring.hpp"
#include "lab/reference/tracer/direct.hpp"
#include "pipeline/effects/spectrum.hpp"
#include "tests/truth/prism.hpp"
#include "tests/truth/tracer_run.hpp"

namespace caustics::tracer {

namespace {

// How the picture differs from the truth, in its own standard errors, over the pixels that `counts`.
// Normal errors give |difference| = 0.80 of the standard error on the mean.
struct Agreement {
  double mean_in_errors = 0.0;   // mean |difference| over mean standard error
  double total_in_errors = 0.0;  // |sum of differences| over the root of the sum of squared errors
  double total_error = 0.0;      // that root over the sum of the truth
};

template <class Counts>
Agreement agreement(const Tracer& tracer, const std::vector<double>& truth, Counts counts) {
  const std::vector<double> picture = red(tracer.caustic()), error = red(tracer.caustic_error());
  double differences = 0.0, errors = 0.0, total = 0.0, squares = 0.0, light = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (!counts(i)) continue;
    differences += std::fabs(picture[i] - truth[i]);
    errors += error[i];
    total += picture[i] - truth[i];
    squares += error[i] * error[i];
    light += truth[i];
  }
  return {differences / errors, std::fabs(total) / std::sqrt(squares), std::sqrt(squares) / light};
}

bool everywhere(std::size_t) { return true; }

}  // namespace

TEST_CASE("tracer truth: a slab passes what Fresnel's equations say, once and with all bounces") {
  test::need_ray_queries();
  const double incidence = 0.9, e = std::cos(incidence);
  const double r = fresnel(e, 1.0, 1.5).mean();
  const Run once(slab_scene(incidence), 8, 128, 8);
  const Run all(slab_scene(incidence), 8, 128, 8, Physics::Full);
  const double passed = e * slab_transmittance(incidence, 1.5, 0.2);
  const Agreement single = agreement(*once.tracer, std::vector<double>(64, passed), everywhere);
  CHECK(single.total_in_errors < 4.0);
  CHECK(single.total_error < 0.01);
  // Unpolarised at each bounce: the series (1 - r)^2 (1 + r^2 + ...).
  const std::vector<double> series(64, e * (1.0 - r) / (1.0 + r));
  const Agreement full = agreement(*all.tracer, series, everywhere);
  CHECK(full.total_in_errors < 4.0);
  CHECK(full.total_error < 0.01);
  check_closed(once.account());
  check_closed(all.account());
}

TEST_CASE("tracer truth: a glass sphere's floor is the closed form's within the error stated") {
  test::need_ray_queries();
  constexpr int kPixels = 40;
  const Run run(test::sphere_scene(1.5f, 6), kPixels, 256, 8);
  const GlassSphere sphere{.radius = 0.5, .index = 1.5, .distance = 0.8};
  const FloorIrradiance truth =
      irradiance_average(sphere, {.lower = {-1.0, -1.0}, .side = 2.0, .pixels = kPixels});
  const Agreement a = agreement(*run.tracer, truth.values, everywhere);
  CHECK(a.mean_in_errors < 1.0);
  CHECK(a.total_in_errors < 4.0);
  CHECK(run.tracer->relative_error() < 0.05);
  // All light that hits the disc, the share that passes it: the mesh lies within its sphere by 1e-4 of its
  // area.
  CHECK(run.account().entered.x / run.batches() == Approx(kPi * 0.25).epsilon(5e-4));
  const double share = (run.account().landed.x + run.account().missed.x) / run.account().entered.x;
  CHECK(share == Approx(sphere.transmitted_share()).epsilon(5e-4));
  check_closed(run.account());
}

TEST_CASE("tracer truth: an exact sphere in place of a coarse mesh has the closed form's light") {
  test::need_ray_queries();
  constexpr int kPixels = 40;
  Run run(test::sphere_scene(1.5f, 2), kPixels, 256, 0);  // 320 triangles
  run.trace.exact = {exact_shape_of(run.scene, 1, ShapeKind::Sphere)};
  run.tracer = std::make_unique<Tracer>(run.scene, run.effects, run.scene.cameras.at(0), run.trace);
  for (int i = 0; i < 8; ++i) REQUIRE(run.tracer->run_batch());
  const GlassSphere sphere{.radius = 0.5, .index = 1.5, .distance = 0.8};
  const Agreement a = agreement(
      *run.tracer, irradiance_average(sphere, {.lower = {-1.0, -1.0}, .side = 2.0, .pixels = kPixels}).values,
      everywhere);
  CHECK(a.mean_in_errors < 1.0);
  CHECK(a.total_in_errors < 4.0);
  CHECK(run.account().entered.x / 8.0 == Approx(kPi * 0.25).epsilon(1e-3));
  check_closed(run.account());
  CHECK(run.request() != Run(test::sphere_scene(1.5f, 2), kPixels, 256, 0).request());
}

TEST_CASE("tracer truth: a half ring draws the nephroid within the error stated") {
  test::need_ray_queries();
  constexpr int kPixels = 40;
  const double elevation = 0.25 * kPi;
  Scene scene;
  scene.materials = {test::diffuse(0.8f), test::metal({1.0f, 1.0f, 1.0f})};
  scene.meshes = {test::floor(3.0, 0.0, 0), test::half_ring(1.0, 0.8, 2048, 1)};
  scene.lights = {test::sun({std::cos(elevation), -std::sin(elevation), 0.0}, 1.0f)};
  scene.cameras = {test::camera_down(2.0, 1.0)};
  const Run run(std::move(scene), kPixels, 256, 8);
  std::vector<double> truth = irradiance_average(HalfRing{.radius = 1.0, .reach = 0.8 / std::tan(elevation)},
                                                 {.lower = {-1.0, -1.0}, .side = 2.0, .pixels = kPixels}, 16);
  for (double& value : truth) value *= std::sin(elevation);
  const auto inside = [&](std::size_t i) {
    const glm::dvec2 p = 2.0 * (glm::dvec2(i % kPixels, i / kPixels) + 0.5) / double(kPixels) - 1.0;
    return glm::length(p) < 0.95;
  };
  // The closed form is itself counted with 16 x 16 rays a pixel, so it is not exact at folds.
  const Agreement a = agreement(*run.tracer, truth, inside);
  CHECK(a.mean_in_errors < 1.3);
  check_closed(run.account());
}

TEST_CASE("tracer truth: a sine wave focuses as its closed form within the error stated") {
  test::need_ray_queries();
  constexpr int kPixels = 24;
  WaterWave wave{.amplitude = 0.3 * 0.5 / (2.0 * kPi), .wave_number = 2.0 * kPi / 0.5, .index = 1.33};
  wave.depth = 0.6 * wave.first_focus() - wave.amplitude;
  Scene scene;
  scene.materials = {test::diffuse(0.8f), test::glass(1.33f)};
  scene.meshes = {test::floor(1.5, 0.0, 0),
                  test::wave_sheet(0.5, wave.depth, wave.amplitude, wave.wave_number, 400, 1)};
  scene.lights = {test::sun({0.0, -1.0, 0.0}, 1.0f)};
  scene.cameras = {test::camera_down(0.5 * wave.depth, 0.25)};
  const Run run(std::move(scene), kPixels, 256, 8);
  const std::vector<double> strips = irradiance_average(wave, -0.25, 0.25, kPixels, 0.5);
  std::vector<double> truth;
  for (int y = 0; y < kPixels; ++y) truth.insert(truth.end(), strips.begin(), strips.end());
  const Agreement a = agreement(*run.tracer, truth, everywhere);
  CHECK(a.mean_in_errors < 1.0);
  CHECK(a.total_in_errors < 4.0);
  check_closed(run.account());
}

TEST_CASE("tracer truth: a prism turns each line by Snell's law") {
  test::need_ray_queries();
  Material material = test::glass(1.5168f);
  material.dispersion = 0.3117f;
  test::Prism prism(material);
  Scene scene = prism.scene;
  scene.cameras = {test::camera_down(0.3, 1.0)};
  const Run run(std::move(scene), 200, 512, 2);
  // The mean of the picture's light in x, of red, green and blue, against Snell's law at the three lines.
  const double lines[3] = {kLineC, kLineD, kLineF};
  const std::vector<float> picture = run.tracer->caustic();
  for (int c = 0; c < 3; ++c) {
    const double n = dispersive_index(1.5168, 0.3117, lines[c]);
    // By hand, point by point over the entry face; light that enters by the base lands elsewhere.
    const glm::dvec2 a = prism.corner(prism.base, prism.entry), b = prism.corner(prism.entry, prism.exit);
    double sum = 0.0, lower = 1e9, upper = -1e9;
    int count = 0;
    for (int k = 0; k < 20'000; ++k) {
      const glm::dvec2 p = a + (b - a) * ((k + 0.5) / 20'000);
      const auto p2 = prism.exit_point({p.x, p.y + prism.height, 0.0}, n);
      if (!p2) continue;
      const glm::dvec3 d1 = *refract_direction({0.0, -1.0, 0.0}, prism.normal(prism.entry), 1.0 / n);
      const glm::dvec3 d2 = *refract_direction(d1, -prism.normal(prism.exit), n);
      const double x = p2->x - d2.x / d2.y * p2->y;
      sum += x;
      lower = std::min(lower, x);
      upper = std::max(upper, x);
      ++count;
    }
    double flux = 0.0, moment = 0.0;
    for (std::size_t i = 0; i < picture.size() / 3; ++i) {
      const double x = 2.0 * (static_cast<double>(i % 200) + 0.5) / 200.0 - 1.0;
      const double z = 1.0 - 2.0 * (static_cast<double>(i / 200) + 0.5) / 200.0;
      if (std::fabs(z) > 0.3 || x < lower - 0.01 || x > upper + 0.01) continue;
      const double v = static_cast<double>(picture[3 * i + static_cast<std::size_t>(c)]);
      flux += v;
      moment += v * x;
    }
    INFO("channel " << c << " n " << n << " from " << lower << " to " << upper);
    CHECK(moment / flux == Approx(sum / count).margin(1e-3));
  }
  check_closed(run.account());
}

TEST_CASE("tracer truth: glass of index 1 is not there, up to the floor's very edge") {
  test::need_ray_queries();
  Scene scene;
  scene.materials = {test::diffuse(0.8f), test::glass(1.0f)};
  // A floor that is turned, so that its edges cut pixels at all places.
  Mesh floor = test::floor(0.6, 0.0, 0);
  for (Vertex& v : floor.vertices)
    v.position = {0.8f * v.position.x - 0.6f * v.position.z, 0.0f, 0.6f * v.position.x + 0.8f * v.position.z};
  test::finish(floor, 0.0f);
  scene.meshes = {floor, test::box({-1.5, 0.5, -1.5}, {1.5, 0.7, 1.5}, 1)};
  scene.lights = {test::sun({0.0, -1.0, 0.0}, 3.0f)};
  scene.cameras = {test::camera_down(0.3, 1.0)};
  const Run run(std::move(scene), 40, 400, 4);
  const std::vector<double> picture = red(run.tracer->caustic());
  int inner = 0, border = 0;
  for (std::size_t i = 0; i < picture.size(); ++i) {
    const Seen& seen = run.tracer->film().seen(i);
    if (seen.mesh < 0) {
      CHECK(picture[i] == 0.0);
      continue;
    }
    // 400 x 400 jittered rays over 3 x 3 m, 44 a pixel, in 4 batches; a pixel's share is counted to 1 in 64
    // or so.
    const bool whole = seen.share == 1.0;
    (whole ? inner : border) += 1;
    INFO(i << " share " << seen.share);
    CHECK(picture[i] == Approx(3.0).epsilon(whole ? 0.12 : 0.25));
  }
  CHECK(inner > 400);
  CHECK(border > 40);
}

TEST_CASE("tracer truth: from a point all light within a sphere's cone enters it") {
  test::need_ray_queries();
  Scene scene = test::sphere_scene(1.5f, 5);
  Light lamp{.name = "lamp", .type = LightType::Point, .intensity = 2.0f};
  lamp.position = {0.3, 2.0, 0.1};
  // Nearer, it stands in the box around the sphere, and rays go all around.
  Light near = lamp;
  near.position = {0.45, 1.25, 0.45};
  for (const Light& light : {lamp, near}) {
    scene.lights = {light};
    const Run run(scene, 16, 200, 2);
    const double distance = glm::length(light.position - glm::dvec3(0.0, 0.8, 0.0));
    const double angle = 2.0 * kPi * (1.0 - std::sqrt(1.0 - 0.25 / (distance * distance)));
    CHECK(run.account().entered.x / run.batches() == Approx(angle).epsilon(3e-3));
    check_closed(run.account());
  }
}

TEST_CASE("tracer truth: a lamp of some size sheds on a caster what its middle does, but for its size") {
  test::need_ray_queries();
  Scene scene = test::sphere_scene(1.5f, 5);
  const Light panel = panel_above(3.0, 1.0f, 0.2, 0.2);
  scene.lights = {panel};
  const Run run(std::move(scene), 16, 200, 2);
  // The cosine over a cone of half-angle t integrates to pi sin(t)^2. To second order in the lamp's size.
  const double expected = kPi * 0.25 / (2.2 * 2.2);
  CHECK(run.account().entered.x / run.batches() == Approx(expected).epsilon(5e-3));
  // What it sheds on the floor straight below, casters away: L A / d^2 nearly.
  check_closed(run.account());
}

TEST_CASE("tracer truth: direct light is shadowed by casters, and dims as it should") {
  test::need_ray_queries();
  Scene scene = test::sphere_scene(1.5f, 5);
  Light lamp{.name = "lamp", .type = LightType::Point, .intensity = 10.0f};
  lamp.position = {0.0, 3.0, 0.0};
  scene.lights = {lamp};
  const Run run(std::move(scene), 33, 8, 2);
  const std::vector<double> direct = red(direct_light(run.tracer->world(), run.tracer->film(), 0));
  // The middle lies in the sphere's shadow; at a corner E = I h / r^3.
  CHECK(direct[33 * 16 + 16] == 0.0);
  const double x = 2.0 * 0.5 / 33 - 1.0, r = std::sqrt(9.0 + 2.0 * x * x);
  CHECK(direct[0] == Approx(10.0 * 3.0 / (r * r * r)).epsilon(1e-6));
}

}  // namespace caustics::tracer
