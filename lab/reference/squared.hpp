#pragma once

namespace caustics {

constexpr double squared(double x) { return x * x; }

}  // namespace caustics
