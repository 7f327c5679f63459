// caustics parity: do both backends draw the same? Every pass by itself, and the whole frame.
#include <cstdio>

#include "app/backend.hpp"
#include "app/frame.hpp"
#include "app/frame_options.hpp"
#include "app/json.hpp"
#include "app/loaded_scene.hpp"
#include "app/output/stats.hpp"
#include "app/parity_dump.hpp"
#include "app/parity_report.hpp"
#include "app/sample_scenes.hpp"
#include "app/shell/progress.hpp"
#include "app/shell/setting_options.hpp"
#include "app/shell/terminal.hpp"
#include "app/shell/version.hpp"
#include "gl_backend/gl_device.hpp"
#include "gl_backend/gl_probe.hpp"
#include "passes/registry.hpp"

namespace caustics::app {

namespace {

struct ParityRequest {
  FrameRequest frame;
  std::vector<std::string> scenes;
  std::string dump;
  bool json = false;
};

bool parse(const Arguments& arguments, ParityRequest& request) {
  request.frame.settings = small_settings();
  Parser parser("parity",
                "Draws every pass on the software device and on OpenGL, from the same inputs, and then\n"
                "the whole frame, and compares every attachment. Exit code 1 when something differs by\n"
                "more than is allowed for this driver (docs/parity.md).\n"
                "Sizes are small unless given: " +
                    differing(request.frame.settings) + ".",
                "  caustics parity                       the sample scenes\n"
                "  caustics parity scene.glb -r 1280x720 --grid 512 --map 512\n"
                "  caustics parity scene.glb --dump differences --json\n");
  parser.positionals("SCENE", "glTF 2.0 files (default: the sample scenes)", request.scenes);
  parser.flag("--json", request.json, "the report as JSON");
  parser.option(
      "--dump", "DIR",
      {"of one scene, for each attachment that differs: .software.exr, .gl.exr, .mask.exr, and manifest.json",
       "", "none"},
      [&](const std::string& folder) { request.dump = folder; });
  add_frame_options(parser, request.frame);
  if (!parser.parse(arguments)) return false;
  if (request.scenes.empty()) request.scenes = sample_scenes();
  if (!request.dump.empty() && request.scenes.size() != 1) {
    throw Error(ExitCode::WrongUsage, "--dump takes one scene; name it");
  }
  return true;
}

class ParityCommand {
 public:
  explicit ParityCommand(const ParityRequest& request)
      : request_(request),
        progress_(request.json),
        gl_(make_gl_device(measuring(request.frame.backend))),
        driver_(class_of(probe(*gl_))) {}

  ParityReport compare(const std::string& scene, std::optional<ParityDump>& dump) {
    FrameRequest request = request_.frame;
    request.scene = scene;
    request.backend.backend = Backend::Software;
    const RenderedFrame frame(request, load_scene(request), {});
    if (!request_.dump.empty() && !dump) dump.emplace(request_.dump);
    const SceneOnDevice on_gl(frame.scene(), frame.effects(), *gl_);
    const FrameParity parity = compare_devices(
        frame.plan(), pass_registry(), frame.on_device(), on_gl, frame.inputs(),
        [&](const AttachmentParity& found, const Image& reference, const Image& tested) {
          if (dump) dump->add(found, reference, tested);
        },
        [&](const PlannedPass& pass, const PassResult&, std::size_t done, std::size_t of) {
          progress_.show(frame.scene().file + ": pass " + std::to_string(done) + " of " + std::to_string(of) +
                         ": " + pass.label);
          return true;
        });
    return {.scene = scene,
            .reference = frame.device().description(),
            .tested = gl_->description(),
            .judged = judge(parity, frame.plan(), pass_registry(), driver_)};
  }

 private:
  BackendRequest measuring(BackendRequest request) {
    request.measure = request.debug = true;
    request.compiling = [this](std::string_view shader) {
      progress_.show("compiling shader " + std::string(shader));
    };
    return request;
  }

  const ParityRequest& request_;
  Progress progress_;
  std::unique_ptr<GlDevice> gl_;
  DriverClass driver_;
};

std::string verdict_line(const ParityReport& report) {
  const JudgedFrame& judged = report.judged;
  const std::string line = one_line(report.scene) + ": ";
  if (judged.differing_values() == 0 && judged.passes()) {
    return line + std::to_string(judged.isolated.size() + judged.whole_frame.size()) +
           " comparisons of attachments, all equal to the bit";
  }
  return line + grouped(judged.differing_values()) + " values differ, " +
         (judged.passes() ? "all within" : "BEYOND") + " the bounds of the class '" +
         std::string(name_of(judged.driver)) + "'";
}

}  // namespace

ExitCode run_parity(const Arguments& arguments) {
  ParityRequest request;
  if (!parse(arguments, request)) return ExitCode::Done;
  if (!request.dump.empty()) require_dump_folder(request.frame.files, request.dump, "--dump", false);
  for (const std::string& scene : request.scenes) {
    request.frame.scene = scene;
    check_request(request.frame, "parity");
  }
  ParityCommand command(request);
  std::optional<ParityDump> dump;
  Json reports = Json::array();
  bool passes = true;
  for (const std::string& scene : request.scenes) {
    const bool names_devices = !request.json && request.scenes.size() > 1 && reports.empty();
    const ParityReport report = command.compare(scene, dump);
    passes = passes && report.judged.passes();
    reports.push_back(parity_json(report));
    if (request.json) continue;
    if (names_devices) std::printf("software: %s; gl: %s\n", report.reference.c_str(), report.tested.c_str());
    if (request.scenes.size() == 1 || !report.judged.passes())
      std::printf("%s\n", parity_text(report).c_str());
    std::printf("%s\n", verdict_line(report).c_str());
  }
  const Json document = {{"format", 1}, {"program", version_line()}, {"scenes", reports}};
  if (dump) dump->finish(document);
  if (request.json) std::printf("%s", json_text(document).c_str());
  return passes ? ExitCode::Done : ExitCode::AnswerIsNo;
}

}  // namespace caustics::app
