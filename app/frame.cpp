#include "app/frame.hpp"

#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "app/backend.hpp"
#include "app/frame_options.hpp"
#include "app/loaded_scene.hpp"
#include "app/shell/interrupt.hpp"
#include "app/shell/terminal.hpp"
#include "passes/registry.hpp"
#include "raster/software_device.hpp"

namespace caustics::app {

namespace {

std::uint64_t texture_bytes(const TextureMemory& texture) {
  return static_cast<std::uint64_t>(texture.width) * static_cast<std::uint64_t>(texture.height) *
         static_cast<std::uint64_t>(channel_count(texture.format)) * sizeof(float);
}

// The memory of the machine, or of the container that the process runs in.
std::uint64_t machine_memory() {
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGE_SIZE);
  std::uint64_t bytes = std::uint64_t{8} << 30;
  if (pages > 0 && size > 0) {
    bytes = static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(size);
  }
  for (const char* file : {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
    std::uint64_t limit = 0;
    if (std::ifstream(file) >> limit) bytes = std::min(bytes, limit);
  }
  return bytes;
}

}  // namespace

std::uint64_t memory_needed(const FramePlan& plan) {
  std::uint64_t sum = 0, largest = 0;
  for (const TextureMemory& texture : plan.memory) {
    sum += texture_bytes(texture);
    largest = std::max(largest, texture_bytes(texture));
  }
  return sum + largest;
}

void check_memory(std::uint64_t needed, const std::string& advice) {
  const std::uint64_t allowed = machine_memory() / 4 * 3;
  if (needed <= allowed) return;
  throw Error(ExitCode::WrongUsage,
              "these sizes need " + bytes_text(static_cast<double>(needed)) + " of memory, more than the " +
                  bytes_text(static_cast<double>(allowed)) + " that this machine can spare; lower " + advice);
}

void check_memory(const FramePlan& plan) {
  check_memory(memory_needed(plan), "-r, --grid, --map or -D shadow");
}

std::unique_ptr<Device> make_pilot_device(const BackendRequest& backend) {
  return make_software_device({.threads = backend.threads});
}

RenderedFrame::RenderedFrame(const FrameRequest& request, std::unique_ptr<LoadedScene> loaded,
                             const PlanGoal& goal, Effect Effects::*without)
    : loaded_(std::move(loaded)), device_(make_device(request.backend)) {
  if (request.backend.backend != Backend::Software) pilot_device_ = make_pilot_device(request.backend);
  renderer_ = std::make_unique<FrameRenderer>(
      loaded_->scene(), request.settings, pass_registry(), *device_,
      FrameOptions{.goal = goal,
                   .camera = &loaded_->camera(),
                   .exposure = loaded_->exposure(),
                   .seconds = request.seconds.value_or(0.0),
                   .without = without,
                   .pilot = pilot_device_.get(),
                   .breath = stop_if_interrupted,
                   .accept = [](const PlannedFrame& frame) { check_memory(frame.plan); }});
}

RenderedFrame::~RenderedFrame() = default;

bool RenderedFrame::moves() const { return loaded_->moves() || renderer_->has_waters(); }

void RenderedFrame::move_to(double seconds) {
  if (loaded_->moves()) {
    loaded_->move_to(seconds);
    renderer_->moved(loaded_->moving_meshes(), &loaded_->camera());
  }
  renderer_->show_waters(seconds);
}

std::vector<PassReport> RenderedFrame::run(const AfterPass& after) {
  return renderer_->run(
      [&](const PlannedPass& pass, const PassResult& result, std::size_t done, std::size_t total) {
        return (!after || after(pass, result, done, total)) && interruption() == ExitCode::Done;
      });
}

}  // namespace caustics::app
