// A water mesh's vertices put where its waves are.
#pragma once
#include <vector>

#include "pipeline/scene/scene.hpp"

namespace caustics {

// A vertex at rest goes up (+y) by the height that is interpolated bilinearly between the four nearest cells'
// middles; its normal follows the heights' slope, added to the rest's own. Slopes are central differences at
// the cells' middles, interpolated likewise, so that the normals are continuous; at the walls they are 0
// across them. Double precision, exact arithmetic: the same bits everywhere.
class WaterSurface {
 public:
  // `mesh` at rest. `water` must outlive it.
  WaterSurface(const Water& water, const Mesh& mesh);

  // `state` is WaterSimulation::state(); the surface is shown `lead` seconds before it, by its rate: between
  // two steps the heights move evenly. Heights beyond Water::highest are cut.
  void displace(const Image& state, double lead, Mesh& mesh) const;
  // Every vertex at rest, moved up by `height` metres.
  void level(double height, Mesh& mesh) const;

 private:
  // Where a vertex lies on the grid: the cell whose middle is before it, -1 before the first, and how far
  // behind that middle, in cells.
  struct Place {
    int column = 0, row = 0;
    double x = 0.0, z = 0.0;
  };

  const Water& water_;
  std::vector<Vertex> rest_;
  std::vector<Place> places_;
};

}  // namespace caustics
