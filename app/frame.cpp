#include "app/frame.hpp"

#include "app/backend.hpp"
#include "app/frame_memory.hpp"
#include "app/frame_options.hpp"
#include "app/loaded_scene.hpp"
#include "passes/registry.hpp"
#include "raster/software_device.hpp"

namespace caustics::app {

std::unique_ptr<Device> make_pilot_device(const BackendRequest& backend) {
  return make_software_device({.threads = backend.threads});
}

RenderedFrame::RenderedFrame(const FrameRequest& request, std::shared_ptr<LoadedScene> loaded,
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
                   .accept = [this](const PlannedFrame& frame) {
                     check_memory(memory_needed(frame.plan, loaded_->scene(), frame.settings),
                                  "-r, --grid, --map or -D shadow");
                   }});
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

std::vector<PassReport> RenderedFrame::run(const AfterPass& after) { return renderer_->run(after); }

}  // namespace caustics::app
