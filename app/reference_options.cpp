#include "app/reference_options.hpp"

#include <algorithm>

#include "app/reference_layers.hpp"

namespace caustics::app {

namespace {

constexpr char kReferencePurpose[] =
    "Traces light through a scene's casters ray by ray, without maps: the truth that 'render' is measured\n"
    "against, with its own noise beside it. Slower, and exact but for that noise.";
constexpr char kReferenceExamples[] =
    "  caustics reference scene.glb -o truth.exr -r 640x360\n"
    "  caustics reference scene.glb -o truth.exr --error 1% --seconds 600\n"
    "  caustics reference scene.glb -o truth.exr --batches 64 --resume   goes on where it stopped\n"
    "  caustics reference scene.glb -o full.exr --physics full          all reflections inside too\n";

constexpr int kMostRays = 16384, kMostBatches = 1'000'000, kUsualBatches = 16;
constexpr double kLongest = 1e7;  // seconds

// The settings that mean something without maps.
constexpr const char* kKeys[] = {"width",       "height",       "camera",          "emissive.lights",
                                 "interfaces",  "wavelengths",  "reflections",     "assume_solid",
                                 "mirror.metallic", "mirror.roughness", "glass.roughness"};

void assign_traced(Settings& settings, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  const std::string key = assignment.substr(0, equals);
  if (equals == std::string::npos)
    throw Error(ExitCode::WrongUsage, "-D cannot be '" + assignment.substr(0, 60) +
                                          "': key=value, as in reflections=yes");
  // set_option names the nearest of an unknown key; a known one that only maps have is refused here.
  set_option(settings, key, assignment.substr(equals + 1));
  if (std::none_of(std::begin(kKeys), std::end(kKeys), [&](const char* k) { return key == k; }))
    throw Error(ExitCode::WrongUsage,
                "-D " + key + " means nothing to the reference, which has no maps and no picture to show");
}

double parse_percent(const std::string& text) {
  const std::string number = text.ends_with('%') ? text.substr(0, text.size() - 1) : text;
  return parse_real("--error", number, 1e-6, 1000.0) / 100.0;
}

tracer::Physics parse_physics(const std::string& name) {
  if (name == "single") return tracer::Physics::Single;
  if (name == "full") return tracer::Physics::Full;
  throw Error(ExitCode::WrongUsage, "--physics cannot be '" + name.substr(0, 60) + "': single or full");
}

void add_view(Parser& parser, FrameRequest& frame) {
  parser.group("View");
  parser.option("-r,--resolution", "WxH", "size in pixels; 1..16384 each (default 1280x720)",
                [&](const std::string& value) {
                  const Pair size = parse_pair("-r", value, 1, kMaxPicture);
                  frame.settings.width = size.first;
                  frame.settings.height = size.second;
                });
  parser.option("--camera", "NAME|N", "the scene's camera (default the first, 0)",
                [&](const std::string& value) { set_option(frame.settings, "camera", value); });
  parser.option("--animation", "NAME|N", "the file's animation, or none: the scene at rest (default the first, 0)",
                [&](const std::string& value) { frame.animation = value; });
  parser.option("--time", "S", "the moment of the animation in seconds; 0..1e6 (default 0)",
                [&](const std::string& value) { frame.seconds = parse_real("--time", value, 0.0, 1e6); });
}

void add_physics(Parser& parser, ReferenceRequest& request) {
  Settings& settings = request.frame.settings;
  parser.group("Light");
  parser.option("--physics", "NAME", "single: in, out, land, as 'render'; full: every surface (default single)",
                [&](const std::string& value) { request.trace.physics = parse_physics(value); });
  parser.option("--interfaces", "N", "1 or 2 surfaces that bend, or auto: 2 for closed meshes (default auto)",
                [&](const std::string& value) { set_option(settings, "interfaces", value); });
  parser.option("--wavelengths", "N", "1, 3 or 8..64 samples of the spectrum where glass disperses (default 3)",
                [&](const std::string& value) { set_option(settings, "wavelengths", value); });
  parser.repeated("--exact", "scene|NAME=SHAPE",
                  "no facets: shapes that the file states, or a mesh's sphere, cylinder, waves",
                  [&](const std::string& value) { request.exact.add(value); });
  parser.flag("--assume-solid", settings.assume_solid,
              "glass without KHR_materials_volume is solid, not a thin wall");
  parser.repeated("-D", "KEY=VALUE", "one of the settings below; may stand several times",
                  [&](const std::string& value) { assign_traced(settings, value); });
}

void add_effort(Parser& parser, ReferenceRequest& request) {
  parser.group("Effort (whatever comes first ends the run)");
  parser.option("--rays", "N", "N x N rays a batch for each light; 1..16384 (default 512)",
                [&](const std::string& value) {
                  request.trace.side = parse_integer("--rays", value, 1, kMostRays);
                });
  parser.option("--batches", "N", "so many batches in all; 2..1e6 (default 16 without the others)",
                [&](const std::string& value) {
                  request.batches = parse_integer("--batches", value, 2, kMostBatches);
                });
  parser.option("--seconds", "S", "no batch is begun after so long; 0..1e7",
                [&](const std::string& value) {
                  request.seconds = parse_real("--seconds", value, 0.0, kLongest);
                });
  parser.option("--error", "P%", "until the standard errors add up to P% of the caustics; exit 6 if missed",
                [&](const std::string& value) { request.error = parse_percent(value); });
  parser.flag("--resume", request.resume, "go on from FILE.state, which every run leaves beside its output");
  parser.option("-t,--threads", "N", "threads, 1..1024 (default one a core); changes no bit",
                [&](const std::string& value) {
                  request.trace.threads = parse_integer("--threads", value, 1, 1024);
                });
}

}  // namespace

bool parse_reference(const Arguments& arguments, ReferenceRequest& request) {
  Parser parser("reference", kReferencePurpose, kReferenceExamples);
  std::string scene;
  parser.positional("SCENE", "a glTF 2.0 file, .gltf or .glb", scene);
  parser.group("Output");
  parser.option("-o,--output", "FILE.exr", "(default SCENE.reference.exr)",
                [&](const std::string& file) { request.output = file; });
  parser.option("--aov", "LIST", "layers, listed below, with commas between (default all)",
                [&](const std::string& list) { request.layers = parse_reference_layers(list); });
  parser.option("--stats", "F.json", "rays, time, error and the flux ledger (default: not written)",
                [&](const std::string& file) { request.stats = file; });
  parser.flag("--quiet", request.quiet, "say nothing but errors");
  add_view(parser, request.frame);
  add_physics(parser, request);
  add_effort(parser, request);
  std::string keys = "Settings for -D:\n ";
  for (const char* key : kKeys) keys += (key == kKeys[6] ? "\n  " : " ") + std::string(key);
  parser.footer("Layers, of the first surface that is hit:\n" + reference_layer_help() + keys);
  if (!parser.parse(arguments)) return false;
  request.frame.scene = scene;
  check_request(request.frame, "reference");
  if (request.output.empty()) request.output = request.frame.scene.stem().string() + ".reference.exr";
  if (request.layers.empty()) request.layers = all_reference_layers();
  if (!request.batches && !request.seconds && !request.error) request.batches = kUsualBatches;
  request.trace.width = request.frame.settings.width;
  request.trace.height = request.frame.settings.height;
  return true;
}

}  // namespace caustics::app
