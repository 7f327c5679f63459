#include "passes/water_step/water_step.hpp"

#include <algorithm>

namespace caustics {

extern const Shader water_step_shader;

namespace {

// The factor k that makes the sum of (1 - q)^3 (1 - k q) over the cells 0. Over the whole plane it is 5;
// a plop of few cells, or one that a wall cuts, has another.
double ring_factor(const Water& water, const Plop& plop) {
  const auto range = [&](double centre, double cell, int cells) {
    const double first = (centre - water.radius) / cell - 1.0, last = (centre + water.radius) / cell + 1.0;
    return std::pair{std::max(static_cast<int>(first), 0), std::min(static_cast<int>(last), cells - 1)};
  };
  const auto [left, right] = range(plop.centre.x, water.dx, water.columns);
  const auto [near, far] = range(plop.centre.y, water.dz, water.rows);
  double bump = 0.0, ring = 0.0;
  for (int j = near; j <= far; ++j)
    for (int i = left; i <= right; ++i) {
      const double x = ((i + 0.5) * water.dx - plop.centre.x) / water.radius;
      const double z = ((j + 0.5) * water.dz - plop.centre.y) / water.radius;
      const double q = x * x + z * z;
      if (q >= 1.0) continue;
      const double cube = (1.0 - q) * (1.0 - q) * (1.0 - q);
      bump += cube;
      ring += cube * q;
    }
  return ring > 0.0 ? bump / ring : 5.0;
}

}  // namespace

std140::WaterStep water_step_uniforms(const Water& water, std::int64_t step) {
  const WaterSettings& s = water.settings;
  const double x = s.speed / water.dx, z = s.speed / water.dz, dt = water.step;
  std140::WaterStep u{};
  u.pull_x = static_cast<float>(x * x * dt);
  u.pull_z = static_cast<float>(z * z * dt);
  u.damping = static_cast<float>(1.0 / (1.0 + s.damping * dt));
  u.time_step = static_cast<float>(dt);
  const std::optional<Plop> plop = water.plop_in_step(step);
  if (!plop) return u;
  u.plop_middle = {static_cast<float>(plop->centre.x / water.dx),
                   static_cast<float>(plop->centre.y / water.dz)};
  u.plop_scale = {static_cast<float>(water.dx / water.radius), static_cast<float>(water.dz / water.radius)};
  u.plop_height = static_cast<float>(plop->height / static_cast<double>(water.plop_steps));
  u.plop_ring = static_cast<float>(ring_factor(water, *plop));
  return u;
}

Pass water_step_pass() {
  return {
      .name = kWaterStep,
      .purpose = "moves the waves of a water surface on by one step of time",
      .reason = "waves run over the water",
      .when = {&Effects::water_waves},
      .drawn_for = {kWater},
      .reads = {{.name = kWaterBefore, .meaning = "the water's heights before the step"}},
      .writes = {{.name = "water_after",
                  .format = Format::RG32F,
                  .meaning = "r: height over the level, metres; g: how fast it rises, metres a second"}},
      .shaders =
          {{&water_step_shader,
            block_of<[](const PassContext& c) { return water_step_uniforms(*c.water, c.water_step); }>}},
  };
}

}  // namespace caustics
