// caustics render: a scene to pictures.
#include <cmath>

#include "app/atomic_file.hpp"
#include "app/dump.hpp"
#include "app/interrupt.hpp"
#include "app/outputs.hpp"
#include "app/progress.hpp"
#include "app/stats.hpp"
#include "app/summary.hpp"
#include "app/terminal.hpp"

namespace caustics::app {

namespace {

constexpr char kPurpose[] = "Renders a scene with the light that its glass and water bend.";
constexpr char kExamples[] =
    "  caustics render scene.glb                            writes scene.png here\n"
    "  caustics render scene.glb -o a.png -o a.exr -r 640x360\n"
    "  caustics render scene.glb -o a.exr --aov beauty,caustic,depth\n"
    "  caustics render scene.glb --grid 1024 --map 1024 --stats a.json\n";

struct RenderRequest {
  FrameRequest frame;
  OutputRequest outputs;
  std::string stats, dump;
  bool quiet = false;
};

// False when only the help was asked for.
bool parse(const Arguments& arguments, RenderRequest& request) {
  Parser parser("render", kPurpose, kExamples);
  std::string scene;
  parser.positional("SCENE", "a glTF 2.0 file, .gltf or .glb", scene);
  parser.group("Output");
  parser.repeated("-o,--output", "FILE",
                  ".png or .exr; may stand several times (default SCENE.png)",
                  [&](const std::string& file) { request.outputs.files.emplace_back(file); });
  parser.option("--aov", "LIST", "EXR layers, listed below, with commas between (default beauty)",
                [&](const std::string& list) { request.outputs.layers = parse_layers(list); });
  parser.option("--stats", "F.json", "times, counters and the flux ledger (default: not written)",
                [&](const std::string& file) { request.stats = file; });
  parser.option("--dump", "DIR", "every pass's attachments as EXR (default: not written)",
                [&](const std::string& folder) { request.dump = folder; });
  parser.flag("--quiet", request.quiet, "say nothing but errors");
  parser.footer("Layers for --aov, of the first surface that is hit:\n" + layer_help());
  add_frame_options(parser, request.frame);
  if (!parser.parse(arguments)) return false;
  request.frame.scene = scene;
  check_request(request.frame, "render");
  if (request.outputs.files.empty()) {
    request.outputs.files.emplace_back(request.frame.scene.stem().string() + ".png");
  }
  return true;
}

// With --dump everything that the effects call for; otherwise what the outputs depend on. `beauty`
// is always there to be checked.
PlanGoal goal_of(const RenderRequest& request) {
  PlanGoal goal;
  if (!request.dump.empty()) return goal;
  goal.textures = textures_for(request.outputs);
  goal.textures.emplace_back("beauty");
  for (const std::string& name : ledger_textures()) goal.textures.push_back(name);
  return goal;
}

// A picture with a hole in it is not written: the fault is named instead.
void refuse_non_finite(const RenderedFrame& frame) {
  const Image beauty = frame.read("beauty");
  for (int y = 0; y < beauty.height(); ++y) {
    for (int x = 0; x < beauty.width(); ++x) {
      for (int c = 0; c < beauty.channels(); ++c) {
        if (std::isfinite(beauty.at(x, y, c))) continue;
        throw Error(ExitCode::NumericFault,
                    "beauty is " + significant(beauty.at(x, y, c), 3) + " at pixel " +
                        std::to_string(x) + "," + std::to_string(beauty.height() - 1 - y) +
                        " from the top left, channel " + "RGBA"[c] +
                        "; no picture is written, --dump DIR shows every pass");
      }
    }
  }
}

ExitCode render(const RenderRequest& request) {
  const Stopwatch total;
  Timing timing;
  Progress progress(request.quiet);
  progress.show("loading " + request.frame.scene.filename().string());
  std::unique_ptr<JudgedScene> judged = load_scene(request.frame);
  timing.load = total.milliseconds();

  progress.show("finding where the light goes");
  RenderedFrame frame(request.frame, std::move(judged), goal_of(request));
  timing.prepare = total.milliseconds() - timing.load;

  std::optional<Dump> dump;
  if (!request.dump.empty()) dump.emplace(request.dump);
  const Stopwatch passes;
  const std::vector<PassReport> reports = frame.run([&](const PlannedPass& pass, const PassResult&,
                                                        std::size_t done, std::size_t of) {
    if (dump) dump->add(frame, pass);
    progress.show("pass " + std::to_string(done) + " of " + std::to_string(of) + ": " + pass.label);
    return true;
  });
  timing.passes = passes.milliseconds() - timing.write;
  if (dump) dump->finish();
  refuse_non_finite(frame);

  progress.show("writing");
  const Stopwatch writing;
  write_outputs(request.outputs, frame);
  timing.write += writing.milliseconds();
  std::vector<LightLedger> ledgers;
  if (!request.quiet || !request.stats.empty()) ledgers = read_ledgers(frame);
  timing.total = total.milliseconds();
  if (!request.stats.empty()) {
    write_atomically(request.stats, stats_text(frame, reports, ledgers, timing));
  }
  progress.clear();
  if (!request.quiet) print_summary(frame, ledgers, timing, request.outputs.files);
  return ExitCode::Done;
}

}  // namespace

ExitCode run_render(const Arguments& arguments) {
  RenderRequest request;
  if (!parse(arguments, request)) return ExitCode::Done;
  check_outputs(request.outputs);
  if (!request.stats.empty()) require_writable(request.stats);
  return render(request);
}

}  // namespace caustics::app
