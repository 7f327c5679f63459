// caustics plan: what a scene holds and calls for, and what would run, without rendering it. The light is
// followed coarsely, to tell what becomes of it.
#include <algorithm>
#include <cstdio>
#include <optional>

#include "app/frame_options.hpp"
#include "app/loaded_scene.hpp"
#include "app/output/outputs.hpp"
#include "app/plan_report.hpp"
#include "app/shell/parser.hpp"
#include "app/shell/terminal.hpp"
#include "passes/registry.hpp"
#include "pipeline/effects/idle_settings.hpp"

namespace caustics::app {

namespace {

// Enough to tell where a light goes, in a moment.
FrameRequest coarse_request(FrameRequest request) {
  request.settings.grid = std::min<int>(request.settings.grid, 128);
  request.settings.map = std::min<int>(request.settings.map, 256);
  request.settings.shadow = std::min(request.settings.shadow, 512);
  request.backend = {};
  return request;
}

// As `render` judges the PNG picture that it draws for these options: with its samples of each pixel.
MemoryJudgement judge_picture(const FrameRequest& request, const Scene& scene, const PlannedFrame& planned) {
  const OutputRequest picture{.files = {"picture.png"}, .layers = {}};
  PlannedFrame frame{planned.settings, planned.effects, {}, {}, planned.taken};
  if (frame.settings.samples == 0) frame.settings.samples = kShownSamples;
  const std::uint64_t before = resident_memory().now;
  frame.plan =
      make_plan(scene, frame.effects, frame.settings, pass_registry(), goal_with_ledgers({"picture"}));
  // It takes the place of the plan that stands for one sample.
  const std::uint64_t after = resident_memory().now;
  frame.taken.now += after > before ? after - before : 0;
  return judge_memory(request, scene, frame,
                      [&](const PlannedFrame& shown) { return writing_bytes(shown, picture); });
}

}  // namespace

ExitCode run_plan_command(const Arguments& arguments) {
  Parser parser("plan",
                "Says what a scene holds, which effects and passes run and why, where caustics\n"
                "are to be expected, and what becomes of their light.",
                "  caustics plan scene.glb\n"
                "  caustics plan scene.glb --assume-solid      what would change\n"
                "  caustics plan scene.glb --json | jq .expectations\n");
  FrameRequest request;
  std::string scene;
  bool json = false;
  parser.positional("SCENE", kSceneMeaning, scene);
  parser.group("Output");
  parser.flag("--json", json, "one JSON document instead of the text");
  add_frame_options(parser, request);
  if (!parser.parse(arguments)) return ExitCode::Done;
  request.scene = scene;
  check_request(request, "plan");
  std::unique_ptr<LoadedScene> loaded = load_scene(request);
  const LoadedScene* shown = loaded.get();
  // What `render` runs for a PNG picture.
  const std::unique_ptr<Device> pilot = make_pilot_device(request.backend);
  const PlannedFrame frame = plan_frame(loaded->scene(), request.settings, pass_registry(), *pilot,
                                        goal_with_ledgers({"picture"}), &loaded->camera());
  const MemoryJudgement memory = judge_picture(request, loaded->scene(), frame);
  std::optional<RenderedFrame> coarse;
  LedgerReader reader;
  if (frame.effects.caustics.active) {
    coarse.emplace(coarse_request(request), std::move(loaded),
                   PlanGoal{.textures = ledger_textures(), .light_by_light = true});
    coarse->run(reader.watch(*coarse));
  }
  const PlanReport report{
      *shown,          frame.effects,
      frame.settings,  frame.plan,
      memory,          idle_settings(request.given, shown->scene(), frame.settings, frame.effects),
      reader.ledgers()};
  const std::string text = json ? plan_json(report) : plan_text(report, has_colour(stdout));
  std::fputs(text.c_str(), stdout);
  return ExitCode::Done;
}

}  // namespace caustics::app
