#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// far_receivers.md says what these passes are for, what they read and write, and what can go wrong.
Pass far_receiver_map_pass();
Pass far_landing_pass();
Pass far_cells_pass();
Pass far_caustic_cells_pass();
Pass far_caustic_cells_grey_pass();
Pass far_caustic_map_pass();
Pass far_caustic_map_grey_pass();

}  // namespace caustics
