// The lines of a shader text that its conditions leave in, for those who read declarations from it.
#pragma once
#include <string_view>
#include <vector>

namespace caustics {

// Without blanks at both ends.
std::string_view trimmed(std::string_view text);

// Trimmed, comments included. Of an `#ifdef NAME` only where the text has defined NAME; the stages are not
// told apart.
std::vector<std::string_view> lines_that_count(std::string_view text);

}  // namespace caustics
