// All fragments of a pass, sorted by the texel that they fell on; of one texel in the order drawn.
#pragma once
#include <cstdint>
#include <vector>

#include "app/frame.hpp"
#include "raster/texel_history.hpp"

namespace caustics::app {

struct FragmentTable {
  std::vector<std::uint32_t> start;  // by texel and one more: its fragments are start[i] to start[i + 1]
  // By fragment:
  std::vector<std::uint32_t> primitive;
  std::vector<std::uint16_t> draw;
  std::vector<std::uint8_t> outcome;       // FragmentOutcome
  std::vector<float> depth;                // none where the pass has no depth attachment
  std::vector<std::vector<float>> values;  // by colour attachment: what the shader gave, channels together
};

// Of a pass that has just run. `wanted`: the colour attachments whose values are taken.
FragmentTable fragment_table(const RenderedFrame& frame, const PlannedPass& pass, const TargetsBefore& before,
                             const std::vector<bool>& wanted);

}  // namespace caustics::app
