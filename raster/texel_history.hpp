// What happened to single texels in a pass: every fragment that fell on them, in the order drawn, with what
// the shader gave, the values before and after, and whether it passed. The software device draws the pass
// again for these texels alone, by the same kernels.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "pipeline/gpu/device.hpp"

namespace caustics {

enum class FragmentOutcome : std::uint8_t {
  Passed,     // it was merged into the targets
  Discarded,  // by the shader
  Behind      // the depth test failed
};
std::string_view name_of(FragmentOutcome outcome);  // "passed", "discarded", "behind"

using TexelValue = std::array<float, 4>;  // channels that the format lacks are 0, 0, 0, 1

struct FragmentOnTexel {
  int x = 0, y = 0;             // texel, from the left and the bottom
  std::size_t draw = 0;         // of the pass run
  std::uint32_t primitive = 0;  // of the draw: triangle, point or rectangle
  FragmentOutcome outcome = FragmentOutcome::Passed;
  float depth = 0.0f;                                  // window depth, 0 without a depth attachment
  float depth_before = 0.0f;                           // of the attachment
  std::vector<TexelValue> given{}, before{}, after{};  // by colour attachment; given: rounded to its format
};

// What a pass's targets held before it ran: empty where they are cleared (PassRun::keep is false).
struct TargetsBefore {
  std::vector<Image> colors{};
  Image depth{};
};

struct TexelRectangle {
  int x = 0, y = 0, width = 1, height = 1;
};

// Of one texel fragments come in the order drawn; texels come tile by tile within each draw. Of a pass that
// lets the device leave out zeros (PassDefinition::zero_outside_quad) no fragment comes that gives zeros
// alone: which of them are shaded depends on the rectangle. Textures that the pass reads must be as they were
// when it ran. Throws Error (InternalError) for a device that is not the software device.
using FragmentVisitor = std::function<void(const FragmentOnTexel&)>;
void replay_fragments(const Device& software, const PassRun& run, const TargetsBefore& before,
                      const TexelRectangle& where, const FragmentVisitor& visit);

// Of each texel what the pass begins with, before the first fragment.
TexelValue value_before(const ColorWrite& write, const Image* kept, int x, int y);

}  // namespace caustics
