// caustics plan: what a scene holds and calls for, and what would run, without rendering it.
#include <cstdio>

#include "app/plan_report.hpp"
#include "app/terminal.hpp"
#include "passes/registry.hpp"

namespace caustics::app {

ExitCode run_plan_command(const Arguments& arguments) {
  Parser parser("plan",
                "Says what a scene holds, which effects and passes run and why, and where caustics "
                "are to be expected.",
                "  caustics plan scene.glb\n"
                "  caustics plan scene.glb --assume-solid      what would change\n"
                "  caustics plan scene.glb --json | jq .expectations\n");
  FrameRequest request;
  std::string scene;
  bool json = false;
  parser.positional("SCENE", "a glTF 2.0 file, .gltf or .glb", scene);
  parser.group("Output");
  parser.flag("--json", json, "one JSON document instead of the text (default text)");
  add_frame_options(parser, request);
  if (!parser.parse(arguments)) return ExitCode::Done;
  request.scene = scene;
  check_request(request, "plan");
  const std::unique_ptr<JudgedScene> judged = load_scene(request);
  // What `render` runs for a PNG picture.
  const FramePlan plan =
      make_plan(judged->scene(), judged->effects(), request.settings, pass_registry(), {{"picture"}});
  const PlanReport report{*judged, request.settings, plan};
  const std::string text = json ? plan_json(report) : plan_text(report, has_colour(stdout));
  std::fputs(text.c_str(), stdout);
  return ExitCode::Done;
}

}  // namespace caustics::app
