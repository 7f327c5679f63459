#include "app/caustic_sight.hpp"

#include <algorithm>

#include "pipeline/gpu/device.hpp"
#include "pipeline/gpu/stopwatch.hpp"
#include "pipeline/scene/environment.hpp"

namespace caustics::app {

namespace {

// Lights add to it one after the other.
bool is_last_to_write(const FramePlan& plan, const PlannedPass& pass, int texture) {
  const auto last = std::find_if(plan.passes.rbegin(), plan.passes.rend(), [&](const PlannedPass& each) {
    return std::find(each.writes.begin(), each.writes.end(), texture) != each.writes.end();
  });
  return last != plan.passes.rend() && &*last == &pass;
}

}  // namespace

void CausticSight::look(const RenderedFrame& frame, const PlannedPass& pass) {
  const std::string sample = frame.has("caustic.sample 1") ? ".sample 1" : "";
  if (!is_last_to_write(frame.plan(), pass, frame.plan().find("caustic" + sample))) return;
  frame.device().finish();
  const Stopwatch watch;
  const auto image = [&](const std::string& name) {
    return frame.has(name + sample) ? frame.look_at(name + sample) : ImageView{};
  };
  seen_ = see_caustic({.position = image("view_position"),
                       .normal = image("view_normal"),
                       .caustic = image("caustic"),
                       .direct = image("direct"),
                       .caster = image("caster_position.camera")},
                      frame.inputs().camera, upward_irradiance(frame.scene().environment));
  milliseconds_ += watch.milliseconds();
}

}  // namespace caustics::app
