// What this program was made of.
#pragma once
#include <string>

namespace caustics::app {

// "0.1.0"
std::string version();
// "caustics 0.1.0 (GCC 12.2.0)"
std::string version_line();
// "GCC 12.2.0"
std::string compiler();

}  // namespace caustics::app
