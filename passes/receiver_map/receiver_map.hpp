#pragma once
#include "passes/shared/material_uniforms.hpp"
#include "pipeline/plan/pass.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

// The uniform block of passes that draw opaque surfaces into a view and cut out alpha masks.
struct alignas(16) ReceiverMap {
#include "passes/receiver_map/receiver_map_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

// `views`: keep the space between light and casters free; null: keep all.
std140::ReceiverMap receiver_map_uniforms(const View& view, const Material& material,
                                          const LightViews* views = nullptr);

// receiver_map.md says what this pass is for, what it reads and writes, and what can go wrong.
Pass receiver_map_pass();

}  // namespace caustics
