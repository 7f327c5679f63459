#include "app/frame.hpp"

#include <algorithm>

#include "app/backend.hpp"
#include "app/frame_options.hpp"
#include "app/loaded_scene.hpp"
#include "passes/registry.hpp"
#include "pipeline/effects/dim_lights.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/text.hpp"
#include "pipeline/scene/gltf/load_gltf.hpp"
#include "raster/software_device.hpp"

namespace caustics::app {

std::unique_ptr<Device> make_pilot_device(const BackendRequest& backend) {
  return make_software_device({.threads = backend.threads});
}

namespace {

// Measured with Mesa's llvmpipe, whose code generator is most of it: a context, and a frame's shaders.
constexpr std::uint64_t kOpenGlContext = 60'000'000, kOpenGlShaders = 85'000'000;

// The driver takes these bytes for a frame, beside its textures, and has not taken them yet.
std::uint64_t driver_bytes(const FrameRequest& request, const Scene& scene, bool device_is_made) {
  if (request.backend.backend != Backend::OpenGl) return 0;
  if (device_is_made) return kOpenGlShaders;
  std::uint64_t images = 0;
  for (const Image& image : scene.images) images += image.values.size() * sizeof(float);
  return kOpenGlContext + images + kOpenGlShaders;
}

}  // namespace

MemoryJudgement judge_memory(const FrameRequest& request, const Scene& scene, const PlannedFrame& frame,
                             bool device_is_made, const OutputBytes& outputs) {
  MemoryJudgement judged;
  judged.needed = memory_needed({.plan = frame.plan,
                                 .registry = pass_registry(),
                                 .scene = scene,
                                 .effects = frame.effects,
                                 .settings = frame.settings,
                                 .device = {.draw = draw_bytes,
                                            .kept = kMostKeptOfDraws,
                                            .driver = driver_bytes(request, scene, device_is_made),
                                            .copies_looks = request.backend.backend == Backend::OpenGl},
                                 .taken = frame.taken,
                                 .outputs = outputs ? outputs(frame) : 0});
  judged.budget = request.budget();
  judged.refusal = memory_refusal(judged.needed, judged.budget, "-r, --grid, --map or -D shadow");
  return judged;
}

// A step of fewer cells takes hardly less time.
constexpr double kLeastUpdates = 65536.0;

void check_water_work(const Scene& scene, double seconds) {
  const double most = LoadOptions{}.max_water_updates;
  double updates = 0.0;
  for (const Water& water : scene.waters)
    updates += std::max(static_cast<double>(water.columns) * water.rows, kLeastUpdates) *
               (water.since_rest(seconds) / water.step);
  if (updates <= most) return;
  throw Error(ExitCode::WrongUsage, "until " + significant(seconds, 6) + " s the water's cells make " +
                                        significant(updates, 2) + " steps, more than " +
                                        significant(most, 2) + "; choose an earlier --time or --frames");
}

RenderedFrame::RenderedFrame(const FrameRequest& request, std::shared_ptr<LoadedScene> loaded,
                             const PlanGoal& goal, Effect Effects::*without, OutputBytes outputs)
    : loaded_(std::move(loaded)), device_(make_device(request.backend)) {
  check_water_work(loaded_->scene(), request.seconds.value_or(0.0));
  if (request.backend.backend != Backend::Software) pilot_device_ = make_pilot_device(request.backend);
  renderer_ = std::make_unique<FrameRenderer>(
      loaded_->scene(), request.settings, pass_registry(), *device_,
      FrameOptions{.goal = goal,
                   .camera = &loaded_->camera(),
                   .exposure = loaded_->exposure(),
                   .seconds = request.seconds.value_or(0.0),
                   .without = without,
                   .pilot = pilot_device_.get(),
                   .accept = [this, request, outputs = std::move(outputs)](const PlannedFrame& frame) {
                     memory_ = judge_memory(request, loaded_->scene(), frame, true, outputs);
                     if (!memory_.refusal.empty()) throw Error(ExitCode::WrongUsage, memory_.refusal);
                   }});
}

RenderedFrame::~RenderedFrame() = default;

bool RenderedFrame::moves() const { return loaded_->moves() || renderer_->has_waters(); }

int RenderedFrame::grid_of(int light) const { return LightSettings(settings(), effects())[light].grid; }

void RenderedFrame::move_to(double seconds) {
  check_water_work(scene(), seconds);
  if (loaded_->moves()) {
    loaded_->move_to(seconds);
    renderer_->moved(loaded_->moving_meshes(), &loaded_->camera());
  }
  renderer_->show_waters(seconds);
}

std::vector<PassReport> RenderedFrame::run(const AfterPass& after) { return renderer_->run(after); }

}  // namespace caustics::app
