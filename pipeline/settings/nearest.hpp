// "Did you mean": the known name that is closest to what was typed.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace caustics {

// The fewest insertions, deletions, substitutions and swaps of neighbours away; the earlier one of equals.
// Empty when there are no names.
std::string nearest_name(std::string_view typed, const std::vector<std::string>& names);

// The end of a line about an unknown name: ", did you mean 'grid'?" where a name is near, at most a third of
// the letters typed away, or one. Otherwise "; " and where to look; without that, the names themselves.
std::string suggestion(std::string_view typed, const std::vector<std::string>& names,
                       const std::string& where_to_look = "");

}  // namespace caustics
