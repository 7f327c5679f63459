// caustics render: a scene to pictures.
#include <algorithm>
#include <cmath>

#include "app/atomic_file.hpp"
#include "app/dump.hpp"
#include "app/frame_range.hpp"
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
    "  caustics render scene.glb --grid 1024 --map 1024 --stats a.json\n"
    "  caustics render scene.glb --backend gl --frames 0..99 -o frame.%04d.png\n";

struct RenderRequest {
  FrameRequest frame;
  OutputRequest outputs;
  std::optional<FrameRange> frames;
  std::string stats, dump;
  bool quiet = false;
};

// Several frames need a file each.
void check_frames(const RenderRequest& request) {
  if (!request.frames || request.frames->count() == 1) return;
  for (const std::filesystem::path& file : request.outputs.files) {
    if (has_number(file)) continue;
    throw Error(ExitCode::WrongUsage, one_line(file.string()) +
                                          " would be written over by each frame; put %04d into the "
                                          "name, where the frame's number goes");
  }
  if (!request.dump.empty()) {
    throw Error(ExitCode::WrongUsage, "--dump is for one frame; use --frames N with one number");
  }
}

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
  parser.option("--frames", "A..B",
                "frames A to B (default one frame, no number); %04d in -o is the number",
                [&](const std::string& range) { request.frames = parse_frames(range); });
  parser.flag("--quiet", request.quiet, "say nothing but errors");
  parser.footer("Layers for --aov, of the first surface that is hit:\n" + layer_help());
  add_frame_options(parser, request.frame);
  if (!parser.parse(arguments)) return false;
  request.frame.scene = scene;
  check_request(request.frame, "render");
  if (request.outputs.files.empty()) {
    const std::string number = request.frames ? ".%04d" : "";
    request.outputs.files.emplace_back(request.frame.scene.stem().string() + number + ".png");
  }
  check_frames(request);
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

// The files of one frame.
OutputRequest outputs_of(const RenderRequest& request, int frame) {
  OutputRequest outputs = request.outputs;
  if (!request.frames) return outputs;
  for (std::filesystem::path& file : outputs.files) file = numbered(file, frame);
  return outputs;
}

class Renderer {
 public:
  explicit Renderer(const RenderRequest& request) : request_(request), progress_(request.quiet) {
    if (request.frames) frames_ = *request.frames;
  }

  void render() {
    prepare();
    for (int n = frames_.first; n <= frames_.last; ++n) {
      draw(n);
      refuse_non_finite(*frame_);
      write(n);
    }
    finish();
  }

 private:
  void prepare() {
    progress_.show("loading " + request_.frame.scene.filename().string());
    std::unique_ptr<JudgedScene> judged = load_scene(request_.frame);
    timing_.load = total_.milliseconds();
    progress_.show("finding where the light goes");
    frame_.emplace(request_.frame, std::move(judged), goal_of(request_));
    timing_.prepare = total_.milliseconds() - timing_.load;
    if (!request_.dump.empty()) dump_.emplace(request_.dump);
  }

  void draw(int n) {
    const Stopwatch watch;
    frame_->show(seconds_of(n));
    reports_ = frame_->run([&](const PlannedPass& pass, const PassResult&, std::size_t done,
                               std::size_t of) {
      if (dump_) dump_->add(*frame_, pass);
      progress_.show(frame_text(n) + "pass " + std::to_string(done) + " of " + std::to_string(of) +
                     ": " + pass.label);
      return true;
    });
    frame_times_.push_back(watch.milliseconds());
    timing_.passes += frame_times_.back();
    if (n == frames_.first) first_made_ = frame_->device().made();
    if (dump_) dump_->finish();
  }

  void write(int n) {
    progress_.show(frame_text(n) + "writing");
    const Stopwatch watch;
    write_outputs(outputs_of(request_, n), *frame_);
    timing_.write += watch.milliseconds();
  }

  void finish() {
    std::vector<LightLedger> ledgers;
    if (!request_.quiet || !request_.stats.empty()) ledgers = read_ledgers(*frame_);
    timing_.total = total_.milliseconds();
    if (!request_.stats.empty()) {
      write_atomically(request_.stats,
                       stats_text(*frame_, reports_, ledgers, timing_, {frame_times_, first_made_}));
    }
    progress_.clear();
    if (!request_.quiet) print_summary(*frame_, ledgers, timing_, request_.outputs.files);
  }

  // "frame 3 of 20, 12 s left: "
  std::string frame_text(int n) const {
    if (frames_.count() == 1) return {};
    const int done = n - frames_.first;
    std::string text = "frame " + std::to_string(done + 1) + " of " + std::to_string(frames_.count());
    if (done > 0) {
      const double each = (timing_.passes + timing_.write) / done;
      text += ", " + duration_text(each * (frames_.count() - done)) + " left";
    }
    return text + ": ";
  }

  const RenderRequest& request_;
  FrameRange frames_;
  Stopwatch total_;
  Timing timing_;
  Progress progress_;
  std::optional<RenderedFrame> frame_;
  std::optional<Dump> dump_;
  std::vector<PassReport> reports_;  // of the last frame
  std::vector<double> frame_times_;
  DeviceObjects first_made_;  // after the first frame
};

}  // namespace

ExitCode run_render(const Arguments& arguments) {
  RenderRequest request;
  if (!parse(arguments, request)) return ExitCode::Done;
  check_outputs(outputs_of(request, request.frames ? request.frames->first : 0));
  if (!request.stats.empty()) require_writable(request.stats);
  Renderer(request).render();
  return ExitCode::Done;
}

}  // namespace caustics::app
