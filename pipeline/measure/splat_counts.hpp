// How many splats may have added light to each texel of a caustic map: what the rounding of its
// single-precision sums is bounded by.
#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/measure/landing_images.hpp"
#include "pipeline/scene/view.hpp"
#include "pipeline/settings/splat_kernel.hpp"

namespace caustics {

// Texel (x, y) at y * map + x. Landings count in the square that their kernel covers, cells in the rectangle
// around their four corners, so that no texel counts too few. `cells` by branch; `frame` is the map's and no
// cube.
std::vector<std::uint32_t> splat_counts(const std::vector<BranchImages>& branches,
                                        const std::vector<CellImages>& cells, const SplatKernel& kernel,
                                        const View& view, int map);

// Where a landing is splatted in a map of a frame, in texels from its lower left corner: in single precision,
// step by step as passes/shared/view_space.glsl does, for where a caustic is hardly wider than its
// coordinates' rounding a texel more or less decides what the map's edge cuts off. Not for cubes.
glm::dvec2 texel_of(const BranchImages& images, int x, int y, const std140::View& view, int map);

}  // namespace caustics
