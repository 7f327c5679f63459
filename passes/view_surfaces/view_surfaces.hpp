#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// view_surfaces.md says what these passes are for, what is read and written, and what can go wrong.
Pass view_surfaces_pass();

}  // namespace caustics
