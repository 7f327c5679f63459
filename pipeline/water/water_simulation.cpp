#include "pipeline/water/water_simulation.hpp"

#include "pipeline/gpu/error.hpp"

namespace caustics {

namespace {
constexpr std::int64_t kStepsABreath = 256;
}

const Pass& water_pass(const Registry& registry) {
  for (const Pass& pass : registry)
    if (pass.each == Each::Water) return pass;
  throw Error(ExitCode::InternalError, "the registry has no pass that moves water");
}

WaterSimulation::WaterSimulation(const Water& water, Device& device, const Pass& pass)
    : water_(water), device_(device), pass_(pass) {
  rest();
}

WaterSimulation::~WaterSimulation() {
  for (const TextureId texture : textures_) device_.destroy(texture);
}

void WaterSimulation::rest() {
  for (TextureId& texture : textures_) {
    if (texture != TextureId::None) device_.destroy(texture);
    texture = device_.upload(Image(Format::RG32F, water_.columns, water_.rows));
  }
  steps_ = 0;
}

void WaterSimulation::set_state(const Image& state) {
  device_.destroy(textures_[current_]);
  textures_[current_] = device_.upload(state);
}

void WaterSimulation::make_step() {
  const PassContext context{.water = &water_, .water_step = steps_};
  const PassRun run{.definition = &pass_.definition,
                    .colors = {textures_[1 - current_]},
                    .keep = {false},
                    .draws = {{.vertex_count = 3,
                               .uniforms = pass_.uniforms(context),
                               .textures = {textures_[current_]}}}};
  const PassResult result = device_.run(run);
  current_ = 1 - current_;
  ++steps_;
  work_.vertices += result.vertices;
  work_.primitives += result.primitives;
  work_.fragments += result.fragments;
  work_.milliseconds += result.milliseconds;
}

void WaterSimulation::advance_to(double seconds, const Breath& breath) {
  const std::int64_t wanted = water_.steps_until(seconds);
  if (wanted < steps_) rest();
  while (steps_ < wanted) {
    if (breath && steps_ % kStepsABreath == 0) breath();
    make_step();
  }
}

}  // namespace caustics
