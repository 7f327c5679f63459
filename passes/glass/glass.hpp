#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// glass.md says what these passes are for, what is read and written, and what can go wrong.
Pass view_caster_map_pass();  // the casters as the camera sees them
Pass view_exit_map_pass();    // their back faces
Pass glass_pass();

}  // namespace caustics
