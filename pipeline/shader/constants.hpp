// The names that shader texts and C++ share (constants.glsl): kinds of views, statuses, estimators.
#pragma once

namespace caustics {

#define CONSTANT(name, value) inline constexpr int name = value;
#include "pipeline/shader/constants.glsl"
#undef CONSTANT

}  // namespace caustics
