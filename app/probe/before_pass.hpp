// What a pass's targets hold before it runs, for those who look at the frame after each pass.
#pragma once
#include "app/frame.hpp"
#include "raster/texel_history.hpp"

namespace caustics::app {

// Of a pass of the plan that has not run yet, when the pass before it has.
TargetsBefore targets_before(const RenderedFrame& frame, const PlannedPass& pass);
// The colours alone, with what they are cleared to where they are.
std::vector<Image> colors_before(const RenderedFrame& frame, const PlannedPass& pass);

// The mesh that a draw draws; null where it draws none.
const Mesh* mesh_of(const RenderedFrame& frame, const Draw& draw);

}  // namespace caustics::app
