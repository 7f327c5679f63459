// The light tracer against closed forms, within the error that it states itself. All runs are fixed: the same
// numbers every time.
#include <cmath>

#include "lab/reference/closed_forms.hpp"
#include "lab/reference/half_ring.hpp"
#include "lab/reference/tracer/direct.hpp"
#include "lab/reference/tracer/state_file.hpp"
#include "pipeline/effects/spectrum.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/scene/light_samples.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/ray_queries.hpp"
#include "tests/support/scenes.hpp"
#include "tests/truth/prism.hpp"

namespace caustics::tracer {

namespace {

constexpr double kPi = 3.14159265358979323846;

// A scene, what it calls for, and a tracer on it.
struct Run {
  Scene scene;
  Settings settings;
  Effects effects;
  TraceSettings trace;
  std::unique_ptr<Tracer> tracer;

  Run(Scene from, int pixels, int side, int batches, Physics physics = Physics::Single, Settings with = {},
      int threads = 0)
      : scene(std::move(from)), settings(std::move(with)) {
    settings.width = settings.height = pixels;
    sample_lights(scene, 1);
    effects = effects_of(scene, settings);
    trace.width = trace.height = pixels;
    trace.side = side;
    trace.physics = physics;
    trace.threads = threads;
    tracer = std::make_unique<Tracer>(scene, effects, scene.cameras.at(0), trace);
    for (int i = 0; i < batches; ++i) REQUIRE(tracer->run_batch());
  }
  const Account& account() const { return tracer->state().accounts.at(0); }
  double batches() const { return static_cast<double>(tracer->state().batches); }
  std::string request() const { return request_text(scene, effects, scene.cameras.at(0), trace); }
};

// Red of each pixel.
std::vector<double> red(const std::vector<float>& values) {
  std::vector<double> result;
  for (std::size_t i = 0; i < values.size(); i += 3) result.push_back(static_cast<double>(values[i]));
  return result;
}

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

void check_closed(const Account& a) {
  const glm::dvec3 gap = a.gap();
  CHECK(std::max({std::fabs(gap.x), std::fabs(gap.y), std::fabs(gap.z)}) < 1e-12 * a.entered.x);
}

// The line with which something is refused; empty where it is not.
template <class Act>
std::string refusal(Act act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

bool says(const std::string& line, const std::string& part) { return line.find(part) != std::string::npos; }

// Light at an angle through a wide slab; the camera sees where it entered through the top alone.
Scene slab_scene(double incidence) {
  Scene scene;
  scene.materials = {test::diffuse(0.8f), test::glass(1.5f)};
  scene.meshes = {test::floor(3.0, 0.0, 0), test::box({-1.5, 0.5, -1.5}, {1.5, 0.7, 1.5}, 1)};
  scene.lights = {test::sun({std::sin(incidence), -std::cos(incidence), 0.0}, 1.0f)};
  scene.cameras = {test::camera_down(0.3, 0.3)};
  return scene;
}

// A lamp that shines down from so many metres above the middle, so wide along x and z.
Light panel_above(double height, float candela, double along_x, double along_z) {
  Light panel{.name = "panel", .type = LightType::Point, .intensity = candela};
  panel.position = {0.0, height, 0.0};
  panel.direction = {0.0, -1.0, 0.0};
  panel.lambertian = true;
  panel.shape = LightShape::Rectangle;
  panel.width = {along_x, 0.0, 0.0};
  panel.height = {0.0, 0.0, along_z};
  return panel;
}

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

TEST_CASE("tracer: the picture has the same bits for one thread and for three") {
  test::need_ray_queries();
  for (const Physics physics : {Physics::Single, Physics::Full}) {
    const Run one(test::sphere_scene(1.5f, 4), 24, 200, 3, physics, {}, 1);
    const Run three(test::sphere_scene(1.5f, 4), 24, 200, 3, physics, {}, 3);
    CHECK(one.tracer->state().sum == three.tracer->state().sum);
    CHECK(one.tracer->state().squares == three.tracer->state().squares);
    CHECK(to_bytes(one.tracer->state(), "") == to_bytes(three.tracer->state(), ""));
    check_closed(one.account());
  }
}

TEST_CASE("tracer: a run that was broken off goes on to the same bits") {
  test::need_ray_queries();
  const Run whole(test::sphere_scene(1.5f, 4), 24, 64, 5);
  const Run first(test::sphere_scene(1.5f, 4), 24, 64, 2);
  Run then(test::sphere_scene(1.5f, 4), 24, 64, 0);
  const std::string kept = to_bytes(first.tracer->state(), first.request());
  then.tracer->restore(from_bytes(kept, then.request(), then.tracer->state()));
  // A batch that is broken off leaves nothing.
  CHECK_FALSE(then.tracer->run_batch([] { return true; }));
  for (int i = 0; i < 3; ++i) REQUIRE(then.tracer->run_batch());
  CHECK(to_bytes(then.tracer->state(), "") == to_bytes(whole.tracer->state(), ""));
}

TEST_CASE("tracer: the state of another request is refused, and says what differs") {
  test::need_ray_queries();
  const Run run(test::sphere_scene(1.5f, 3), 8, 8, 1);
  const std::string kept = to_bytes(run.tracer->state(), run.request());
  const auto refused = [&](const Run& other, const std::string& why) {
    const std::string line = refusal([&] { from_bytes(kept, other.request(), other.tracer->state()); });
    INFO(line);
    CHECK(says(line, why));
  };
  refused(Run(test::sphere_scene(1.5f, 3), 9, 8, 0), "size: 8x8 there, size: 9x9 here");
  refused(Run(test::sphere_scene(1.5f, 3), 8, 9, 0), "rays: 8 there, rays: 9 here");
  refused(Run(test::sphere_scene(1.5f, 3), 8, 8, 0, Physics::Full), "physics: single there");
  refused(Run(test::sphere_scene(1.6f, 3), 8, 8, 0), "scene: ");
  const auto of = [&](const std::string& bytes) {
    return refusal([&] { from_bytes(bytes, run.request(), run.tracer->state()); });
  };
  CHECK(of(kept).empty());
  CHECK(says(of(kept.substr(0, kept.size() - 1)), "damaged"));
  CHECK(says(of("nonsense"), "no state"));
}

TEST_CASE("tracer: what glass mirrors lands where that is asked for, and the ledger closes") {
  test::need_ray_queries();
  Settings with;
  with.reflections = true;
  const Run off(test::sphere_scene(1.5f, 4), 8, 128, 2),
      on(test::sphere_scene(1.5f, 4), 8, 128, 2, Physics::Single, with);
  check_closed(on.account());
  // What is followed now is no longer lost to Fresnel.
  const auto reached = [](const Account& a) { return a.landed.x + a.missed.x; };
  CHECK(off.account().fresnel.x - on.account().fresnel.x ==
        Approx(reached(on.account()) - reached(off.account())).epsilon(1e-9));
  // That is what the first surface mirrors, in the mean over a sphere's disc; the second's is not followed.
  CHECK((off.account().fresnel.x - on.account().fresnel.x) / on.account().entered.x ==
        Approx(0.09178).epsilon(5e-3));
}

TEST_CASE("tracer: a tinted solid absorbs as Beer and Lambert say") {
  test::need_ray_queries();
  Scene scene = test::sphere_scene(1.0f, 6);
  scene.materials[1].attenuation_color = {0.5f, 1.0f, 0.25f};
  scene.materials[1].attenuation_distance = 1.0f;
  const Run run(std::move(scene), 8, 256, 2);
  // With n = 1 the chords are straight; no interface takes anything.
  const GlassSphere sphere{.radius = 0.5, .index = 1.0, .distance = 0.8, .absorption = std::log(2.0)};
  CHECK(run.account().landed.x / run.account().entered.x == Approx(mean_absorption(sphere)).epsilon(2e-3));
  CHECK(run.account().landed.y == Approx(run.account().entered.y).epsilon(1e-9));
  check_closed(run.account());
}

TEST_CASE("tracer: a body's colour tints light once, from outside and from within") {
  test::need_ray_queries();
  Scene scene = slab_scene(0.0);
  scene.materials[1] = test::glass(1.0f);  // so that nothing else takes any
  scene.materials[1].base_color = {0.5f, 1.0f, 0.25f, 1.0f};
  Light lamp{.name = "lamp", .type = LightType::Point, .intensity = 1.0f};
  lamp.position = {0.1, 0.6, 0.2};  // between the slab's faces
  for (const Light& light : {scene.lights[0], lamp}) {
    scene.lights = {light};
    for (const Physics physics : {Physics::Single, Physics::Full}) {
      const Run run(scene, 4, 32, 2, physics);
      const Account& a = run.account();
      REQUIRE(a.entered.x > 0.0);
      const glm::dvec3 left = (a.landed + a.missed) / a.entered;
      INFO(light.name << " " << int(physics));
      CHECK(left.x == Approx(0.5).epsilon(1e-9));
      CHECK(left.y == Approx(1.0).epsilon(1e-9));
      CHECK(left.z == Approx(0.25).epsilon(1e-9));
      check_closed(a);
    }
  }
}

TEST_CASE("tracer truth: a long panel lights the floor by its form factor") {
  test::need_ray_queries();
  // 4 m x 0.5 m, a metre above the floor, of luminance 1.
  const Light panel = panel_above(1.0, 2.0f, 4.0, 0.5);
  Scene scene;
  scene.materials = {test::diffuse(0.8f), test::glass(1.5f)};
  scene.meshes = {test::floor(9.0, 0.0, 0), test::sphere({8.0, 0.2, 8.0}, 0.1, 2, 1)};
  scene.lights = {panel};
  scene.cameras = {test::camera_down(0.5, 1e-3)};
  const Run run(std::move(scene), 5, 8, 0);
  // A quarter of it from beneath a corner, a by b at a distance of 1 (Siegel and Howell's configuration 3).
  const double a = 2.0, b = 0.25, x = std::hypot(1.0, a), y = std::hypot(1.0, b);
  const double expected = 4.0 * 0.5 * (a / x * std::atan(b / x) + b / y * std::atan(a / y));
  double sum = 0.0;
  for (const double value : red(direct_light(run.tracer->world(), run.tracer->film(), 0)))
    sum += value / 25.0;
  CHECK(sum == Approx(expected).epsilon(5e-3));
}

TEST_CASE("tracer: what stands before a caster keeps its light away") {
  if (!has_ray_queries()) return;
  // A board over the half of the sphere that lies at x > 0.
  Scene scene = test::sphere_scene(1.5f, 4);
  scene.meshes.push_back(test::box({0.0, 2.0, -1.0}, {1.0, 2.1, 1.0}, 0));
  const Run half(std::move(scene), 8, 128, 2), whole(test::sphere_scene(1.5f, 4), 8, 128, 2);
  CHECK(half.account().entered.x == Approx(0.5 * whole.account().entered.x).epsilon(5e-3));
}

TEST_CASE("tracer: a spot light falls off by the square of a ramp of the cosine") {
  Light spot{.name = "spot", .type = LightType::Spot};
  spot.inner_cone = 0.2f;
  spot.outer_cone = 0.6f;
  const auto at = [&](double cosine) {
    return Falloff(spot).at({std::sqrt(1.0 - cosine * cosine), 0.0, -cosine}, {0.0, 0.0, -1.0});
  };
  CHECK(at(std::cos(0.1)) == 1.0);
  CHECK(at(0.5 * (std::cos(0.2) + std::cos(0.6))) == Approx(0.25));
  CHECK(at(std::cos(0.7)) == 0.0);
}

TEST_CASE("tracer: a thin pane passes direct light less what both its faces mirror") {
  if (!has_ray_queries()) return;
  Scene scene;
  scene.materials = {test::diffuse(0.8f), test::glass(1.5f)};
  scene.materials[1].thickness = 0.0f;
  scene.meshes = {test::floor(3.0, 0.0, 0), test::floor(2.0, 1.0, 1)};
  scene.lights = {test::sun({0.0, -1.0, 0.0}, 1.0f)};
  scene.cameras = {test::camera_down(0.3, 0.3)};
  const Run run(std::move(scene), 4, 8, 1);
  // R = 0.04 at either face: (1 - R) / (1 + R).
  for (const double value : red(direct_light(run.tracer->world(), run.tracer->film(), 0)))
    CHECK(value == Approx(0.96 / 1.04).epsilon(1e-6));
}

TEST_CASE("tracer: what is not simulated is refused by name") {
  test::need_ray_queries();
  Scene hazy = test::sphere_scene(1.5f, 2);
  hazy.medium.scattering = glm::vec3(0.1f);
  CHECK(says(refusal([&] { Run(hazy, 8, 8, 0); }), "does not trace medium"));
  Scene cut_out = test::sphere_scene(1.5f, 2);
  cut_out.materials[1].alpha_mode = AlphaMode::Mask;
  cut_out.materials[1].base_color.a = 0.0f;
  CHECK(says(refusal([&] { Run(cut_out, 8, 8, 0); }), "does not trace cut-out casters"));
}

}  // namespace caustics::tracer
