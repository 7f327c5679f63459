#include "pipeline/plan/sample_passes.hpp"

#include <algorithm>

#include "passes/registry.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

using Names = std::vector<std::string>;

Settings with_samples_a_pixel(int samples) {
  Settings settings = small_settings(32, 32, 24);
  settings.samples = samples;
  return settings;
}

// Of a glass ball over a floor, from above.
FramePlan plan_of(int samples, const PlanGoal& goal, std::size_t lights = 1) {
  Scene scene = sphere_scene(1.5f, 2);
  scene.cameras = {camera_down(2.0, 1.0)};
  scene.lights.resize(lights, scene.lights.front());
  const Settings settings = with_samples_a_pixel(samples);
  return make_plan(scene, effects_of(scene, settings), settings, pass_registry(), goal);
}

Names labels(const FramePlan& plan) {
  Names names;
  for (const PlannedPass& pass : plan.passes) names.push_back(pass.label);
  return names;
}

// Of the passes that are drawn for a sample, or for none.
Names of_sample(const FramePlan& plan, int sample) {
  Names names;
  for (const PlannedPass& pass : plan.passes)
    if (pass.sample == sample) names.push_back(pass.label.substr(0, pass.label.find(".sample")));
  std::sort(names.begin(), names.end());
  return names;
}

const Names kOfCamera = {"average_samples",
                         "caster_map.camera",
                         "compose",
                         "compose.behind",
                         "compose.in_mirrors",
                         "glass",
                         "hidden_ends.behind",
                         "hidden_ends.in_mirrors",
                         "light_shading[sun]",
                         "light_shading[sun].behind",
                         "light_shading[sun].in_mirrors",
                         "view_surfaces"};

bool is_of_camera_by_name(const std::string& label) {
  return label == "tone_map" || std::find(kOfCamera.begin(), kOfCamera.end(), label) != kOfCamera.end();
}

}  // namespace

TEST_CASE(
    "sample passes: the camera's passes run for each sample, the lights' once, the tone map at the end") {
  const FramePlan plan = plan_of(4, {{"picture"}});
  for (int sample = 1; sample <= 4; ++sample) CHECK(of_sample(plan, sample) == kOfCamera);
  Names lights = labels(plan_of(1, {{"picture"}}));
  std::erase_if(lights, is_of_camera_by_name);
  lights.emplace_back("tone_map");
  std::sort(lights.begin(), lights.end());
  CHECK(of_sample(plan, 0) == lights);
  CHECK(plan.passes.back().label == "tone_map");
}

TEST_CASE("sample passes: of one sample a pixel there are none") {
  for (const PlannedPass& pass : plan_of(1, {{"picture"}}).passes) CHECK(pass.sample == 0);
  CHECK(labels(plan_of(0, {{"picture"}})) == labels(plan_of(1, {{"picture"}})));
}

TEST_CASE("sample passes: a sum is cleared before the first sample and kept for the others") {
  const FramePlan plan = plan_of(8, {{"picture"}});
  int samples = 0;
  for (const PlannedPass& pass : plan.passes) {
    if (pass.label.rfind("average_samples", 0) != 0) continue;
    CHECK(pass.sample == ++samples);
    CHECK(pass.keep[0] == (samples > 1));
    CHECK(pass.writes[0] == plan.find("beauty"));
    CHECK(pass.reads[0] == plan.find("beauty.sample " + std::to_string(samples)));
  }
  CHECK(samples == 8);
}

TEST_CASE("sample passes: layers, and what is wanted beside the picture, are of the pixels' middles") {
  const auto middle = [](const PlanGoal& goal) {
    Names names = of_sample(plan_of(4, goal), 0);
    std::erase_if(names, [](const std::string& name) { return !is_of_camera_by_name(name); });
    return names;
  };
  CHECK(middle({{"picture"}, {"view_position"}}) == Names{"tone_map", "view_surfaces"});
  CHECK(middle({{"picture", "aov_normal"}}) == Names{"caster_map.camera", "tone_map", "view_surfaces"});
  CHECK(middle({{"picture", "aov_direct"}}) ==
        Names{"caster_map.camera", "light_shading[sun]", "tone_map", "view_surfaces"});
  // Where no picture is wanted there is nothing to smooth.
  CHECK(labels(plan_of(4, {{"aov_normal"}})) == labels(plan_of(1, {{"aov_normal"}})));
}

TEST_CASE("sample passes: more samples take no more memory, nor do those who look at what is drawn") {
  for (const PlanGoal& goal : {PlanGoal{{"picture"}}, PlanGoal{.light_by_light = true}})
    CHECK(plan_of(16, goal).bytes() == plan_of(4, goal).bytes());
  constexpr std::size_t kSum = std::size_t{24} * 24 * 16;
  CHECK(plan_of(4, {{"picture"}}).bytes() <= plan_of(1, {{"picture"}}).bytes() + kSum);
}

TEST_CASE("sample passes: many lights' maps are not kept for the last sample where less memory will do") {
  const auto growth = [](std::size_t lights) {
    return static_cast<double>(plan_of(4, {{"picture"}}, lights).bytes()) /
           static_cast<double>(plan_of(1, {{"picture"}}, lights).bytes());
  };
  CHECK(growth(2) < 2.0);
  CHECK(growth(40) < 3.5);
}

TEST_CASE("sample passes: a light ends with its own last pass, whose textures the samples do not keep") {
  const FramePlan plan = plan_of(4, {{"picture"}, {kLanding}, true}, 2);
  int ended = 0;
  for (const PlannedPass& pass : plan.passes)
    if (pass.ends_light) {
      ++ended;
      CHECK(pass.sample == 0);
    }
  CHECK(ended == 2);
  CHECK(plan.textures[static_cast<std::size_t>(plan.find("landing[0]"))].until <
        plan.textures[static_cast<std::size_t>(plan.find("landing[1]"))].until);
}
