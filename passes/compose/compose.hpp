#pragma once
#include "pipeline/plan/pass.hpp"

namespace caustics {

// compose.md says what these passes are for, what is read and written, and what can go wrong.
Pass compose_pass();         // with glass in the picture: `scene_color`
Pass compose_beauty_pass();  // without: `beauty` at once
Pass wide_compose_pass();    // over the wide view: `wide_color`

}  // namespace caustics
