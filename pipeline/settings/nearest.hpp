// "Did you mean": the known name that is closest to what was typed.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace caustics {

// The fewest insertions, deletions and substitutions away; the earlier one of equals. Empty when
// there are no names.
std::string nearest_name(std::string_view typed, const std::vector<std::string>& names);

}  // namespace caustics
