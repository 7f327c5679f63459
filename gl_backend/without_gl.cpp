// In place of the OpenGL Device where libepoxy was not found at build time.
#include "gl_backend/gl_device.hpp"
#include "pipeline/gpu/error.hpp"

namespace caustics {

namespace {

[[noreturn]] void refuse() {
  throw Error(ExitCode::BackendUnavailable,
              "built without OpenGL (libepoxy was not found); --backend software works");
}

}  // namespace

std::vector<GlDeviceInfo> list_gl_devices() { refuse(); }
std::unique_ptr<GlDevice> make_gl_device(const GlOptions&) { refuse(); }

}  // namespace caustics
