#include "pipeline/renderer/moving_water.hpp"

#include "passes/registry.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/scene/exact.hpp"
#include "raster/software_device.hpp"
#include "tests/gl/gl_or_skip.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/water.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

WaterSettings lively(int cells) {
  return {.speed = 0.5,
          .damping = 0.2,
          .cells = cells,
          .interval = 0.2,
          .radius = 0.2,
          .height = 0.02,
          .seed = 8};
}

Image state_at(Device& device, const Water& water, std::initializer_list<double> moments) {
  WaterSimulation simulation(water, device, water_pass(pass_registry()));
  for (const double seconds : moments) simulation.advance_to(seconds);
  return simulation.state();
}

std::string positions(const Mesh& mesh) {
  Image image(Format::RGBA32F, static_cast<int>(mesh.vertices.size()), 2);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    for (int c = 0; c < 3; ++c) {
      image.at(static_cast<int>(v), 0, c) = mesh.vertices[v].position[c];
      image.at(static_cast<int>(v), 1, c) = mesh.vertices[v].normal[c];
    }
  return sha256(image);
}

}  // namespace

TEST_CASE("water: plops fall at regular intervals where splitmix64 says") {
  // The random numbers 0.26665, 0.02398, 0.55696, 0.04009 of seed 8 and plop 0 were computed in Python from
  // the published algorithm: place within the sheet less a radius, size 1/2 to 1, and a dip below 1/2.
  const Scene scene = pool_scene(0.5, lively(40));
  const Water& water = scene.waters[0];
  const Plop first = water.plop(0);
  CHECK(first.centre.x == Approx(0.2 + 1.6 * 0.266645678882962));
  CHECK(first.centre.y == Approx(0.2 + 1.6 * 0.023982512803259803));
  CHECK(first.height == Approx(-0.02 * (0.5 + 0.5 * 0.5569569016053786)));
  CHECK(water.plop(2).height == Approx(0.02 * (0.5 + 0.5 * 0.22270801864852796)));
  // Steps of 0.2 s / 4 = 0.05 s (0.5 m/s, half of a cell of 0.05 m); a plop rises through 0.4 s, but
  // is over when the next one falls.
  CHECK(water.steps_per_plop == 4);
  CHECK(water.plop_steps == 4);
  CHECK_FALSE(water.plop_in_step(3));
  REQUIRE(water.plop_in_step(4));
  CHECK(water.plop_in_step(4)->centre == first.centre);
  CHECK(water.plop_in_step(7)->centre == first.centre);
  CHECK(water.plop_in_step(8)->centre == water.plop(1).centre);
  // A second apart there are 20 steps from plop to plop, and the water rests for 12 of them.
  WaterSettings rare = lively(40);
  rare.interval = 1.0;
  const Scene calm = pool_scene(0.5, rare);
  CHECK(calm.waters[0].plop_steps == 8);
  CHECK(calm.waters[0].plop_in_step(27));
  CHECK_FALSE(calm.waters[0].plop_in_step(28));
}

TEST_CASE("water: it has been stirred since its start before time 0, and rests before that") {
  Water water = bare_water(8, 8);  // steps of half a second
  water.settings.start = 2.0;
  CHECK(water.since_rest(1.5) == 3.5);
  CHECK(water.since_rest(-0.5) == 1.5);
  CHECK(water.since_rest(-7.0) == 0.0);
  CHECK(water.steps_until(1.5) == 8);
  CHECK(water.steps_until(-7.0) == 1);
}

TEST_CASE("water: plops keep to an oblong sheet, each a radius within its own sides") {
  // Seed 8 and plop 0 as above; 2 m along x, 0.8 m along z.
  Scene scene;
  scene.materials = {glass(1.33f)};
  scene.meshes = {floor(1.0, 0.5, 0)};
  Mesh& sheet = scene.meshes[0];
  for (Vertex& vertex : sheet.vertices) vertex.position.z *= 0.4f;
  sheet.lower.z *= 0.4f;
  sheet.upper.z *= 0.4f;
  REQUIRE(add_water(scene, 0, {1.0, 0.0, 0.0}, lively(40)) == "");
  const Water& water = scene.waters[0];
  CHECK(water.columns == 40);
  CHECK(water.rows == 16);
  CHECK(water.plop(0).centre.x == Approx(0.2 + 1.6 * 0.266645678882962));
  CHECK(water.plop(0).centre.y == Approx(0.2 + 0.4 * 0.023982512803259803));
  glm::dvec2 lower(1e9), upper(-1e9);
  for (int n = 0; n < 200; ++n) {
    lower = glm::min(lower, water.plop(n).centre);
    upper = glm::max(upper, water.plop(n).centre);
  }
  // All over what is a radius away from the sides: 200 of them leave out less than a tenth at each.
  CHECK(lower.x == Approx(0.2).margin(0.16));
  CHECK(upper.x == Approx(1.8).margin(0.16));
  CHECK(lower.y == Approx(0.2).margin(0.04));
  CHECK(upper.y == Approx(0.6).margin(0.04));
}

TEST_CASE("water: a moment has the same state whatever was computed before") {
  const Scene scene = pool_scene(0.5, lively(48));
  const auto device = make_software_device({.threads = 1});
  const Image alone = state_at(*device, scene.waters[0], {2.5});
  CHECK(sha256(state_at(*device, scene.waters[0], {0.1, 1.0, 1.04, 2.5})) == sha256(alone));
  CHECK(sha256(state_at(*device, scene.waters[0], {3.0, 2.5})) == sha256(alone));
  CHECK(sha256(state_at(*device, scene.waters[0], {2.4})) != sha256(alone));
}

TEST_CASE("water: start moves the clock on") {
  WaterSettings later = lively(48);
  later.start = 1.5;
  const Scene scene = pool_scene(0.5, lively(48)), started = pool_scene(0.5, later);
  const auto device = make_software_device({.threads = 1});
  CHECK(sha256(state_at(*device, started.waters[0], {1.0})) ==
        sha256(state_at(*device, scene.waters[0], {2.5})));
}

TEST_CASE("water: another seed makes other waves") {
  WaterSettings other = lively(48);
  other.seed = 9;
  const Scene scene = pool_scene(0.5, lively(48)), reseeded = pool_scene(0.5, other);
  const auto device = make_software_device({.threads = 1});
  CHECK(sha256(state_at(*device, scene.waters[0], {2.5})) !=
        sha256(state_at(*device, reseeded.waters[0], {2.5})));
}

TEST_CASE("water: OpenGL computes the same waves to the bit") {
  const auto gl = gl_or_skip();
  const Scene scene = pool_scene(0.5, lively(80));
  const auto software = make_software_device();
  const Image a = state_at(*software, scene.waters[0], {3.0}), b = state_at(*gl, scene.waters[0], {3.0});
  CHECK(sha256(a) == sha256(b));
  Scene shown = pool_scene(0.5, lively(80)), shown_gl = shown;
  MovingWater(shown, *software, pass_registry()).show(3.0, false);
  MovingWater(shown_gl, *gl, pass_registry()).show(3.0, false);
  CHECK(positions(shown.meshes[1]) == positions(shown_gl.meshes[1]));
}

TEST_CASE("water: a ramp of heights lifts vertices by it and tilts their normals") {
  // Height 0.02 (column + 1/2) / 40 m over cells of 0.05 m: at x = -1 + 0.05 c it is 0.0005 c, a slope of
  // 0.01. At the walls across the ramp the heights stay those of the last cells' middles, and nothing is
  // tilted.
  Scene scene = pool_scene(0.5, lively(40));
  const Water& water = scene.waters[0];
  WaterSurface surface(water, scene.meshes[1]);
  Image state(Format::RG32F, 40, 40);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x) {
      state.at(x, y, 0) = 0.0005f * (static_cast<float>(x) + 0.5f);
      state.at(x, y, 1) = 2.0f;
    }
  surface.displace(state, 0.001, scene.meshes[1]);
  for (const Vertex& v : scene.meshes[1].vertices) {
    const double place = std::clamp((static_cast<double>(v.position.x) + 1.0) / 0.05, 0.5, 39.5);
    CHECK(static_cast<double>(v.position.y) == Approx(0.5 + 0.0005 * place - 0.002).margin(1e-7));
    if (place > 1.5 && place < 38.5) {
      CHECK(static_cast<double>(v.normal.x / v.normal.y) == Approx(-0.01).epsilon(1e-5));
    }
    if (std::fabs(v.position.x) == 1.0f) CHECK(v.normal == glm::vec3(0.0f, 1.0f, 0.0f));
  }
}

TEST_CASE("water: heights beyond the bounds are cut to them") {
  Scene scene = pool_scene(0.5, lively(40));
  const WaterSurface surface(scene.waters[0], scene.meshes[1]);
  Image state(Format::RG32F, 40, 40);
  for (float& value : state.values) value = 1e30f;
  surface.displace(state, 0.0, scene.meshes[1]);
  for (const Vertex& v : scene.meshes[1].vertices) CHECK(v.position.y == scene.meshes[1].upper.y);
}

TEST_CASE("water: a sheet that is not flat at rest keeps its shape under the waves") {
  Scene scene;
  scene.materials = {glass(1.33f)};
  scene.meshes = {wave_sheet(1.0, 0.0, 0.01, 3.0, 64, 0)};
  REQUIRE(add_water(scene, 0, {1.0, 0.0, 0.0}, lively(40)) == "");
  const Mesh rest = scene.meshes[0];
  WaterSurface(scene.waters[0], rest).displace(Image(Format::RG32F, 40, 40), 0.0, scene.meshes[0]);
  for (std::size_t v = 0; v < rest.vertices.size(); ++v) {
    CHECK(scene.meshes[0].vertices[v].position == rest.vertices[v].position);
    CHECK(exact::length(glm::dvec3(scene.meshes[0].vertices[v].normal - rest.vertices[v].normal)) < 1e-6);
  }
}

TEST_CASE("water: waves in what does not refract are refused") {
  Scene scene = pool_scene(0.5, lively(40));
  scene.meshes[1].material = 0;
  scene.file = "pond.glb";
  try {
    effects_of(scene, small_settings(16, 16, 16));
    FAIL("was accepted");
  } catch (const Error& error) {
    CHECK(error.code() == ExitCode::BadInput);
    CHECK(std::string(error.what()).find("pond.glb: water 'pool' is no refractor") == 0);
  }
}

TEST_CASE(
    "water: the plan has the effect, its steps before the frame, and the last of them where all is wanted") {
  const Scene scene = pool_scene(0.5, lively(40));
  const Settings settings = small_settings(16, 16, 16);
  const Effects effects = effects_of(scene, settings);
  CHECK(effects.water_waves.active);
  const FramePlan picture = make_plan(scene, effects, settings, pass_registry(), {{"picture"}});
  REQUIRE(picture.before.size() == 1);
  CHECK(picture.before[0].label == "water_step[pool]");
  CHECK(picture.before[0].writes.width == 40);
  CHECK(picture.find("water_after[water 0]") < 0);
  const FramePlan all = make_plan(scene, effects, settings, pass_registry());
  CHECK(all.find("water_after[water 0]") >= 0);
  CHECK(all.passes.front().label == "water_step[pool]");
}
