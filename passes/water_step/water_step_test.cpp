#include "passes/water_step/water_step.hpp"

#include <functional>
#include <utility>

#include "pipeline/plan/frame_plan.hpp"
#include "pipeline/scene/exact.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"
#include "tests/support/water.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

using Height = std::function<double(int, int)>;

Image state_of(const Water& water, const Height& height, const Height& rate) {
  Image image(Format::RG32F, water.columns, water.rows);
  for (int y = 0; y < water.rows; ++y)
    for (int x = 0; x < water.columns; ++x) {
      image.at(x, y, 0) = static_cast<float>(height(x, y));
      image.at(x, y, 1) = static_cast<float>(rate(x, y));
    }
  return image;
}

double nothing(int, int) { return 0.0; }

// The states of so many steps on one device, the first one given.
class Steps {
 public:
  Steps(const Water& water, const std140::WaterStep& first, const Image& state)
      : definition_(definition_of(water_step_pass())),
        device_(make_software_device({.threads = 1})),
        textures_{device_->upload(state), device_->create_texture(Format::RG32F, water.columns, water.rows)},
        calm_(water_step_uniforms(water, 0)) {
    make(first);
  }
  void make(int count) {
    for (int i = 0; i < count; ++i) make(calm_);
  }
  Image state() const { return device_->read_back(textures_[0]); }
  Image before() const { return device_->read_back(textures_[1]); }

 private:
  void make(const std140::WaterStep& uniforms) {
    device_->run(
        {.definition = &definition_,
         .colors = {textures_[1]},
         .keep = {false},
         .draws = {{.vertex_count = 3, .uniforms = uniform_bytes(uniforms), .textures = {textures_[0]}}}});
    std::swap(textures_[0], textures_[1]);
  }

  PassDefinition definition_;
  std::unique_ptr<Device> device_;
  TextureId textures_[2];
  std140::WaterStep calm_;
};

// A step's uniforms with a plop of height 1 and radius 4 cells.
std140::WaterStep plop_uniforms(const Water& water, double x, double z) {
  std140::WaterStep u = water_step_uniforms(water, 0);
  u.plop_middle = {static_cast<float>(x), static_cast<float>(z)};
  u.plop_scale = {0.25f, 0.25f};
  u.plop_height = 1.0f;
  u.plop_ring = 5.0f;
  return u;
}

// Of the leapfrog scheme: sum of rate^2 / 2 + c^2 grad h(n) . grad h(n - 1) / 2, which it keeps exactly.
double energy(const Water& water, const Image& now, const Image& before) {
  double total = 0.0;
  const auto h = [](const Image& image, int x, int y) { return static_cast<double>(image.at(x, y, 0)); };
  for (int y = 0; y < water.rows; ++y)
    for (int x = 0; x < water.columns; ++x) {
      const double rate = static_cast<double>(now.at(x, y, 1));
      total += 0.5 * rate * rate;
      if (x + 1 < water.columns)
        total += 0.5 * (h(now, x + 1, y) - h(now, x, y)) * (h(before, x + 1, y) - h(before, x, y));
      if (y + 1 < water.rows)
        total += 0.5 * (h(now, x, y + 1) - h(now, x, y)) * (h(before, x, y + 1) - h(before, x, y));
    }
  return total;
}

}  // namespace

TEST_CASE("water_step: one raised cell falls and lifts its four neighbours") {
  // c dt / dx = 1/2: the rate changes by (c / dx)^2 dt times the second differences, 1 in the neighbours
  // and -4 in the middle; heights follow by the new rate times dt = 1/2.
  const Water water = bare_water(5, 5);
  const Image raised = state_of(
      water, [](int x, int y) { return x == 2 && y == 2 ? 1.0 : 0.0; }, nothing);
  const Image after = Steps(water, water_step_uniforms(water, 0), raised).state();
  CHECK(texel(after, 2, 2) == glm::vec4(0.0f, -2.0f, 0.0f, 0.0f));
  CHECK(texel(after, 1, 2) == glm::vec4(0.25f, 0.5f, 0.0f, 0.0f));
  CHECK(texel(after, 2, 3) == glm::vec4(0.25f, 0.5f, 0.0f, 0.0f));
  CHECK(texel(after, 1, 1) == glm::vec4(0.0f));
  // Each axis pulls by its own factor.
  std140::WaterStep across = water_step_uniforms(water, 0);
  across.pull_z = 0.0f;
  const Image lifted = Steps(water, across, raised).state();
  CHECK(texel(lifted, 2, 2).y == -1.0f);
  CHECK(texel(lifted, 1, 2).y == 0.5f);
  CHECK(texel(lifted, 2, 3).y == 0.0f);
}

TEST_CASE("water_step: a wall gives back what runs against it") {
  // In the corner cell only two neighbours pull.
  const Water water = bare_water(4, 4);
  const Image raised = state_of(
      water, [](int x, int y) { return x == 0 && y == 0 ? 1.0 : 0.0; }, nothing);
  const Image after = Steps(water, water_step_uniforms(water, 0), raised).state();
  CHECK(texel(after, 0, 0) == glm::vec4(0.5f, -1.0f, 0.0f, 0.0f));
  CHECK(sum(after, 0) == 1.0);
}

TEST_CASE("water_step: damping divides the rate by 1 + damping dt") {
  const Water water = bare_water(3, 3, 2.0);
  const Image rising = state_of(water, nothing, [](int, int) { return 1.0; });
  const Image after = Steps(water, water_step_uniforms(water, 0), rising).state();
  CHECK(texel(after, 1, 1) == glm::vec4(0.25f, 0.5f, 0.0f, 0.0f));
}

TEST_CASE("water_step: a standing wave of the box swings with the scheme's own frequency") {
  // cos(w dt) = 1 - (c dt / dx)^2 (2 - cos kx dx - cos ky dx) holds for v(0) = (1 - cos w dt) / dt. Rounding:
  // each step adds 6e-8 of the height at most, which a mode turns into 6e-8 / sin(w dt) of another phase;
  // over 1000 steps at w dt > 0.06 at random some 3e-5, at worst 1e-3.
  const Water water = bare_water(32, 24);
  for (const auto& [m, n] : {std::pair{1, 0}, {0, 1}, {3, 2}, {8, 5}, {31, 23}}) {
    const double kx = exact::kPi * m / 32.0, ky = exact::kPi * n / 24.0;
    const double cosine = 1.0 - 0.25 * (2.0 - std::cos(kx) - std::cos(ky));
    const double angle = std::acos(cosine);
    const auto mode = [&](int x, int y) { return std::cos(kx * (x + 0.5)) * std::cos(ky * (y + 0.5)); };
    const auto rate = [&](int x, int y) { return mode(x, y) * (1.0 - cosine) / 0.5; };
    Steps steps(water, water_step_uniforms(water, 0), state_of(water, mode, rate));
    for (int step = 1; step <= 1000; step += 111) {
      const Image state = steps.state();
      double worst = 0.0;
      for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 32; ++x)
          worst = std::max(
              worst, std::fabs(static_cast<double>(state.at(x, y, 0)) - mode(x, y) * std::cos(step * angle)));
      INFO("mode " << m << ", " << n << " after " << step << " steps");
      CHECK(worst < 1e-4);
      steps.make(111);
    }
  }
}

TEST_CASE("water_step: the mean height stays") {
  // A rate near 1 is rounded by 3e-8, so the mean of 1024 by 1e-9 a step. These add up at random in the mean
  // rate, and that in the mean height: 1e-9 dt sqrt(n^3 / 3), 9e-6 after 1000 steps. Three times that is
  // allowed.
  const Water water = bare_water(32, 32);
  const Image start = state_of(
      water, [](int x, int y) { return (x * 7 + y * 13) % 11 * 0.1; }, nothing);
  const double mean = sum(start, 0) / 1024.0;
  Steps steps(water, water_step_uniforms(water, 0), start);
  steps.make(999);
  CHECK(sum(steps.state(), 0) / 1024.0 == Approx(mean).margin(2.7e-5));
}

TEST_CASE("water_step: a plop adds no water") {
  const Water water = bare_water(32, 32);
  const Image flat = state_of(water, nothing, nothing);
  const Image plopped = Steps(water, plop_uniforms(water, 16.0, 16.0), flat).state();
  // The sum of (1 - q)^3 (1 - 5 q) over cells differs a little from the plane's integral, 0.
  CHECK(std::fabs(sum(plopped, 0)) < 0.05);
  Scene scene = pool_scene(0.5, {.cells = 40, .interval = 0.1, .radius = 0.2, .height = 0.04});
  const Water& real = scene.waters[0];
  const Image before(Format::RG32F, real.columns, real.rows);
  for (std::int64_t n = 1; n < 20; ++n) {
    // The factor that is computed for the plop's own cells makes it 0, but for rounding of 5 mm high cells.
    const Image after = Steps(real, water_step_uniforms(real, n * real.steps_per_plop), before).state();
    CHECK(std::fabs(sum(after, 0)) < 1e-6 * real.height * 100.0);
  }
}

TEST_CASE("water_step: without damping the energy stays, and with it it falls") {
  const Water free = bare_water(48, 32), damped = bare_water(48, 32, 0.05);
  const Image flat = state_of(free, nothing, nothing);
  Steps lossless(free, plop_uniforms(free, 20.0, 11.0), flat),
      lossy(damped, plop_uniforms(damped, 20.0, 11.0), flat);
  lossless.make(1);
  lossy.make(1);
  const double start = energy(free, lossless.state(), lossless.before());
  double last = energy(damped, lossy.state(), lossy.before());
  REQUIRE(start > 0.1);
  for (int i = 0; i < 20; ++i) {
    lossless.make(100);
    lossy.make(5);
    // 2000 steps of rounding, 6e-8 each.
    CHECK(energy(free, lossless.state(), lossless.before()) == Approx(start).epsilon(1e-4));
    const double now = energy(damped, lossy.state(), lossy.before());
    CHECK(now < last);
    last = now;
  }
}

TEST_CASE("water_step: a plop in the middle stays as symmetric as its square, to the bit") {
  const Water water = bare_water(32, 32, 0.01);
  Steps steps(water, plop_uniforms(water, 16.0, 16.0), state_of(water, nothing, nothing));
  steps.make(150);
  const Image state = steps.state();
  REQUIRE(std::fabs(state.at(3, 5, 0)) > 1e-6f);
  int different = 0;
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x)
      for (const glm::vec4& other : {texel(state, 31 - x, y), texel(state, x, 31 - y), texel(state, y, x)})
        different += texel(state, x, y) == other ? 0 : 1;
  CHECK(different == 0);
}

TEST_CASE("water_step: a frame without water has no such pass, and says why") {
  const Scene scene = sphere_scene(1.5f, 2);
  const Settings settings = small_settings(16, 16, 16);
  const FramePlan plan = make_plan(scene, effects_of(scene, settings), settings, {water_step_pass()});
  CHECK(plan.passes.empty());
  REQUIRE(plan.skipped.size() == 1);
  CHECK(plan.skipped[0].reason == "water waves: no mesh is water that moves");
}
