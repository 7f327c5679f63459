#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// light_shading.md says what these passes are for, what is read and written, and what can go wrong.
Pass light_shading_pass();
Pass wide_shading_pass();  // over the wide view
// The same where a medium takes its share of the light on its way.
Pass light_shading_in_medium_pass();
Pass wide_shading_in_medium_pass();

}  // namespace caustics
