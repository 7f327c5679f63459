#include "app/frame.hpp"

#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "app/shell/interrupt.hpp"
#include "app/shell/terminal.hpp"
#include "passes/registry.hpp"
#include "raster/software_device.hpp"

namespace caustics::app {

namespace {

std::uint64_t texture_bytes(const PlannedTexture& texture) {
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
  for (const char* file :
       {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
    std::uint64_t limit = 0;
    if (std::ifstream(file) >> limit) bytes = std::min(bytes, limit);
  }
  return bytes;
}

}  // namespace

std::uint64_t memory_needed(const FramePlan& plan) {
  std::uint64_t sum = 0, largest = 0;
  for (const PlannedTexture& texture : plan.textures) {
    if (texture.external) continue;
    sum += texture_bytes(texture);
    largest = std::max(largest, texture_bytes(texture));
  }
  return sum + largest;
}

void check_memory(std::uint64_t needed, const std::string& advice) {
  const std::uint64_t allowed = machine_memory() / 4 * 3;
  if (needed <= allowed) return;
  throw Error(ExitCode::WrongUsage,
              "these sizes need " + bytes_text(static_cast<double>(needed)) +
                  " of memory, more than the " + bytes_text(static_cast<double>(allowed)) +
                  " that this machine can spare; lower " + advice);
}

void check_memory(const FramePlan& plan, const Effects& effects) {
  check_memory(memory_needed(plan), std::string("-r, --grid, --map, -D shadow") +
                                        (effects.active("area lights") ? " or -D light.samples" : ""));
}

std::vector<LightViews> fit_views(JudgedScene& judged, const FrameRequest& request) {
  const std::unique_ptr<Device> device = make_software_device({.threads = request.backend.threads});
  if (judged.effects().active("water waves"))
    return fit_moving_views(judged.scene(), *device, judged.effects(), request.settings, pass_registry(),
                             stop_if_interrupted);
  return fit_light_views(SceneOnDevice(judged.scene(), judged.effects(), *device), judged.effects(),
                          request.settings, pass_registry());
}

RenderedFrame::RenderedFrame(const FrameRequest& request, std::unique_ptr<JudgedScene> judged,
                             const PlanGoal& goal)
    : settings_(request.settings), judged_(std::move(judged)), goal_(goal) {
  plan_frame();
  check_memory(plan_, effects());
  device_ = make_device(request.backend);
  on_device_ = std::make_unique<SceneOnDevice>(scene(), effects(), *device_);
  stop_if_interrupted();
  make_fitter(request.backend);
  inputs_.settings = &settings_;
  inputs_.effects = &effects();
  inputs_.views = &views_;
  inputs_.exposure = judged_->exposure();
  fit();
  plan_frame();
  check_memory(plan_, effects());
  if (effects().active("water waves"))
    water_ = std::make_unique<MovingWater>(judged_->scene(), *device_, pass_registry());
  targets_ = std::make_unique<FrameTargets>(plan_, *device_);
  show_waters(request.seconds.value_or(0.0));
  if (judged_->moves()) return;
  fitter_.reset();  // what it needed is not needed again
  fitting_scene_.reset();
  fitting_device_.reset();
}

void RenderedFrame::plan_frame() {
  plan_ = make_plan(scene(), effects(), settings_, pass_registry(), goal_);
}

// Always on the software device, so that every backend draws the same frames.
void RenderedFrame::make_fitter(const BackendRequest& backend) {
  if (backend.backend != Backend::Software) {
    fitting_device_ = make_software_device({.threads = backend.threads});
    fitting_scene_ = std::make_unique<SceneOnDevice>(scene(), effects(), *fitting_device_);
  }
  fitter_ = std::make_unique<LightFitter>(fitting_scene_ ? *fitting_scene_ : *on_device_, settings_,
                                          pass_registry());
}

// The frames hold whatever the waves do, so that maps and shadows do not crawl.
void RenderedFrame::fit() {
  if (effects().active("water waves")) {
    views_ = fit_moving_views(judged_->scene(), fitting_device_ ? *fitting_device_ : *device_, effects(),
                                settings_, pass_registry(), stop_if_interrupted);
  } else {
    views_ = fitter_->fit(effects());
  }
  judged_->judge_cascades(views_);
  stop_if_interrupted();
  inputs_.camera =
      view_of(judged_->camera(), settings_.width, settings_.height, bounds_of(scene()));
}

void RenderedFrame::move_to(double seconds) {
  if (judged_->moves()) move_animation(seconds);
  show_waters(seconds);
}

void RenderedFrame::show_waters(double seconds) {
  if (!water_ || shown_ == seconds) return;
  const bool with_state = std::any_of(plan_.passes.begin(), plan_.passes.end(),
                                      [](const PlannedPass& pass) { return pass.water >= 0; });
  water_report_ = water_->show(seconds, with_state, stop_if_interrupted);
  on_device_->renew_waters(with_state);
  shown_ = seconds;
}

void RenderedFrame::move_animation(double seconds) {
  judged_->move_to(seconds);
  on_device_->update(judged_->moving_meshes());
  if (fitting_scene_) fitting_scene_->update(judged_->moving_meshes());
  fit();
  shown_.reset();  // fitting leaves the waters at rest
  const std::vector<PlannedTexture> before = std::move(plan_.textures);
  plan_frame();
  // Other textures only where the moment calls for other effects.
  if (plan_.textures == before) return;
  targets_.reset();
  check_memory(plan_, effects());
  targets_ = std::make_unique<FrameTargets>(plan_, *device_);
}

std::vector<PassReport> RenderedFrame::run(const AfterPass& after) {
  const auto watched = [&](const PlannedPass& pass, const PassResult& result, std::size_t done,
                           std::size_t total) {
    return (!after || after(pass, result, done, total)) && interruption() == ExitCode::Done;
  };
  std::vector<PassReport> reports = water_report_;
  for (PassReport& report : run_plan(plan_, pass_registry(), *on_device_, *targets_, inputs_, watched))
    reports.push_back(std::move(report));
  return reports;
}

Image RenderedFrame::read(int texture) const {
  const PlannedTexture& planned = plan_.textures[static_cast<std::size_t>(texture)];
  return device_->read_back(planned.external ? on_device_->external(planned.name)
                                             : (*targets_)[texture]);
}

Image RenderedFrame::read(const std::string& texture) const {
  const int index = plan_.find(texture);
  if (index < 0) {
    throw Error(ExitCode::InternalError, "the frame has no texture '" + texture + "'");
  }
  return read(index);
}

PassRun RenderedFrame::prepare(const PlannedPass& pass) const {
  return prepare_pass(plan_, pass, pass_registry(), *on_device_, *targets_, inputs_);
}

}  // namespace caustics::app
