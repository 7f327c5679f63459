#include "pipeline/measure/frame_memory.hpp"

#include "pipeline/effects/effects.hpp"
#include "pipeline/plan/frame_plan.hpp"
#include "pipeline/settings/settings.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/shapes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// Of a pass without textures over two receivers of two triangles, where each triangle or point that it draws
// takes a megabyte, and the device keeps so much for the next.
std::uint64_t needed(DrawSet draws, std::size_t kept, const Settings& settings = {}) {
  Pass pass;
  pass.draws = draws;
  FramePlan plan;
  PlannedPass planned;
  planned.pass = 0;
  planned.drawn_for = &kFrame;
  planned.definition = std::make_shared<const PassDefinition>();
  planned.width = planned.height = 8;
  plan.passes = {planned};
  Scene scene;
  scene.materials = {diffuse(0.8f)};
  scene.meshes = {floor(1.0, 0.0, 0), floor(1.0, 1.0, 0)};
  const Registry registry = {pass};
  return memory_needed({.plan = plan,
                        .registry = registry,
                        .scene = scene,
                        .effects = effects_of(scene, settings),
                        .settings = settings,
                        .device = {.draw = [](const PassDefinition&, std::size_t,
                                              std::size_t primitives) { return primitives * 1'000'000; },
                                   .kept = kept},
                        .taken = {}});
}

}  // namespace

TEST_CASE("frame memory: meshes' draws wait together, the largest and what the device keeps beside it") {
  CHECK(needed(DrawSet::Receivers, 1'000'000) == 3'000'000);
  CHECK(needed(DrawSet::Receivers, 3'000'000) == 4'000'000);
}

TEST_CASE("frame memory: a grid's draws take memory for each of their points, beams two each") {
  // 16 x 16 vertices of the light's grid, 4 x 4 of them in a beam.
  Settings settings;
  settings.grid = 16;
  settings.shafts = 4;
  CHECK(needed(DrawSet::GridVertices, 0, settings) == 256'000'000);
  CHECK(needed(DrawSet::GridColumns, 0, settings) == 16'000'000);
  CHECK(needed(DrawSet::Beams, 0, settings) == 32'000'000);
}

TEST_CASE("frame memory: a device that copies what is looked at takes a ledger's textures again") {
  // 10 x 10 texels of 4 floats: 1,600 bytes. Two branches have a landing and a medium each, the light a map.
  FramePlan plan;
  const auto add = [&](const std::string& name, int branch) {
    const int index = static_cast<int>(plan.textures.size());
    plan.textures.push_back({.name = name + "[sun]",
                             .width = 10,
                             .height = 10,
                             .light = 0,
                             .kept_for_light = true,
                             .memory = index});
    plan.memory.push_back({.width = 10, .height = 10});
    PlannedPass planned;
    planned.drawn_for = &kFrame;
    planned.definition = std::make_shared<const PassDefinition>();
    planned.light = 0;
    planned.branch = branch;
    planned.writes = {index};
    plan.passes.push_back(planned);
  };
  for (const int branch : {0, 1})
    for (const char* name : {kLanding, kLandingMedium}) add(name, branch);
  add(kCasterNormal, -1);
  plan.passes.back().ends_light = true;
  Scene scene;
  scene.lights.emplace_back();
  const Settings settings;
  const Effects effects;
  const Registry registry = {Pass{}};
  const auto needed = [&](const DeviceMemory& device) {
    return memory_needed({.plan = plan,
                          .registry = registry,
                          .scene = scene,
                          .effects = effects,
                          .settings = settings,
                          .device = device,
                          .taken = {}});
  };
  DeviceMemory device{.draw = [](const PassDefinition&, std::size_t, std::size_t) { return std::size_t{0}; }};
  // Of the branches' four textures pages are touched where a ball covers its window: 1,440 of 1,600 bytes.
  CHECK(needed(device) == 1600 + 4 * 1440);
  device.driver = 1000;
  CHECK(needed(device) == 1600 + 4 * 1440 + 1000);
  // The map, both textures of one branch, and both landings.
  device.copies_looks = true;
  CHECK(needed(device) == 10 * 1600 + 1000);
}
