#include "app/reference_options.hpp"

#include "app/reference_layers.hpp"
#include "app/shell/setting_options.hpp"
#include "pipeline/gpu/text.hpp"

namespace caustics::app {

namespace {

constexpr char kReferencePurpose[] =
    "Traces light through a scene's casters ray by ray, without maps: the truth that 'render' is measured\n"
    "against, with its own noise beside it. Slower, and exact but for that noise.";
constexpr char kReferenceExamples[] =
    "  caustics reference scene.glb -o truth.exr -r 640x360\n"
    "  caustics reference scene.glb -o truth.exr --error 1% --seconds 600\n"
    "  caustics reference scene.glb -o truth.exr --batches 64 --resume   goes on where it stopped\n"
    "  caustics reference scene.glb -o single.exr --physics single      only the light that render follows\n";

constexpr int kUsualBatches = 16;
constexpr Limits<int> kRays{1, 16384}, kBatches{2, 1'000'000};
constexpr Limits<double> kSeconds{0.0, 1e7}, kErrors{1e-6, 1000.0};  // errors in percent

tracer::Physics parse_physics(const std::string& name) {
  if (name == "single") return tracer::Physics::Single;
  if (name == "full") return tracer::Physics::Full;
  throw Error(ExitCode::WrongUsage, "--physics cannot be " + in_quotes(name) + ": single or full");
}

void add_physics(Parser& parser, SettingOptions& options, ReferenceRequest& request) {
  parser.group("Light");
  parser.option("--physics", "NAME",
                {"single: light goes in, out, and lands, as render has it; full: it meets every surface",
                 "single|full", "full"},
                [&](const std::string& value) { request.trace.physics = parse_physics(value); });
  options.add("interfaces");
  options.add("wavelengths");
  parser.repeated("--exact", "scene|NAME=SHAPE",
                  {"no facets: the shapes that the file states, or a mesh's; may stand several times",
                   "sphere|cylinder|waves"},
                  [&](const std::string& value) { request.exact.add(value); });
  options.add("assume_solid");
  options.add_any(traced_parts(), "means nothing to the reference, which has no maps and no picture to show");
}

void add_effort(Parser& parser, ReferenceRequest& request) {
  parser.group("Effort (whatever comes first ends the run)");
  parser.number("--rays", "N", {"N x N rays a batch for each light"}, kRays, request.trace.side);
  parser.number("--batches", "N",
                {"so many batches in all", "", std::to_string(kUsualBatches) + " without the others"},
                kBatches, request.batches);
  parser.number("--seconds", "S", {"no batch is begun after so long", "", "none"}, kSeconds, request.seconds);
  parser.option("--error", "P%",
                {"until the standard errors add up to P% of the caustics; exit code 6 where they do not",
                 text_of(kErrors), "none"},
                [&](const std::string& value) { request.error = parse_percent("--error", value, kErrors); });
  parser.flag("--resume", request.resume, "go on from FILE.state, which every run leaves beside its output");
  add_threads_option(parser, request.trace.threads);
  add_memory_option(parser, request.frame);
}

}  // namespace

std::vector<Setting::Part> traced_parts() { return {Setting::Part::View, Setting::Part::Light}; }

bool parse_reference(const Arguments& arguments, ReferenceRequest& request) {
  Parser parser("reference", kReferencePurpose, kReferenceExamples);
  std::string scene;
  parser.positional("SCENE", kSceneMeaning, scene);
  parser.group("Output");
  parser.option("-o,--output", "FILE.exr",
                {"where the layers go", ".exr, -", "SCENE.reference.exr in the current folder"},
                [&](const std::string& file) { request.output = file; });
  parser.option("--aov", "LIST", {"layers, listed below, with commas between", "", "all"},
                [&](const std::string& list) { request.layers = parse_reference_layers(list); });
  parser.option("--stats", "F.json", {"rays, time, error and the flux ledger", "", "none"},
                [&](const std::string& file) { request.stats = file; });
  parser.flag("-q,--quiet", request.quiet, "say nothing but errors");
  SettingOptions options(parser, request.frame.settings, request.frame.given);
  parser.group("View");
  options.add_resolution();
  for (const char* name : {"camera", "view", "zoom", "fov", "ground", "sun"}) options.add(name);
  add_moment_options(parser, request.frame);
  list_reference_layers(parser);
  add_physics(parser, options, request);
  add_effort(parser, request);
  if (!parser.parse(arguments)) return false;
  request.frame.scene = scene;
  check_request(request.frame, "reference");
  if (request.output.empty()) request.output = name_of_scene(request.frame) + ".reference.exr";
  if (request.resume && !request.keeps_state())
    throw Error(ExitCode::WrongUsage,
                "--resume goes on from a file beside -o FILE.exr, and there is none beside -");
  if (request.layers.empty()) request.layers = all_reference_layers();
  if (!request.batches && !request.seconds && !request.error) request.batches = kUsualBatches;
  request.trace.width = request.frame.settings.width;
  request.trace.height = request.frame.settings.height;
  return true;
}

}  // namespace caustics::app
