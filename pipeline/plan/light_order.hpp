// The order in which a plan's passes run.
#pragma once
#include "pipeline/plan/frame_plan.hpp"

namespace caustics {

// Each light's passes one after the other, light by light, so that a light's textures can take the memory of
// the light before. A pass that needs those of several lights follows them all. What one pass finds written
// by others stays the same, but for where light joins light in one texture: sums run light by light. Marks
// the last pass of each light.
//
// Passes of samples of pixels: sample by sample, where lights' textures are kept until the last sample has
// read them; or light by light too, where each sample's textures are kept until the last light has added to
// them.
enum class SampleOrder : std::uint8_t { SampleBySample, LightByLight };
void order_by_light(FramePlan& plan, SampleOrder order = SampleOrder::SampleBySample);

}  // namespace caustics
