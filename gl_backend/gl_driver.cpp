#include "gl_backend/gl_driver.hpp"

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace caustics {

namespace {

// Interpolation and the viewport transform are fused in llvmpipe where the processor can, and the
// software device does as such a machine does.
bool fuses() {
#if defined(__x86_64__) || defined(__i386__)
  return __builtin_cpu_supports("fma") && std::getenv("GALLIUM_OVERRIDE_CPU_CAPS") == nullptr;
#else
  return false;
#endif
}

// "22.3.6" of "4.5 (Core Profile) Mesa 22.3.6".
std::string mesa_version(const std::string& version) {
  const std::size_t mesa = version.find("Mesa ");
  if (mesa == std::string::npos) return version;
  const std::size_t begin = mesa + 5;
  return version.substr(begin, version.find(' ', begin) - begin);
}

// Drivers whose figures are in docs/parity.md.
const std::vector<std::string>& measured_drivers() {
  static const std::vector<std::string> drivers = {"llvmpipe 22.3.6, fused"};
  return drivers;
}

}  // namespace

std::string gl_driver_name(const std::string& renderer, const std::string& version) {
  if (renderer.rfind("llvmpipe", 0) == 0) {
    return "llvmpipe " + mesa_version(version) + (fuses() ? ", fused" : ", not fused");
  }
  return renderer + ", " + version;
}

bool is_measured_driver(const std::string& driver) {
  const std::vector<std::string>& drivers = measured_drivers();
  return std::find(drivers.begin(), drivers.end(), driver) != drivers.end();
}

}  // namespace caustics
