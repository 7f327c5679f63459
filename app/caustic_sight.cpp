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

// Passes of one camera's sample may wait for their first user.
bool is_written(const FramePlan& plan, const PlannedPass& until, int texture) {
  for (const PlannedPass& each : plan.passes) {
    if (std::find(each.writes.begin(), each.writes.end(), texture) != each.writes.end()) return true;
    if (&each == &until) break;
  }
  return false;
}

}  // namespace

void CausticSight::look(const RenderedFrame& frame, const PlannedPass& pass) {
  const std::string sample = frame.has("caustic.sample 1") ? ".sample 1" : "";
  if (!is_last_to_write(frame.plan(), pass, frame.plan().find("caustic" + sample))) return;
  frame.device().finish();
  const Stopwatch watch;
  // What no sample needs is drawn for the middle of the pixels alone.
  const auto image = [&](const std::string& name) {
    const std::string full = frame.has(name + sample) ? name + sample : name;
    const bool is_there = frame.has(full) && is_written(frame.plan(), pass, frame.plan().find(full));
    return is_there ? frame.look_at(full) : ImageView{};
  };
  seen_ = see_caustic({.position = image("view_position"),
                       .normal = image("view_normal"),
                       .caustic = image("caustic"),
                       .direct = image("direct"),
                       .caster = image(std::string(casters_beyond_panes(frame.effects())))},
                      frame.inputs().camera, upward_irradiance(frame.scene().environment));
  milliseconds_ += watch.milliseconds();
}

}  // namespace caustics::app
