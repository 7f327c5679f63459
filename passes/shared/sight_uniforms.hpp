// Fills the uniforms of the camera's rays through glass (sight_uniforms.glsl), and makes their choices.
#pragma once
#include <algorithm>

#include "passes/shared/hierarchy_reads.hpp"
#include "pipeline/plan/pass.hpp"
#include "pipeline/scene/cube_view.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

// Steps to each surface, all together fewer than the rounds that llvmpipe grants an invocation's loops;
// surfaces behind the first that bend a ray, as what total reflection sends through more is a different place
// for each pixel; and those that it passes then.
inline constexpr int kMostStepsOfSight = 2048, kMostBends = 6, kMostPassed = 4;

template <class Block>
void set_sight(Block& block, const PassContext& context) {
  const Settings& settings = *context.settings;
  const bool by_two = settings.interfaces == Interfaces::Two || settings.further_share >= 1.0f;
  const int bends = settings.interfaces == Interfaces::One ? 0 : by_two ? 1 : settings.bounces;
  block.view = shader_view(*context.camera);
  block.eye = context.camera->origin;
  block.surfaces = std::min(bends, kMostBends);
  block.forward = context.camera->forward;
  block.most_surfaces = block.surfaces + kMostPassed;
  block.bend = 0.0f;
  block.most_steps = kMostStepsOfSight;
  block.first_receiver = context.first_receiver;
  block.touch = context.touch;
  block.first_uv = context.first_uv;
  block.rough_from = settings.glass_roughness;
  block.eye_media = context.eye_media;
}

inline constexpr Read kReadSeenCasters{.name = "view_caster_position",
                                       .meaning = "the glass and metal in view",
                                       .texture = "caster_position.camera"};
inline constexpr Read kReadSeenNormals{
    .name = "view_caster_normal", .meaning = "its normals and materials", .texture = "caster_normal.camera"};

inline constexpr Choice kSightHasTextures{
    "has_textures", [](const PassContext& c) { return sight_meets_textures(*c.effects) ? 1 : 0; }};
inline constexpr Choice kSightHasSheets{"has_sheets", chosen_by<&Effects::layered>};
inline constexpr Choice kSightHasRough{"has_rough", chosen_by<&Effects::rough_glass>};

}  // namespace caustics
