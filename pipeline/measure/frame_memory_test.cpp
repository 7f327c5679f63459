#include "pipeline/measure/frame_memory.hpp"

#include "pipeline/effects/effects.hpp"
#include "pipeline/plan/frame_plan.hpp"
#include "pipeline/settings/settings.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/shapes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// Of a pass without textures that draws two receivers of two triangles, a megabyte each, where the device
// keeps so much for the next.
std::uint64_t needed(std::size_t kept) {
  Pass pass;
  pass.draws = DrawSet::Receivers;
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
  const Settings settings;
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
  CHECK(needed(1'000'000) == 3'000'000);
  CHECK(needed(3'000'000) == 4'000'000);
}
