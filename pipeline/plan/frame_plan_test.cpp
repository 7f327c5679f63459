#include "pipeline/plan/frame_plan.hpp"

#include "passes/registry.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A ball on a floor under a veil, and a spot light that shines beside the ball.
Scene veiled_ball_beside_a_spot() {
  Scene scene = sphere_scene(1.5f, 2);
  scene.cameras = {camera_down(2.0, 3.0)};
  scene.materials.push_back(diffuse(0.5f));
  scene.materials[2].alpha_mode = AlphaMode::Blend;
  scene.materials[2].base_color.a = 0.5f;
  scene.meshes.push_back(floor(3.0, 1.5, 2));
  Light spot{.name = "spot", .intensity = 1.0f};
  spot.type = LightType::Spot;
  spot.position = {2.0, 1.8, 2.0};
  spot.direction = {0.0, -1.0, 0.0};
  spot.inner_cone = 0.2f;
  spot.outer_cone = 0.3f;
  scene.lights.push_back(spot);
  return scene;
}

bool reads(const PlannedPass& pass, const std::string& name) {
  for (std::size_t i = 0; i < pass.reads.size(); ++i)
    if (pass.definition->reads[i].name == name && pass.reads[i] >= 0) return true;
  return false;
}

}  // namespace

TEST_CASE(
    "frame plan: panes tint a light that throws no caustic, though there are no casters for it to read") {
  const Scene scene = veiled_ball_beside_a_spot();
  const Settings settings = small_settings(32, 32, 24);
  const Effects effects = effects_of(scene, settings);
  REQUIRE(effects.tinted_caustics.active);
  REQUIRE(throws_caustic(effects, 0));
  REQUIRE_FALSE(throws_caustic(effects, 1));
  const FramePlan plan = make_plan(scene, effects, settings, pass_registry(), {{"picture"}});
  std::vector<std::string> of_panes, of_casters;
  for (const PlannedPass& pass : plan.passes) {
    if (pass.label.rfind("pane_light[", 0) != 0) continue;
    if (pass.label.find(".casters") == std::string::npos) of_panes.push_back(pass.label);
    if (reads(pass, "caster_position")) of_casters.push_back(pass.label);
  }
  CHECK(of_panes == std::vector<std::string>{"pane_light[sun]", "pane_light[spot]"});
  CHECK(of_casters == std::vector<std::string>{"pane_light[sun].casters"});
}
