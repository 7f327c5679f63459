// caustics reference: the truth that `render` is measured against, by tracing light.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "app/frame.hpp"
#include "app/loaded_scene.hpp"
#include "app/reference_layers.hpp"
#include "app/reference_options.hpp"
#include "app/reference_report.hpp"
#include "app/shell/atomic_file.hpp"
#include "app/shell/interrupt.hpp"
#include "app/shell/progress.hpp"
#include "app/shell/terminal.hpp"
#include "lab/reference/tracer/state_file.hpp"
#include "passes/registry.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/text.hpp"
#include "pipeline/image_io/image_io.hpp"
#include "pipeline/measure/frame_memory.hpp"
#include "pipeline/renderer/moving_water.hpp"
#include "raster/software_device.hpp"

namespace caustics::app {

namespace {

constexpr double kBetweenSaves = 60'000.0;  // milliseconds
// With fewer the spread of the batches tells little of the error.
constexpr std::uint64_t kLeastForError = 4;
// A pixel's surface, its sums, their squares and a batch's; and all layers, while they are written.
constexpr std::uint64_t kBytesPerPixel =
    sizeof(tracer::Seen) + 9 * sizeof(double) + std::uint64_t{32} * sizeof(float);
constexpr std::uint64_t kBytesPerTriangle = 150;  // of Embree's trees, measured

std::uint64_t bytes_needed(const Scene& scene, const tracer::TraceSettings& trace) {
  return_freed_memory();
  std::uint64_t indices = 0;
  for (const Mesh& mesh : scene.meshes) indices += mesh.indices.size();
  const std::uint64_t pixels =
      static_cast<std::uint64_t>(trace.width) * static_cast<std::uint64_t>(trace.height);
  return resident_memory().now + indices / 3 * kBytesPerTriangle + pixels * kBytesPerPixel +
         (is_image_io_loaded() ? 0 : kImageIoBytes);
}

class ReferenceRun {
 public:
  explicit ReferenceRun(ReferenceRequest request) : request_(std::move(request)), progress_(request_.quiet) {}

  ExitCode run() {
    prepare();
    trace();
    write();
    return reached_ ? ExitCode::Done : ExitCode::TargetMissed;
  }

 private:
  void prepare() {
    progress_.show("loading " + request_.frame.scene.filename().string());
    loaded_ = load_scene(request_.frame);
    effects_ = effects_of(loaded_->scene(), request_.frame.settings);
    request_.trace.exact = exact_shapes(loaded_->scene(), request_.exact);
    for (const Water& water : loaded_->scene().waters)
      for (const tracer::ExactShape& shape : request_.trace.exact)
        if (shape.mesh == water.mesh)
          throw Error(ExitCode::WrongUsage,
                      "--exact: " + in_quotes(water.name) + " is water that moves, and has no shape");
    progress_.show("what the camera sees");
    if (const std::string refusal =
            memory_refusal(bytes_needed(loaded_->scene(), request_.trace), request_.frame.budget(), "-r");
        !refusal.empty())
      throw Error(ExitCode::WrongUsage, refusal);
    show_waters();
    tracer_ = std::make_unique<tracer::Tracer>(loaded_->scene(), effects_, loaded_->camera(), request_.trace);
    stop_if_interrupted();
    text_ = tracer::request_text(loaded_->scene(), effects_, loaded_->camera(), request_.trace);
    if (request_.resume) restore();
    timing_.prepare = total_.milliseconds();
  }

  // Waves as `render` has them at that moment.
  void show_waters() {
    if (!effects_.water_waves.active) return;
    const double seconds = request_.frame.seconds.value_or(0.0);
    check_water_work(loaded_->scene(), seconds);
    device_ = make_software_device({.threads = request_.trace.threads});
    waters_ = std::make_unique<MovingWater>(loaded_->scene(), *device_, pass_registry());
    waters_->show(seconds, false);
  }

  void restore() {
    const std::filesystem::path path = request_.state_file();
    std::ifstream file(path, std::ios::binary);
    if (!file) {
      progress_.clear();
      if (!request_.quiet)
        std::fprintf(stderr, "note: there is no %s to go on from: beginning anew\n",
                     one_line(path.string()).c_str());
      return;
    }
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    try {
      tracer_->restore(tracer::from_bytes(bytes, text_, tracer_->state()));
    } catch (const Error& error) {
      throw Error(error.code(), path.string() + " " + error.what());
    }
  }

  void save() {
    if (!request_.keeps_state()) return;
    const std::string bytes = tracer::to_bytes(tracer_->state(), text_);
    // Not write_atomically, which gives up when a signal has come: that is when this file is wanted.
    PendingFile file(request_.state_file());
    file.write_all(bytes.data(), bytes.size());
    file.move_into_place();
    saved_ = watch_.milliseconds();
  }

  bool enough() const {
    const std::uint64_t batches = tracer_->state().batches;
    if (batches < 2) return false;  // one tells no error
    if (request_.batches && batches >= static_cast<std::uint64_t>(*request_.batches)) return true;
    if (request_.seconds && watch_.milliseconds() >= 1000.0 * *request_.seconds) return true;
    return met();
  }

  // Is the error asked for reached, and is there any light to trace?
  bool met() const {
    return tracer_->lights() == 0 || (request_.error && tracer_->state().batches >= kLeastForError &&
                                      tracer_->relative_error() <= *request_.error);
  }

  void trace() {
    watch_ = Stopwatch();
    error_ = tracer_->relative_error();
    const std::uint64_t first = tracer_->state().batches;
    while (!enough()) {
      timing_.batches = tracer_->state().batches - first;
      const bool whole = tracer_->run_batch([&] {
        progress_.show(progress_text());
        return interruption() != ExitCode::Done;
      });
      if (!whole) break_off();
      error_ = tracer_->relative_error();
      if (watch_.milliseconds() - saved_ > kBetweenSaves) save();
    }
    timing_.batches = tracer_->state().batches - first;
    timing_.trace = watch_.milliseconds();
    reached_ = !request_.error || met();
    if (timing_.batches > 0) save();
  }

  [[noreturn]] void break_off() {
    progress_.clear();
    if (tracer_->state().batches > 0 && request_.keeps_state()) {
      save();
      if (!request_.quiet)
        std::fprintf(stderr, "%s batches are kept in %s; --resume goes on\n",
                     grouped(tracer_->state().batches).c_str(),
                     one_line(request_.state_file().string()).c_str());
    }
    throw Error(interruption(), "interrupted");
  }

  // "batch 3 of 16, error 2.1%, 12 s left".
  std::string progress_text() const {
    const std::uint64_t done = tracer_->state().batches;
    std::string text = "batch " + grouped(done + 1);
    if (request_.batches) text += " of " + grouped(static_cast<std::uint64_t>(*request_.batches));
    if (done > 1) text += ", error " + percent(error_);
    const double left = milliseconds_left();
    if (std::isfinite(left)) text += ", " + duration_text(left) + " left";
    return text;
  }

  double milliseconds_left() const {
    const double now = watch_.milliseconds(), done = static_cast<double>(tracer_->state().batches);
    double left = std::numeric_limits<double>::infinity();
    if (request_.seconds) left = std::max(1000.0 * *request_.seconds - now, 0.0);
    if (timing_.batches == 0) return left;
    const double each = now / static_cast<double>(timing_.batches);
    if (request_.batches) left = std::min(left, each * (*request_.batches - done));
    if (request_.error && done > 1.0) {
      // The error falls as one over the root of the number of batches.
      const double ratio = error_ / *request_.error;
      left = std::min(left, each * std::max(done * ratio * ratio - done, 0.0));
    }
    return left;
  }

  void write() {
    progress_.show("shadows, writing");
    write_reference_layers(request_.output, request_.layers, *tracer_, request_.trace.threads);
    timing_.total = total_.milliseconds();
    if (!request_.stats.empty())
      write_atomically(request_.stats, reference_stats(request_, loaded_->scene(), *tracer_, timing_));
    progress_.clear();
    if (!request_.quiet) print_reference(request_, loaded_->scene(), effects_, *tracer_, timing_);
    if (!reached_)
      complain("the error is " + percent(tracer_->relative_error()) + ", not the " +
               significant(100.0 * *request_.error, 3) + "% asked for; the picture is written" +
               (request_.keeps_state() ? ", --resume goes on" : ""));
  }

  ReferenceRequest request_;
  Progress progress_;
  Stopwatch total_, watch_;
  ReferenceTiming timing_;
  std::unique_ptr<LoadedScene> loaded_;
  Effects effects_;
  std::unique_ptr<Device> device_;  // computes the waves
  std::unique_ptr<MovingWater> waters_;
  std::unique_ptr<tracer::Tracer> tracer_;
  std::string text_;  // of the request
  double saved_ = 0.0, error_ = 0.0;
  bool reached_ = true;
};

}  // namespace

ExitCode run_reference(const Arguments& arguments) {
  ReferenceRequest request;
  if (!parse_reference(arguments, request)) return ExitCode::Done;
  if (!is_standard_output(request.output) && lower_extension(request.output) != ".exr")
    throw Error(ExitCode::WrongUsage,
                request.output.string() + ": the reference is light in lux, written as .exr only");
  RunFiles& files = request.frame.files;
  require_output(files, request.output, "-o", Content::Binary);
  if (request.keeps_state())
    require_output(files, request.state_file(), "the state beside -o", Content::Binary);
  if (!request.stats.empty()) require_output(files, request.stats, "--stats", Content::Text);
  return ReferenceRun(std::move(request)).run();
}

}  // namespace caustics::app
