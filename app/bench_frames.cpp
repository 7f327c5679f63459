#include "app/bench_frames.hpp"

#include <sys/resource.h>

#include <cstdlib>
#include <memory>
#include <optional>
#include <set>

#include "app/flux.hpp"
#include "app/frame.hpp"
#include "app/loaded_scene.hpp"
#include "app/machine_limits.hpp"
#include "app/output/attachments.hpp"
#include "app/shell/interrupt.hpp"
#include "app/shell/progress.hpp"
#include "app/shell/terminal.hpp"
#include "gl_backend/gl_device.hpp"
#include "gl_backend/gl_probe.hpp"
#include "pipeline/gpu/sha256.hpp"

namespace caustics::app {

namespace {

struct AttachmentHash {
  std::string pass, texture, hash;
};

// Of a run whose draws were left out only the attachments, which were cleared.
std::uint64_t bytes_bound(const PassRun& run, const Device& device, bool left_out) {
  std::set<TextureId> bound(run.colors.begin(), run.colors.end());
  bound.insert(run.depth);
  if (!left_out)
    for (const Draw& draw : run.draws) bound.insert(draw.textures.begin(), draw.textures.end());
  bound.erase(TextureId::None);
  std::uint64_t bytes = 0;
  for (const TextureId texture : bound) {
    const ImageShape shape = device.shape(texture);
    bytes += bytes_per_texel(shape.format) * static_cast<std::uint64_t>(shape.width) *
             static_cast<std::uint64_t>(shape.height);
  }
  return bytes;
}

// The frame that `render` draws for a picture, on one device.
class Bench {
 public:
  Bench(FrameRequest request, Backend backend, Progress& progress, std::optional<Lanes> lanes = {})
      : progress_(progress) {
    request.backend.backend = backend;
    request.backend.lanes = lanes;
    request.backend.measure = true;
    request.backend.compiling = [this](std::string_view shader) {
      progress_.show("compiling shader " + std::string(shader));
    };
    device_.backend = backend;
    const Stopwatch watch;
    frame_ = std::make_unique<RenderedFrame>(request, load_scene(request), goal_with_ledgers({"picture"}));
    device_.description = frame_->device().description();
    device_.prepared = watch.milliseconds();
    device_.passes.resize(frame_->plan().passes.size());
    device_.counts.resize(frame_->plan().passes.size());
  }

  // Draws a frame that is not measured, and hashes what each pass leaves.
  std::vector<AttachmentHash> hashes(const std::string& step) {
    std::vector<AttachmentHash> result;
    frame_->run([&](const PlannedPass& pass, const PassResult&, std::size_t done, std::size_t of) {
      progress_.show(step + ", hashing pass " + std::to_string(done) + " of " + std::to_string(of));
      for_each_attachment(*frame_, pass, [&](const Attachment& attachment) {
        result.push_back({pass.label, attachment.texture.name, sha256(attachment.image)});
      });
      return true;
    });
    return result;
  }

  void warm_up() {
    frame_->run();
    frame_->device().finish();
  }

  void measure() {
    double wall = 0.0, processor = 0.0;
    const Stopwatch watch;
    frame_->run([&](const PlannedPass&, const PassResult& result, std::size_t done, std::size_t) {
      device_.passes[done - 1].add(result.milliseconds, result.processor_milliseconds);
      device_.counts[done - 1] = result;
      wall += result.milliseconds;
      processor += result.processor_milliseconds;
      return true;
    });
    frame_->device().finish();
    device_.frames.add(watch.milliseconds(), watch.processor_milliseconds());
    device_.sums.add(wall, processor);
  }

  const RenderedFrame& frame() const { return *frame_; }
  const BenchedDevice& device() const { return device_; }

 private:
  Progress& progress_;
  std::unique_ptr<RenderedFrame> frame_;
  BenchedDevice device_;
};

std::vector<BenchedPass> passes_of(const RenderedFrame& frame, const std::vector<PassResult>& counts) {
  std::vector<BenchedPass> passes;
  for (const PlannedPass& pass : frame.plan().passes) {
    const bool left_out = counts[passes.size()].left_out;
    passes.push_back({pass.label, pass.definition->name, pass.definition->count_samples,
                      bytes_bound(frame.prepare(pass), frame.device(), left_out), 0});
  }
  return passes;
}

// The first of all attachments whose hashes differ, in words; counts them.
std::string first_difference(const std::vector<AttachmentHash>& a, const std::vector<AttachmentHash>& b,
                             std::size_t& count) {
  if (a.size() != b.size()) throw Error(ExitCode::InternalError, "two frames of one plan differ in passes");
  std::string first;
  count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].hash == b[i].hash) continue;
    if (count++ == 0) first = "pass '" + a[i].pass + "', attachment '" + a[i].texture + "'";
  }
  return first;
}

std::string digest_of(const std::vector<AttachmentHash>& hashes) {
  Sha256 all;
  for (const AttachmentHash& each : hashes) {
    const std::string line = each.pass + " " + each.texture + " " + each.hash + "\n";
    all.add(line.data(), line.size());
  }
  return all.hexadecimal();
}

std::uint64_t peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
}

class BenchSession {
 public:
  BenchSession(const BenchRequest& request, int threads) : request_(request) {
    run_.scene = one_line(request.frame.scene.string());
    run_.threads = request_.frame.backend.threads = threads;
    if (request.against_gl || request.frame.backend.backend == Backend::OpenGl)
      // llvmpipe's threads beside the calling one; 0: it draws itself.
      setenv("LP_NUM_THREADS", std::to_string(threads > 1 ? threads : 0).c_str(), 1);
  }

  BenchRun run() {
    make(request_.frame.backend.backend);
    if (request_.against_gl) make(Backend::OpenGl);
    hash("first frame");
    each("warming up", &Bench::warm_up);
    for (int n = 0; n < request_.frames; ++n)
      each("frame " + std::to_string(n + 1) + " of " + std::to_string(request_.frames), &Bench::measure);
    hash("last frame");
    compare_devices();
    run_.settings = benches_.front()->frame().settings();
    run_.passes = passes_of(benches_.front()->frame(), benches_.front()->device().counts);
    for (const auto& bench : benches_) run_.devices.push_back(bench->device());
    run_.peak_memory = peak_memory();
    benches_.clear();  // their memory may be needed now
    count_operations();
    show("measuring the memory's bandwidth");
    run_.bandwidth = memory_bandwidth(run_.threads);
    show("measuring the arithmetic's peak");
    run_.peak = arithmetic_peak(run_.threads);
    return run_;
  }

 private:
  void make(Backend backend) {
    show("finding where the light goes");
    benches_.push_back(std::make_unique<Bench>(request_.frame, backend, progress_));
  }

  void count_operations() {
    show("counting operations");
    Bench scalar(request_.frame, Backend::Software, progress_, Lanes::Scalar);
    scalar.measure();
    for (std::size_t i = 0; i < run_.passes.size(); ++i)
      run_.passes[i].operations = scalar.device().counts[i].operations;
  }

  void each(const std::string& step, void (Bench::*work)()) {
    show(step);
    for (const auto& bench : benches_) (*bench.*work)();
  }

  std::string named(const std::string& step) const {
    return std::to_string(run_.threads) + (run_.threads == 1 ? " thread: " : " threads: ") + step;
  }

  void show(const std::string& step) {
    stop_if_interrupted();
    progress_.show(named(step));
  }

  // Before the measured frames, and after them.
  void hash(const std::string& step) {
    const bool again = !hashes_.empty();
    for (std::size_t i = 0; i < benches_.size(); ++i) {
      const std::vector<AttachmentHash> found = benches_[i]->hashes(named(step));
      if (!again) {
        hashes_.push_back(found);
        continue;
      }
      std::size_t count = 0;
      const std::string first = first_difference(hashes_[i], found, count);
      if (count > 0 && run_.fault.empty())
        run_.fault =
            first + " changed between the first and the last frame on " + benches_[i]->device().description;
    }
    run_.attachments = hashes_.front().size();
    run_.digest = digest_of(hashes_.front());
  }

  void compare_devices() {
    if (benches_.size() < 2) return;
    const std::string first = first_difference(hashes_[0], hashes_[1], run_.differing);
    if (run_.differing == 0) return;
    const DriverClass driver = class_of(probe(dynamic_cast<GlDevice&>(benches_[1]->frame().device())));
    if (driver != DriverClass::LlvmpipeFused) {
      run_.allowance = name_of(driver);
    } else if (run_.fault.empty()) {
      run_.fault = first + " has other bits on OpenGL";
    }
  }

  BenchRequest request_;
  BenchRun run_;
  Progress progress_{false};
  std::vector<std::unique_ptr<Bench>> benches_;
  std::vector<std::vector<AttachmentHash>> hashes_;  // by `benches_`
};

}  // namespace

BenchRun measure_frames(const BenchRequest& request, int threads) {
  return BenchSession(request, threads).run();
}

}  // namespace caustics::app
