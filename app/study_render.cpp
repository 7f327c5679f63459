#include "app/study_render.hpp"

#include <set>

#include "app/frame_options.hpp"
#include "app/loaded_scene.hpp"
#include "app/numeric_faults.hpp"
#include "app/shell/parser.hpp"
#include "app/shell/terminal.hpp"
#include "passes/registry.hpp"
#include "pipeline/gpu/device.hpp"
#include "pipeline/gpu/error.hpp"

namespace caustics::app {

namespace {

// The labels of what these textures depend on.
std::set<std::string> labels_for(const RenderedFrame& frame, const PlanGoal& goal) {
  std::set<std::string> labels;
  for (const PlannedPass& pass :
       make_plan(frame.scene(), frame.effects(), frame.settings(), pass_registry(), goal).passes)
    labels.insert(pass.label);
  return labels;
}

std::uint64_t bytes_of(const RenderedFrame& frame) {
  return make_plan(frame.scene(), frame.effects(), frame.settings(), pass_registry(), {{"picture"}}).bytes();
}

}  // namespace

Rendered render_setting(FrameRequest request, int repeat, const std::function<void(const std::string&)>& say,
                        const Omission* without) {
  request.backend.measure = repeat > 0;
  request.backend.compiling = [&](std::string_view shader) {
    say("compiling shader " + std::string(shader));
  };
  say("finding where the light goes");
  if (without && without->settings) without->settings(request.settings);
  std::unique_ptr<LoadedScene> loaded = load_scene(request);
  if (without && without->scene)
    without->scene(loaded->scene(), effects_of(loaded->scene(), request.settings));
  RenderedFrame frame(request, std::move(loaded), {{"picture", "aov_caustic"}},
                      without ? without->effect : nullptr);
  Rendered result;
  result.device = frame.device().description();
  result.texture_bytes = bytes_of(frame);
  say(repeat > 0 ? "warming up" : "rendering");
  frame.run();
  result.caustic = frame.read("aov_caustic");
  refuse_numeric_faults(frame, "aov_caustic", "");
  if (repeat == 0) return result;
  study::Clock clock(labels_for(frame, {{"picture"}}),
                     labels_for(frame, {{kCausticMap, kCascadeMap, far_texture(kCausticMap)}}));
  for (int n = 0; n < repeat; ++n) {
    say("frame " + std::to_string(n + 1) + " of " + std::to_string(repeat));
    clock.add(frame.run());
  }
  result.times = clock.times();
  return result;
}

}  // namespace caustics::app
