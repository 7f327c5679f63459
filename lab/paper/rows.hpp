// The rows by subject; row.hpp puts them in order.
#pragma once
#include "lab/paper/row.hpp"

namespace caustics::paper {

// What the paper's figures show.
Row formation_row();
Row figure_row();
Row sphere_row();
Row water_row();
Row grids_row();
Row ring_row();
Row dispersion_row();
Row diagrams_row();

// What finds where a ray lands.
Row estimators_row();
Row receivers_row();
Row reflection_row();
Row visibility_row();
Row secant_row();
Row tolerance_row();

// The maps and what is laid into them.
Row maps_row();
Row gaps_row();
Row gaussian_row();
Row room_row();
Row tessellation_row();

// What light does, and what a frame is put together from.
Row interfaces_row();
Row mirror_row();
Row area_row();
Row weights_row();
Row absorption_row();
Row haze_row();
Row lights_row();
Row composition_row();
Row shadow_row();
Row identity_row();

// What a frame costs, and what it is worth.
Row dynamic_row();
Row times_row();
Row offline_row();

}  // namespace caustics::paper
