#include "pipeline/renderer/water_simulation.hpp"

#include "pipeline/gpu/device.hpp"
#include "pipeline/gpu/interrupt.hpp"

namespace caustics {

const Pass& water_pass(const Registry& registry) {
  for (const Pass& pass : registry)
    if (pass.drawn_for.front().each == Each::Water) return pass;
  throw Error(ExitCode::InternalError, "the registry has no pass that moves water");
}

WaterSimulation::WaterSimulation(const Water& water, Device& device, const Pass& pass)
    : water_(water), device_(device), pass_(pass), definition_(definition_of(pass)) {
  rest();
}

void WaterSimulation::rest() {
  for (OwnedTexture& texture : textures_)
    texture = {device_, device_.upload(Image(Format::RG32F, water_.columns, water_.rows))};
  steps_ = 0;
}

void WaterSimulation::set_state(const Image& state) {
  textures_[current_] = {device_, device_.upload(state)};
}

void WaterSimulation::make_step() {
  const PassContext context{.water = &water_, .water_step = steps_};
  const PassRun run{
      .definition = &definition_,
      .colors = {textures_[1 - current_].id()},
      .draws = {
          {.vertex_count = 3, .uniforms = pass_.uniforms(context), .textures = {textures_[current_].id()}}}};
  const PassResult result = device_.run(run);
  current_ = 1 - current_;
  ++steps_;
  work_.vertices += result.vertices;
  work_.primitives += result.primitives;
  work_.fragments += result.fragments;
  work_.milliseconds += result.milliseconds;
  work_.processor_milliseconds += result.processor_milliseconds;
}

void WaterSimulation::advance_to(double seconds) {
  const std::int64_t wanted = water_.steps_until(seconds);
  if (wanted < steps_) rest();
  while (steps_ < wanted) {
    stop_if_interrupted();
    make_step();
  }
}

}  // namespace caustics
