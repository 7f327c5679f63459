#include "app/frame.hpp"

#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "app/interrupt.hpp"
#include "app/terminal.hpp"
#include "passes/registry.hpp"
#include "pipeline/plan/nearest.hpp"
#include "pipeline/scene/defaults.hpp"
#include "pipeline/scene/emitter.hpp"
#include "pipeline/scene/light_samples.hpp"
#include "pipeline/scene/load_environment.hpp"
#include "pipeline/scene/load_gltf.hpp"
#include "raster/software_device.hpp"

namespace caustics::app {

namespace {

// A camera by its name, or else by its number.
const Camera& choose_camera(const Scene& scene, const std::string& wanted) {
  if (wanted.empty()) return scene.cameras.front();
  std::vector<std::string> names;
  for (const Camera& camera : scene.cameras) {
    if (camera.name == wanted) return camera;
    names.push_back(camera.name);
  }
  if (wanted.find_first_not_of("0123456789") == std::string::npos && wanted.size() < 8) {
    const std::size_t number = static_cast<std::size_t>(std::stoi(wanted));
    if (number < scene.cameras.size()) return scene.cameras[number];
  }
  throw Error(ExitCode::WrongUsage, "there is no camera '" + one_line(wanted).substr(0, 60) +
                                        "'; the scene has " + std::to_string(names.size()) +
                                        ", the nearest name is '" +
                                        one_line(nearest_name(wanted, names)) + "'");
}

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

// More would plan for minutes before the memory that they need is refused.
constexpr std::size_t kMostSamples = 4096;

void sample_area_lights(Scene& scene, int count) {
  const auto sized = std::count_if(scene.lights.begin(), scene.lights.end(), [](const Light& light) {
    return light.shape != LightShape::None;
  });
  const std::size_t samples = static_cast<std::size_t>(sized) * static_cast<std::size_t>(count);
  if (samples > kMostSamples) {
    throw Error(ExitCode::WrongUsage, std::to_string(sized) + " lights with a size would need " +
                                          grouped(samples) + " samples, more than " +
                                          grouped(kMostSamples) + "; lower -D light.samples");
  }
  sample_lights(scene, count);
}

}  // namespace

std::unique_ptr<JudgedScene> load_scene(const FrameRequest& request) {
  auto judged = std::make_unique<JudgedScene>();
  judged->scene = load_gltf(request.scene);
  if (request.environment) judged->scene.environment = load_environment(*request.environment);
  if (request.settings.emissive_lights) add_emissive_lights(judged->scene);
  sample_area_lights(judged->scene, request.settings.light_samples);
  complete_scene(judged->scene);
  stop_if_interrupted();
  judged->effects = effects_of(judged->scene, request.settings);
  judged->camera = &choose_camera(judged->scene, request.settings.camera);
  return judged;
}

std::uint64_t memory_needed(const FramePlan& plan) {
  std::uint64_t sum = 0, largest = 0;
  for (const PlannedTexture& texture : plan.textures) {
    if (texture.external) continue;
    sum += texture_bytes(texture);
    largest = std::max(largest, texture_bytes(texture));
  }
  return sum + largest;
}

void check_memory(const FramePlan& plan, const Effects& effects) {
  const std::uint64_t needed = memory_needed(plan), allowed = machine_memory() / 4 * 3;
  if (needed <= allowed) return;
  throw Error(ExitCode::WrongUsage,
              "these sizes need " + bytes_text(static_cast<double>(needed)) +
                  " of memory, more than the " + bytes_text(static_cast<double>(allowed)) +
                  " that this machine can spare; lower -r, --grid, --map, -D shadow" +
                  (effects.active("area lights") ? " or -D light.samples" : ""));
}

RenderedFrame::RenderedFrame(const FrameRequest& request, std::unique_ptr<JudgedScene> judged,
                             const PlanGoal& goal)
    : settings_(request.settings), judged_(std::move(judged)) {
  plan_ = make_plan(scene(), effects(), settings_, pass_registry(), goal);
  check_memory(plan_, effects());
  device_ = make_device(request.backend);
  on_device_ = std::make_unique<SceneOnDevice>(scene(), effects(), *device_);
  stop_if_interrupted();
  frames_ = fit_frames(request.backend);
  stop_if_interrupted();
  if (effects().active("water waves"))
    water_ = std::make_unique<MovingWater>(judged_->scene, *device_, pass_registry());
  targets_ = std::make_unique<FrameTargets>(plan_, *device_);
  inputs_.settings = &settings_;
  inputs_.effects = &effects();
  inputs_.frames = &frames_;
  inputs_.view = frame_of(*judged_->camera, settings_.width, settings_.height, bounds_of(scene()));
  inputs_.exposure = exposure_of(scene(), settings_);
  show(0.0);
}

void RenderedFrame::show(double seconds) {
  if (!water_ || shown_ == seconds) return;
  const bool with_state = std::any_of(plan_.passes.begin(), plan_.passes.end(),
                                      [](const PlannedPass& pass) { return pass.water >= 0; });
  water_report_ = water_->show(seconds, with_state, stop_if_interrupted);
  on_device_->renew_waters(with_state);
  shown_ = seconds;
}

// Always on the software device, so that every backend draws the same frames.
std::vector<LightFrames> RenderedFrame::fit_frames(const BackendRequest& backend) {
  if (effects().active("water waves")) {
    const std::unique_ptr<Device> device = make_software_device({.threads = backend.threads});
    return fit_moving_frames(judged_->scene, *device, effects(), settings_, pass_registry(),
                             stop_if_interrupted);
  }
  if (backend.backend == Backend::Software) {
    return fit_light_frames(*on_device_, effects(), settings_, pass_registry());
  }
  const std::unique_ptr<Device> device = make_software_device({.threads = backend.threads});
  return fit_light_frames(SceneOnDevice(scene(), effects(), *device), effects(), settings_,
                          pass_registry());
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
