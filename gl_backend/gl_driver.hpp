// Which driver draws: the name under which its differences from the software device were measured.
#pragma once
#include <string>

namespace caustics {

// "llvmpipe 22.3.6, fused", or renderer and version of other drivers. `renderer` and `version` are
// GL_RENDERER and GL_VERSION. llvmpipe's results depend on whether the processor has fused multiply-add.
std::string gl_driver_name(const std::string& renderer, const std::string& version);

// Were this driver's differences measured (docs/parity.md)?
bool is_measured_driver(const std::string& driver);

}  // namespace caustics
