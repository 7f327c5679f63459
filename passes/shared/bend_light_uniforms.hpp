// Fills the uniforms of light at a surface (bend_light_uniforms.glsl), and makes its choices.
#pragma once
#include "pipeline/plan/pass.hpp"
#include "pipeline/settings/settings.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics {

template <class Block>
void set_bend_light(Block& block, const PassContext& context) {
  block.channel_share = context.branch->color;
  block.bend = static_cast<float>(context.branch->bend);
  block.least_share = context.settings->least_share;
}

inline constexpr Choice kBothWays{
    "both_ways", [](const PassContext& c) { return c.surface <= c.settings->splits ? 1 : 0; }};
inline constexpr Choice kFollowsMirrored{
    "follows_mirrored", [](const PassContext& c) { return c.branch->is_mirrored_at(c.surface) ? 1 : 0; }};

}  // namespace caustics
