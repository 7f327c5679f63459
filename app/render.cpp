// caustics render: a scene to pictures.
#include <algorithm>
#include <memory>
#include <set>

#include "app/caustic_sight.hpp"
#include "app/frame_options.hpp"
#include "app/frame_range.hpp"
#include "app/loaded_scene.hpp"
#include "app/numeric_faults.hpp"
#include "app/output/dump.hpp"
#include "app/output/image_file.hpp"
#include "app/output/outputs.hpp"
#include "app/output/reasons.hpp"
#include "app/output/stats.hpp"
#include "app/output/summary.hpp"
#include "app/output/video_file.hpp"
#include "app/shell/atomic_file.hpp"
#include "app/shell/interrupt.hpp"
#include "app/shell/on_demand.hpp"
#include "app/shell/parser.hpp"
#include "app/shell/progress.hpp"
#include "app/shell/terminal.hpp"
#include "passes/registry.hpp"
#include "pipeline/gpu/device.hpp"

namespace caustics::app {

namespace {

constexpr char kRenderPurpose[] = "Renders a scene with the light that its glass and water bend.";
constexpr char kRenderExamples[] =
    "  caustics render scene.glb                            writes scene.png here\n"
    "  caustics render scene.glb -o a.png -o a.exr -r 640x360\n"
    "  caustics render scene.glb -o a.exr --aov beauty,caustic,depth\n"
    "  caustics render scene.glb --grid 1024 --map 1024 --stats a.json\n"
    "  caustics render moving.glb --frames 0..99 --fps 25 -o frame.%04d.png --resume\n"
    "  caustics render moving.glb -o film.mp4\n";

constexpr Limits<double> kTargetError{0.001, 100.0};  // percent

struct RenderRequest {
  FrameRequest frame;
  OutputRequest outputs;
  RunFiles beside;  // FrameRequest::files but those of the outputs
  std::optional<FrameRange> frames;
  double rate = 24.0;  // frames a second
  bool timed = false, resume = false;
  std::string stats, dump;
  bool pictures = false;  // of the dump
  Demand demand;
  bool quiet = false, verbose = false;

  // Are the ledgers of a frame asked for, and its error? They take longer than a preview.
  bool books() const {
    return wants_ledgers(outputs) || !stats.empty() || demand.any() || !(quiet || frame.preview);
  }
  bool films() const { return std::any_of(outputs.files.begin(), outputs.files.end(), is_video); }
  // Is there a row of frames, rather than one?
  bool several() const { return frames ? frames->count() > 1 : films(); }
  double seconds(int frame) const { return frame / rate; }
};

// Several frames need a file each, but for films.
void check_frames(const RenderRequest& request) {
  if (request.timed && (request.frames || request.films()))
    throw Error(ExitCode::WrongUsage,
                "--time is for one still; --frames and --fps say the moments "
                "of several");
  if (request.resume && request.films())
    throw Error(ExitCode::WrongUsage, "--resume is for pictures: a film is written as a whole or not at all");
  if (request.resume && !request.frames) throw Error(ExitCode::WrongUsage, "--resume needs --frames A..B");
  if (!request.several()) return;
  if (request.demand.any())
    throw Error(ExitCode::WrongUsage,
                "--target-error and --time-budget are for one frame; take the --grid and --map that "
                "they choose for several");
  for (const std::filesystem::path& file : request.outputs.files) {
    if (has_number(file) || is_video(file)) continue;
    throw Error(ExitCode::WrongUsage, one_line(file.string()) +
                                          " would be written over by each frame; put %04d into the "
                                          "name, where the frame's number goes");
  }
  if (!request.dump.empty()) {
    throw Error(ExitCode::WrongUsage, "--dump is for one frame; use --frames N with one number");
  }
}

// Nothing is measured, so that a pixel need not be what its middle sees.
bool is_only_looked_at(const RenderRequest& request) {
  return are_for_display(request.outputs) && request.outputs.layers.empty() && request.stats.empty() &&
         request.dump.empty() && !request.demand.any();
}

void add_frame_row_options(Parser& parser, RenderRequest& request) {
  parser.option(
      "--frames", "A..B",
      {"frames A to B, both included, of a scene that moves; %d or %04d in a file's name becomes the number",
       "", "one; of a film all"},
      [&](const std::string& range) { request.frames = parse_frames(range); });
  parser.number("--fps", "F", {"frames a second: frame n shows the moment n / F seconds"},
                Limits<double>{0.01, 1000.0}, request.rate);
  parser.flag("--resume", request.resume,
              "leave out frames whose files are all there, whole and of this size");
}

// False when only the help was asked for.
bool parse(const Arguments& arguments, RenderRequest& request) {
  Parser parser("render", kRenderPurpose, kRenderExamples);
  std::string scene;
  parser.positional("SCENE", kSceneMeaning, scene);
  parser.group("Output");
  parser.repeated("-o,--output", "FILE",
                  {"a picture, or with ffmpeg a film; may stand several times",
                   known_outputs() + ", or - (PNG)", "SCENE.png in the current folder"},
                  [&](const std::string& file) { request.outputs.files.emplace_back(file); });
  parser.option("--aov", "LIST", {"layers of EXR files, listed below, with commas between", "", "beauty"},
                [&](const std::string& list) { request.outputs.layers = parse_layers(list); });
  parser.option("--stats", "F.json", {"times, counters and flux ledgers", "", "none"},
                [&](const std::string& file) { request.stats = file; });
  parser.option("--dump", "DIR",
                {"every attachment of every pass, as EXR, and what each pass was fed with", "", "none"},
                [&](const std::string& folder) { request.dump = folder; });
  parser.flag("--pictures", request.pictures,
              "beside --dump: the attachments to look at, index.html shows them");
  add_frame_row_options(parser, request);
  parser.flag("-q,--quiet", request.quiet, "say nothing but errors");
  parser.flag("-v,--verbose", request.verbose, "each pass's time and reason");
  list_layers(parser);
  parser.group("On demand");
  parser.option(
      "--target-error", "P%",
      {"choose grid and map for this estimated error (docs/accuracy.md); exit code 6 where it is missed",
       text_of(kTargetError), "none"},
      [&](const std::string& value) {
        request.demand.error = parse_percent("--target-error", value, kTargetError);
      });
  parser.number("--time-budget", "MS",
                {"or the most accurate whose passes take no longer, milliseconds; likewise", "", "none"},
                Limits<double>{0.01, 1e7}, request.demand.milliseconds);
  add_frame_options(parser, request.frame);
  if (!parser.parse(arguments)) return false;
  request.frame.scene = scene;
  request.frame.backend.measure = !request.stats.empty();
  check_request(request.frame, "render");
  request.timed = request.frame.seconds.has_value();
  if (request.outputs.files.empty()) {
    const std::string number = request.frames ? ".%04d" : "";
    request.outputs.files.emplace_back(name_of_scene(request.frame) + number + ".png");
  }
  if (request.demand.error && request.demand.milliseconds)
    throw Error(ExitCode::WrongUsage, "--target-error and --time-budget exclude each other");
  if (request.pictures && request.dump.empty())
    throw Error(ExitCode::WrongUsage, "--pictures needs --dump DIR, the folder that they are put in");
  check_frames(request);
  if (request.frame.settings.samples == 0 && is_only_looked_at(request))
    request.frame.settings.samples = kShownSamples;
  return true;
}

// With --dump everything that the effects call for; otherwise what the outputs depend on, and the caustics
// where figures of them are asked for. `beauty` is kept to be checked.
PlanGoal goal_of(const RenderRequest& request) {
  if (!request.dump.empty()) return {.light_by_light = true};
  if (!request.books())
    return {.textures = textures_for(request.outputs), .beside = {"beauty"}, .light_by_light = true};
  PlanGoal goal = goal_with_ledgers(textures_for(request.outputs));
  if (!request.quiet) goal.textures.emplace_back(kCastersBeyondPanes);
  if (request.stats.empty() && !request.demand.any()) return goal;
  for (const std::string& name : ledger_textures()) goal.textures.push_back(name);
  return goal;
}

std::set<std::string> shaders_of(const FramePlan& plan) {
  std::set<std::string> names;
  for (const PlannedPass& pass : plan.passes) names.emplace(pass.definition->shader->name);
  return names;
}

// What the frame's passes take, roughly: the texels of their targets. Times told from it were within a factor
// of 1.5 after a quarter of the time, of three scenes.
std::vector<double> shares_done(const FramePlan& plan) {
  std::vector<double> sums{0.0};
  for (const PlannedPass& pass : plan.passes)
    sums.push_back(sums.back() + static_cast<double>(pass.width) * pass.height);
  const double all = std::max(sums.back(), 1.0);
  for (double& sum : sums) sum /= all;
  return sums;
}

// The files of one frame.
OutputRequest outputs_of(const RenderRequest& request, int frame) {
  OutputRequest outputs = request.outputs;
  if (!request.frames) return outputs;
  for (std::filesystem::path& file : outputs.files)
    if (!is_video(file)) file = numbered(file, frame);
  return outputs;
}

// Tells the list of every file of every frame; the first frame's are tried, too.
void require_outputs(const RenderRequest& request, RunFiles& files) {
  const FrameRange range = request.frames.value_or(FrameRange{});
  for (const std::filesystem::path& file : request.outputs.files) {
    const bool one_a_frame = request.frames && has_number(file) && !is_video(file);
    require_output(files, one_a_frame ? numbered(file, range.first) : file, "-o", Content::Binary);
    for (int n = range.first + 1; one_a_frame && n <= range.last; ++n) files.writes(numbered(file, n), "-o");
  }
}

// Is there a whole file for each output of the frame? Files appear whole or not at all, so that their
// heads are enough to look at.
bool is_there(const RenderRequest& request, int frame) {
  const Settings& settings = request.frame.settings;
  const OutputRequest outputs = outputs_of(request, frame);
  return std::all_of(outputs.files.begin(), outputs.files.end(), [&](const std::filesystem::path& file) {
    return is_image_of_size(file, settings.width, settings.height);
  });
}

// Those that are to be drawn.
std::vector<int> frames_to_draw(const RenderRequest& request) {
  std::vector<int> frames;
  const FrameRange range = request.frames.value_or(FrameRange{});
  for (int n = range.first; n <= range.last; ++n)
    if (!request.resume || !is_there(request, n)) frames.push_back(n);
  return frames;
}

// A film of no given frames shows the whole animation once.
FrameRange whole_animation(const LoadedScene& scene, double rate) {
  if (!(scene.duration() > 0.0)) {
    throw Error(ExitCode::WrongUsage,
                "nothing moves in the scene, so a film has no length: say --frames A..B");
  }
  // A duration is stored in single precision: a hair beyond a whole number of frames is none more.
  return frames_up_to(scene.duration() * rate - 1e-4);
}

class Renderer {
 public:
  explicit Renderer(RenderRequest request)
      : request_(std::move(request)), progress_(request_.quiet), todo_(frames_to_draw(request_)) {
    if (request_.frames && !todo_.empty()) request_.frame.seconds = request_.seconds(todo_.front());
    request_.frame.backend.compiling = [this](std::string_view shader) { show_compiling(shader); };
  }

  ExitCode render() {
    if (!todo_.empty()) {
      if (request_.demand.any()) {
        choose_sizes();
        total_ = Stopwatch();  // choosing is told by itself
      }
      prepare();
      for (const int n : todo_) {
        draw(n);
        const std::string which = request_.several() ? "frame " + std::to_string(n) + ": " : "";
        const std::vector<std::string> checked =
            frame_->has("beauty") ? std::vector<std::string>{"beauty"} : textures_for(request_.outputs);
        for (const std::string& texture : checked) refuse_numeric_faults(*frame_, texture, which);
        write(n);
        ++done_;
      }
    }
    finish();
    return met_ ? ExitCode::Done : ExitCode::TargetMissed;
  }

 private:
  void choose_sizes() {
    const Stopwatch watch;
    std::optional<CostModel> model =
        measure_costs(request_.frame, request_.demand, [&](const std::string& text) {
          stop_if_interrupted();
          progress_.show(text);
        });
    if (!model) return;
    SizeSearch search(*model, request_.demand);
    while (const std::optional<Trial> next = search.next()) {
      progress_.show("trying grid " + std::to_string(next->grid) + " and map " + std::to_string(next->map));
      const std::optional<Trial> found = try_sizes(request_.frame, request_.demand, next->grid, next->map);
      if (!found) break;
      search.learn(*found);
    }
    found_ = search.chosen();
    if (!found_) return;
    met_ = meets(*found_, request_.demand);
    only_model_ = search.only_model();
    request_.frame.settings.grid = found_->grid;
    request_.frame.settings.map = found_->map;
    choosing_ = watch.milliseconds();
  }

  // How many shaders there are is known once there is a frame.
  void show_compiling(std::string_view shader) {
    if (!compiled_.emplace(shader).second) return;  // with other choices
    std::string text = "compiling shaders " + std::to_string(compiled_.size());
    if (frame_) {
      std::set<std::string> all = shaders_of(frame_->plan());
      all.insert(compiled_.begin(), compiled_.end());
      text += " of " + std::to_string(all.size());
    }
    progress_.show(text + ": " + std::string(shader));
  }

  void prepare() {
    compiled_.clear();  // what was tried before had devices of its own
    progress_.show("loading " + request_.frame.scene.filename().string());
    std::unique_ptr<LoadedScene> loaded = load_scene(request_.frame);
    if (!request_.frames && request_.films()) {
      request_.frames = whole_animation(*loaded, request_.rate);
      require_all_frames(*loaded);
      todo_ = frames_to_draw(request_);
    }
    if (!loaded->moves() && loaded->scene().waters.empty()) say_that_nothing_moves();
    timing_.load = total_.milliseconds();
    if (!todo_.empty() && request_.frames) check_water_work(loaded->scene(), request_.seconds(todo_.back()));
    progress_.show("finding where the light goes");
    frame_.emplace(request_.frame, std::move(loaded), goal_of(request_), nullptr,
                   [outputs = request_.outputs, beside = beside_pictures()](const PlannedFrame& frame) {
                     return writing_bytes(frame, outputs, beside);
                   });
    timing_.prepare = total_.milliseconds() - timing_.load;
    if (!request_.dump.empty()) dump_.emplace(request_.dump, request_.pictures);
    const Settings& size = request_.frame.settings;
    for (const std::filesystem::path& file : request_.outputs.files)
      if (is_video(file))
        films_.push_back(std::make_unique<VideoFile>(file, size.width, size.height, request_.rate));
    started_ = Stopwatch();
  }

  WrittenBeside beside_pictures() const {
    return {
        .stats = !request_.stats.empty(), .dumped = !request_.dump.empty(), .pictures = request_.pictures};
  }

  // How many frames there are has just been found: pictures beside a film have their names from it.
  void require_all_frames(const LoadedScene& loaded) const {
    RunFiles files = request_.beside;
    for (const std::filesystem::path& file : loaded.files()) files.reads(file, "a file of the scene");
    require_outputs(request_, files);
  }

  void say_that_nothing_moves() {
    if (request_.quiet || !(request_.several() || request_.timed)) return;
    progress_.clear();
    std::fputs(request_.several() ? "note: nothing moves in the scene: all frames are the same\n"
                                  : "note: nothing moves in the scene: --time changes nothing\n",
               stderr);
  }

  void draw(int n) {
    if (done_ > 0 && frame_->moves()) {
      progress_.show(frame_text(n) + "finding where the light goes");
      const Stopwatch watch;
      frame_->move_to(request_.seconds(n));
      timing_.prepare += watch.milliseconds();
    }
    // Of a row of frames the last one's, but for layers that are made from them.
    const bool layered = wants_ledgers(request_.outputs);
    const bool booked = layered || (n == todo_.back() && request_.books());
    const bool said = n == todo_.back() && !request_.quiet;
    if (layered) books_ = {};
    const std::vector<double> shares = shares_done(frame_->plan());
    const Stopwatch watch;
    reports_ = frame_->run([&](const PlannedPass& pass, const PassResult&, std::size_t done, std::size_t of) {
      if (booked) books_.look(*frame_, pass);
      if (said) sight_.look(*frame_, pass);
      if (dump_) dump_->add(*frame_, pass);
      progress_.show(frame_text(n) + "pass " + std::to_string(done) + " of " + std::to_string(of) + ": " +
                     pass.label + (request_.several() ? "" : left_text(watch.milliseconds(), shares[done])));
      return true;
    });
    frame_->device().finish();
    frame_times_.push_back(watch.milliseconds() - books_.milliseconds() - sight_.milliseconds());
    timing_.passes += frame_times_.back();
    if (frame_times_.size() == 1) first_made_ = frame_->device().made();
    if (dump_) dump_->finish();
  }

  void write(int n) {
    progress_.show(frame_text(n) + "writing");
    const Stopwatch watch;
    write_outputs(outputs_of(request_, n), *frame_, books_.ledgers());
    if (!films_.empty()) {
      const Image picture = frame_->read("picture");
      for (const auto& film : films_) film->add(picture);
    }
    timing_.write += watch.milliseconds();
  }

  void finish() {
    progress_.show("finishing");
    for (const auto& film : films_) film->finish();
    const int there = request_.frames ? request_.frames->count() - static_cast<int>(todo_.size()) : 0;
    if (!frame_) {
      progress_.clear();
      if (!request_.quiet)
        std::fprintf(stderr, "all %d frames are there already, nothing was drawn\n", there);
      return;
    }
    const std::vector<LightLedger> ledgers = books_.ledgers();
    timing_.total = total_.milliseconds();
    if (!request_.stats.empty()) {
      write_atomically(request_.stats,
                       stats_text(*frame_, reports_, ledgers, timing_, {frame_times_, first_made_}));
    }
    progress_.clear();
    if (request_.quiet) return;
    print_summary(*frame_, ledgers, sight_.seen(), request_.frame.given, request_.verbose);
    if (found_) std::fputs(demand_text(request_.demand, *found_, only_model_, choosing_).c_str(), stderr);
    print_work(*frame_, timing_, request_.outputs.files,
               request_.several() ? static_cast<int>(todo_.size()) : 0);
    if (request_.verbose) print_reasons(*frame_, reports_);
    if (there > 0) std::fprintf(stderr, "%d frames were there already\n", there);
  }

  // "frame 3 of 20, 12 s left: "; in a resumed row only what is drawn counts.
  std::string frame_text(int n) const {
    if (!request_.several()) return {};
    std::string text = "frame " + std::to_string(n) + " (" + std::to_string(done_ + 1) + " of " +
                       std::to_string(todo_.size()) + ")";
    if (done_ > 0) {
      const double each = started_.milliseconds() / static_cast<double>(done_);
      text += ", " + duration_text(each * static_cast<double>(todo_.size() - done_)) + " left";
    }
    return text + ": ";
  }

  RenderRequest request_;
  Stopwatch total_, started_;  // the program; the first frame
  Timing timing_;
  Progress progress_;
  std::vector<int> todo_;  // frames to draw
  std::size_t done_ = 0;   // of todo_
  std::vector<std::unique_ptr<VideoFile>> films_;
  // On demand: what the sizes were expected to give, and what they gave.
  std::optional<Trial> found_;
  bool only_model_ = false;
  double choosing_ = 0.0;
  bool met_ = true;
  std::optional<RenderedFrame> frame_;
  std::set<std::string> compiled_;  // shaders, by the frame's device
  std::optional<Dump> dump_;
  std::vector<PassReport> reports_;  // of the last frame
  LedgerReader books_;               // likewise
  CausticSight sight_;               // likewise
  std::vector<double> frame_times_;
  DeviceObjects first_made_;  // after the first frame
};

}  // namespace

ExitCode run_render(const Arguments& arguments) {
  RenderRequest request;
  if (!parse(arguments, request)) return ExitCode::Done;
  check_outputs(request.outputs);
  RunFiles& files = request.frame.files;
  if (!request.dump.empty()) require_dump_folder(files, request.dump, "--dump", request.pictures);
  if (!request.stats.empty()) require_output(files, request.stats, "--stats", Content::Text);
  request.beside = files;
  require_outputs(request, files);
  for (const std::filesystem::path& file : request.outputs.files)
    if (is_video(file)) require_ffmpeg(file);
  return Renderer(std::move(request)).render();
}

}  // namespace caustics::app
