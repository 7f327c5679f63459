#include "app/shell/version.hpp"

namespace caustics::app {

std::string version() { return CAUSTICS_VERSION; }

std::string compiler() {
#if defined(__clang__)
  return "Clang " + std::to_string(__clang_major__) + "." + std::to_string(__clang_minor__) + "." +
         std::to_string(__clang_patchlevel__);
#elif defined(__GNUC__)
  return "GCC " + std::to_string(__GNUC__) + "." + std::to_string(__GNUC_MINOR__) + "." +
         std::to_string(__GNUC_PATCHLEVEL__);
#else
  return "an unknown compiler";
#endif
}

std::string version_line() { return "caustics " + version() + " (" + compiler() + ")"; }

}  // namespace caustics::app
