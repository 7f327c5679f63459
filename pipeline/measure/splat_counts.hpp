// How many splats may have added light to each texel of a caustic map: what the rounding of its
// single-precision sums is bounded by.
#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/measure/landing_images.hpp"
#include "pipeline/scene/view.hpp"
#include "pipeline/settings/splat_kernel.hpp"

namespace caustics {

// Landings count in the square that their kernel covers, cells in the rectangle around their four corners, so
// that no texel counts too few. The view is the map's and no cube; it must outlive this.
class SplatCounts {
 public:
  SplatCounts(const SplatKernel& kernel, const View& view, int map);
  // `cells` without values where landings are splatted one by one.
  void add(const BranchImages& images, const CellImages& cells);
  // Texel (x, y) at y * map + x.
  std::vector<std::uint32_t> by_texel() const;

 private:
  void add_landings(const BranchImages& images);
  void add_cells(const BranchImages& images, const CellImages& cells);
  void add_rectangle(const glm::dvec2& lower, const glm::dvec2& upper);
  std::size_t stride() const { return static_cast<std::size_t>(map_) + 1; }
  std::size_t column(double texel) const;

  SplatKernel kernel_;
  const View& view_;
  int map_;
  // Each rectangle is marked at its corners, and one running sum along both axes counts them all.
  std::vector<std::int32_t> marks_;
};

// Where a landing is splatted in a map of a frame, in texels from its lower left corner: in single precision,
// step by step as passes/shared/view_space.glsl does, for where a caustic is hardly wider than its
// coordinates' rounding a texel more or less decides what the map's edge cuts off. Not for cubes.
glm::dvec2 texel_of(const BranchImages& images, int x, int y, const std140::View& view, int map);

}  // namespace caustics
