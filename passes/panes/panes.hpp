#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// panes.md says what these passes are for, what they read and write, and what can go wrong.
Pass pane_light_pass();
Pass view_panes_pass();

}  // namespace caustics
