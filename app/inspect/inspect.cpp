// caustics inspect: one page that shows every pass of a frame, or of two.
#include <cstdio>
#include <optional>

#include "app/compare/folder_difference.hpp"
#include "app/frame_options.hpp"
#include "app/inspect/dump_run.hpp"
#include "app/inspect/page.hpp"
#include "app/inspect/run_recorder.hpp"
#include "app/inspect/setting_sweeps.hpp"
#include "app/inspect/vertex_paths.hpp"
#include "app/json.hpp"
#include "app/loaded_scene.hpp"
#include "app/shell/atomic_file.hpp"
#include "app/shell/parser.hpp"
#include "app/shell/progress.hpp"
#include "app/shell/setting_options.hpp"
#include "app/shell/terminal.hpp"
#include "app/shell/version.hpp"
#include "pipeline/gpu/error.hpp"

namespace caustics::app {

namespace {

constexpr int kMostPathGrid = 1024;

struct InspectRequest {
  FrameRequest frame;
  std::filesystem::path output;
  std::vector<std::string> against;
  RecordingLimits limits;
  bool quiet = false;
};

bool parse(const Arguments& arguments, InspectRequest& request) {
  Settings& settings = request.frame.settings;
  settings.width = 640;
  settings.height = 360;
  settings.grid = 256;
  settings.map = 512;
  settings.shadow = 512;
  Parser parser("inspect",
                "Writes one page that shows every pass of a frame: its attachments by their meaning, where\n"
                "a pixel gets its light, the way of a ray, the history of a texel, where the flux goes. It\n"
                "needs no network and no server. Sizes are moderate unless given: " +
                    differing(settings) + ".",
                "  caustics inspect scene.glb -o scene.html\n"
                "  caustics inspect scene.glb --against gl\n"
                "  caustics inspect scene.glb --against iterations=1 --against estimator=paper\n");
  std::string scene;
  parser.positional("SCENE", kSceneMeaning, scene);
  parser.group("Page");
  parser.option("-o,--output", "FILE.html", {"the page", ".html, -", "SCENE.html in the current folder"},
                [&](const std::string& value) { request.output = value; });
  parser.repeated(
      "--against", "WHAT",
      {"a second run beside the first: by OpenGL, with this key of -D changed (several keys change "
       "together), or a folder of --dump, of this or another renderer",
       "gl|KEY=VALUE|DIR", "none"},
      [&](const std::string& value) { request.against.push_back(value); });
  parser.flag("-q,--quiet", request.quiet, "say nothing but errors");
  add_frame_options(parser, request.frame);
  if (!parser.parse(arguments)) return false;
  request.frame.scene = scene;
  check_request(request.frame, "inspect");
  require_one_sample(request.frame.settings, "inspect");
  if (request.output.empty()) request.output = name_of_scene(request.frame) + ".html";
  if (!is_standard_output(request.output) && request.output.extension() != ".html" &&
      request.output.extension() != ".htm")
    throw Error(ExitCode::WrongUsage, "-o " + one_line(request.output.string()) + ": a page is a file .html");
  return true;
}

// The first request with what --against changes.
FrameRequest other_request(const InspectRequest& request) {
  FrameRequest other = request.frame;
  for (const std::string& what : request.against) {
    const std::size_t equals = what.find('=');
    if (what == "gl")
      other.backend.backend = Backend::OpenGl;
    else if (equals == std::string::npos)
      throw Error(ExitCode::WrongUsage, "--against cannot be '" + one_line(what) +
                                            "': gl, key=value, as in iterations=1, or a folder of --dump");
    else
      set_option(other.settings, what.substr(0, equals), what.substr(equals + 1));
  }
  require_one_sample(other.settings, "inspect");
  return other;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + one_line(word);
  return text;
}

Json record(const std::string& name, const FrameRequest& request, const std::shared_ptr<LoadedScene>& loaded,
            const RecordingLimits& limits, Progress& progress, Blobs& blobs) {
  progress.show("finding where the light goes");
  RenderedFrame frame(request, loaded, goal_with_ledgers({"picture"}));
  RunRecorder recorder(name, frame, limits, blobs);
  recorder.draw([&](const PlannedPass& pass, const PassResult&, std::size_t done, std::size_t total) {
    progress.show("taking pass " + std::to_string(done) + " of " + std::to_string(total) + ": " + pass.label);
    return true;
  });
  return std::move(recorder.json());
}

// Not of grids whose landings take seconds for each estimator.
void add_paths(const InspectRequest& request, const std::shared_ptr<LoadedScene>& loaded, Progress& progress,
               Json& run) {
  const Json& lights = run["lights"];
  if (!lights.empty() && lights[0]["grid"].get<int>() > kMostPathGrid) {
    run["left_out"].push_back("no ways of rays: the grid has more than " + std::to_string(kMostPathGrid) +
                              " vertices a side; caustics probe SCENE --texel X,Y tells one vertex's");
    return;
  }
  progress.show("following single rays by every estimator");
  for (auto& [light, paths] : vertex_paths(request.frame, loaded))
    run["lights"][static_cast<std::size_t>(light)]["paths"] = std::move(paths);
}

bool is_folder(const InspectRequest& request) {
  return request.against.size() == 1 && std::filesystem::is_directory(request.against.front());
}

// Before anything is drawn.
void check_against(InspectRequest& request) {
  if (!is_folder(request)) return void(other_request(request));
  const std::filesystem::path folder = request.against.front();
  request.frame.files.reads(folder / "manifest.json", "the manifest of --against");
  for (const DumpedAttachment& each : read_manifest(folder))
    request.frame.files.reads(each.file, "an attachment of --against");
}

Json other_run(const InspectRequest& request, const Json& first, Progress& progress, Blobs& blobs) {
  const std::string name = "B: " + joined(request.against);
  if (!is_folder(request)) {
    const FrameRequest other = other_request(request);
    return record(name, other, load_scene(other), request.limits, progress, blobs);
  }
  progress.show("reading the dump");
  Json run = dump_run(request.against.front(), first, blobs);
  run["name"] = name;
  return run;
}

}  // namespace

ExitCode run_inspect(const Arguments& arguments) {
  InspectRequest request;
  if (!parse(arguments, request)) return ExitCode::Done;
  check_against(request);
  require_output(request.frame.files, request.output, "-o", Content::Text);
  if (!request.against.empty()) request.limits.branch_bytes /= 2;  // a page of two runs is no larger
  Progress progress(request.quiet);
  Blobs blobs;
  Json runs = Json::array();
  const std::shared_ptr<LoadedScene> loaded = load_scene(request.frame);
  const char* const name = request.against.empty() ? "this run" : "A";
  runs.push_back(record(name, request.frame, loaded, request.limits, progress, blobs));
  add_paths(request, loaded, progress, runs[0]);
  if (request.against.empty()) {
    progress.show("drawing over iterations and grid sizes");
    runs[0]["sweeps"] = setting_sweeps(request.frame, loaded, blobs);
  } else {
    runs.push_back(other_run(request, runs[0], progress, blobs));
  }
  const Json recording = {{"format", 1}, {"program", version_line()}, {"runs", runs}};
  const std::string page =
      inspect_page(request.frame.scene.filename().string() + " - caustics inspect", recording, blobs);
  write_atomically(request.output, page);
  progress.clear();
  if (!request.quiet)
    std::fprintf(stderr, "%s: %.1f MB; open it in a browser\n", one_line(request.output.string()).c_str(),
                 static_cast<double>(page.size()) / 1e6);
  return ExitCode::Done;
}

}  // namespace caustics::app
