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
#include "pipeline/gpu/stopwatch.hpp"
#include "pipeline/measure/frame_time.hpp"

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

// As `render` plans the PNG picture that it draws for these options: with its samples of each pixel.
PlannedFrame planned_picture(const Scene& scene, const PlannedFrame& planned) {
  PlannedFrame frame{planned.settings, planned.effects, {}, {}, planned.taken};
  if (frame.settings.samples == 0) {
    frame.settings.samples = kShownSamples;
    frame.effects.sub_pixels = {true, "for a picture that is only looked at"};
  }
  const std::uint64_t before = resident_memory().now;
  frame.plan =
      make_plan(scene, frame.effects, frame.settings, pass_registry(), goal_with_ledgers({"picture"}));
  // It takes the place of the plan that stands for one sample.
  const std::uint64_t after = resident_memory().now;
  frame.taken.now += after > before ? after - before : 0;
  return frame;
}

MemoryJudgement judge_picture(const FrameRequest& request, const Scene& scene, const PlannedFrame& frame) {
  const OutputRequest picture{.files = {"picture.png"}, .layers = {}};
  return judge_memory(request, scene, frame, false,
                      [&](const PlannedFrame& shown) { return writing_bytes(shown, picture); });
}

double squared(double side) { return side * side; }

// The system clears memory before a process has it, which is a quarter of what a picture takes.
double taking_memory(std::uint64_t bytes) {
  constexpr std::size_t kTried = std::size_t{16} << 20;
  const Stopwatch watch;
  const std::vector<char> taken(kTried);
  return watch.processor_milliseconds() * static_cast<double>(bytes) / static_cast<double>(taken.size());
}

// Processor seconds of `render`: what loading and planning took here, and what a picture of a quarter of the
// sides on the small maps takes, grown to the frame's sizes. `ledgers`: that picture's.
double seconds_of(const FrameRequest& request, const std::shared_ptr<LoadedScene>& loaded,
                  const PlannedFrame& frame, std::uint64_t memory, double prepared,
                  std::vector<LightLedger>& ledgers) {
  constexpr int kSmaller = 4, kLeast = 16;
  constexpr double kWriting = 6e-5;  // milliseconds a pixel of a PNG
  FrameRequest small = coarse_request(request);
  small.settings.width = std::max(kLeast, small.settings.width / kSmaller);
  small.settings.height = std::max(kLeast, small.settings.height / kSmaller);
  small.settings.samples = 1;
  RenderedFrame drawn(small, loaded, goal_with_ledgers({"picture"}));
  LedgerReader reader;
  std::vector<PassResult> results;
  drawn.run([&](const PlannedPass& pass, const PassResult& result, std::size_t, std::size_t) {
    results.push_back(result);
    reader.look(drawn, pass);
    return true;
  });
  ledgers = reader.ledgers();
  const double passes = expected_milliseconds({frame.plan, frame.settings, frame.effects},
                                              {drawn.plan(), drawn.settings(), drawn.effects()}, results);
  const double grown = (squared(frame.settings.grid) + squared(frame.settings.map)) /
                       (squared(drawn.settings().grid) + squared(drawn.settings().map));
  const double written = kWriting * frame.settings.width * frame.settings.height;
  const std::uint64_t fresh = memory - std::min(memory, frame.taken.now);
  return (prepared + taking_memory(fresh) + passes + reader.of_rays() + grown * reader.of_texels() +
          written) /
         1e3;
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
  const Stopwatch watch;
  check_request(request, "plan");
  const std::shared_ptr<LoadedScene> loaded = load_scene(request);
  const LoadedScene* shown = loaded.get();
  // What `render` runs for a PNG picture.
  const std::unique_ptr<Device> pilot = make_pilot_device(request.backend);
  const PlannedFrame frame = plan_frame(loaded->scene(), request.settings, pass_registry(), *pilot,
                                        goal_with_ledgers({"picture"}), &loaded->camera());
  const PlannedFrame picture = planned_picture(loaded->scene(), frame);
  const MemoryJudgement memory = judge_picture(request, loaded->scene(), picture);
  std::vector<LightLedger> ledgers;
  const double seconds =
      seconds_of(request, loaded, picture, memory.needed, watch.processor_milliseconds(), ledgers);
  std::optional<RenderedFrame> coarse;
  LedgerReader reader;
  // Of so many passes, as a hundred lights have, one run must do; it sees the model's error on fewer pixels.
  constexpr std::size_t kMostForTwoRuns = 10'000;
  if (frame.effects.caustics.active && frame.plan.passes.size() <= kMostForTwoRuns) {
    coarse.emplace(coarse_request(request), loaded,
                   PlanGoal{.textures = ledger_textures(), .light_by_light = true});
    coarse->run(reader.watch(*coarse));
    ledgers = reader.ledgers();
  }
  const PlanReport report{*shown,
                          frame.effects,
                          frame.settings,
                          frame.plan,
                          memory,
                          seconds,
                          idle_settings(request.given, shown->scene(), frame.settings, frame.effects),
                          std::move(ledgers)};
  const std::string text = json ? plan_json(report) : plan_text(report, has_colour(stdout));
  std::fputs(text.c_str(), stdout);
  return ExitCode::Done;
}

}  // namespace caustics::app
