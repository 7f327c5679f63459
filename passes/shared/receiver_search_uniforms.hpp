// Fills the uniforms of the search for a landing (receiver_search_uniforms.glsl), and makes its choices.
#pragma once
#include "pipeline/plan/pass.hpp"
#include "pipeline/scene/cube_view.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

// The box around all receivers, a little larger for the rounding of rays; a point where there are none.
Bounds receivers_box(const PassContext& context);

template <class Block>
void set_receiver_search(Block& block, const PassContext& context, float landing_tolerance) {
  const Settings& settings = *context.settings;
  const bool impostors =
      settings.estimator == Estimator::Impostor && context.effects->distance_impostors.active;
  const Bounds receivers = receivers_box(context);
  block.receiver = shader_view(context.views->receiver);
  if (impostors) block.impostor = shader_view(with_atlas(context.effects->impostors, settings.map));
  block.receivers_lower = glm::vec3(receivers.lower);
  block.receivers_upper = glm::vec3(receivers.upper);
  block.landing_tolerance = landing_tolerance;
  block.search_start = settings.search_start.value_or(settings.estimator == Estimator::Newton ? 0.1f : 0.0f);
  block.impostor_centre = glm::vec3(context.effects->impostors.origin);
  block.newton_epsilon = settings.newton_epsilon.value_or(0.0f);
  block.iterations = settings.iterations;
}

inline constexpr Choice kNewtonGuard{"newton_guard",
                                     [](const PassContext& c) { return c.settings->newton_guard ? 1 : 0; }};
inline constexpr Choice kDrawsUnconverged{
    "draws_unconverged", [](const PassContext& c) { return c.settings->draw_unconverged ? 1 : 0; }};
inline constexpr Choice kEstimator{
    "estimator", [](const PassContext& c) { return static_cast<int>(c.settings->estimator); }};

}  // namespace caustics
