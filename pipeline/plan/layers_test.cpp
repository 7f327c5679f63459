// Layers of blended surfaces in a plan: what of one waits for what was found in another.
#include <algorithm>

#include "passes/registry.hpp"
#include "pipeline/plan/frame_plan.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// Towards a picture of a ball on a floor under two veils.
FramePlan plan_of(int samples) {
  Scene scene = sphere_scene(1.5f, 2);
  scene.cameras = {camera_down(2.0, 1.0)};
  scene.materials.push_back(diffuse(0.5f));
  scene.materials[2].alpha_mode = AlphaMode::Blend;
  scene.materials[2].base_color.a = 0.5f;
  for (const double height : {1.5, 1.6}) scene.meshes.push_back(floor(1.0, height, 2));
  Settings settings = small_settings(32, 32, 24);
  settings.samples = samples;
  return make_plan(scene, effects_of(scene, settings), settings, pass_registry(), {{"picture"}});
}

const PlannedPass& pass_of(const FramePlan& plan, const std::string& label) {
  const auto found = std::find_if(plan.passes.begin(), plan.passes.end(),
                                  [&](const PlannedPass& pass) { return pass.label == label; });
  INFO(label);
  REQUIRE(found != plan.passes.end());
  return *found;
}

}  // namespace

TEST_CASE("layers: each is looked for, and lit, only where there are surfaces") {
  const FramePlan plan = plan_of(1);
  const auto counts = [&](const char* label) { return pass_of(plan, label).counts_into; };
  const auto needs = [&](const char* label) { return pass_of(plan, label).only_if; };
  REQUIRE(counts("view_surfaces.layer 1") > 0);
  CHECK(counts("view_surfaces") == 0);
  CHECK(needs("view_surfaces.layer 1") == 0);
  CHECK(needs("view_surfaces.layer 2") == counts("view_surfaces.layer 1"));
  CHECK(needs("view_surfaces.layer 4") == counts("view_surfaces.layer 3"));
  CHECK(needs("light_shading[sun]") == 0);
  CHECK(needs("light_shading[sun].layer 1") == counts("view_surfaces.layer 1"));
  CHECK(needs("light_shading[sun].layer 3") == counts("view_surfaces.layer 3"));
  // An empty layer hands on what the nearer ones have.
  CHECK(needs("compose.layer 3") == counts("view_surfaces.layer 1"));
  CHECK(needs("compose") == 0);
}

TEST_CASE("layers: each sample of a pixel counts its own") {
  const FramePlan plan = plan_of(4);
  std::vector<int> all;
  for (const PlannedPass& pass : plan.passes)
    if (pass.counts_into > 0) all.push_back(pass.counts_into);
  std::sort(all.begin(), all.end());
  CHECK(all.size() >= 4 * 4);
  CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());
  for (const std::string sample : {".sample 1", ".sample 4"}) {
    const int counted = pass_of(plan, "view_surfaces.layer 1" + sample).counts_into;
    for (const char* label : {"view_surfaces.layer 2", "light_shading[sun].layer 1", "compose.layer 2"})
      CHECK(pass_of(plan, label + sample).only_if == counted);
  }
}
