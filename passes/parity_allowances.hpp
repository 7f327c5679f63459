#pragma once
#include "pipeline/gpu/allowance.hpp"

namespace caustics {

// What the passes of whole frames may differ by on the drivers of docs/parity.md. The last comparison, each
// backend by itself, goes by the pass name "whole frame".
const std::vector<Allowance>& parity_allowances();

}  // namespace caustics
