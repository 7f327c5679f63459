// Whether a frame's effects call for a pass.
#pragma once
#include <optional>
#include <string>

#include "pipeline/plan/pass.hpp"

namespace caustics {

// Why the effects do not call for an instance of a pass, as "cells: landings are splatted one by one", or
// nothing where they do.
std::optional<std::string> not_called_for(const Pass& pass, const DrawnFor& drawn_for,
                                          const Effects& effects);

}  // namespace caustics
