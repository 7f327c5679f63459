// The OpenGL Device: executes pass definitions through OpenGL 4.5 core, on a context that EGL makes
// without a window system. It knows no pass. One device is used from one thread; several devices
// may live in one thread.
//
// Differences that the contract allows: denormals are flushed by some drivers, fragments are
// counted where the driver counts them. It never multisamples, filters, makes mipmaps or converts to sRGB.
// Where the driver's points are not as large as pipeline/gpu/point_rule.hpp promises, it draws them as
// quadrilaterals.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/gpu/device.hpp"

namespace caustics {

struct GlOptions {
  // One of list_gl_devices(), by index; -1 takes the first that works.
  int device = -1;
  // Measure each run: PassResult::milliseconds, samples_passed, and fragments where the driver counts
  // them. The device then waits for the end of each run. Without it they are 0, and no run waits.
  bool measure = false;
  // Ask for a debug context, whose messages name the faulty call in an Error. Without it faults are
  // still noticed, with less to read.
  bool debug = false;
  // Called before a shader is compiled, with its name: by the first run() that needs it with the choices of
  // its uniform block. Drivers may put most of the work off until that run draws.
  std::function<void(std::string_view shader)> compiling = {};
  // Treat the driver as one whose points are no larger than this, for tests; 0: as large as it says.
  float largest_point = 0.0f;
};

// What the driver says of itself.
struct GlLimits {
  int subpixel_bits = 0;
  float smallest_point = 0.0f, largest_point = 0.0f;  // pixels
};

// Beyond the contract, for tests and tools.
class GlDevice : public Device {
 public:
  // GL_RENDERER, e.g. "llvmpipe (LLVM 15.0.6, 256 bits)".
  virtual std::string renderer() const = 0;
  // GL_VERSION, e.g. "4.5 (Core Profile) Mesa 22.3.6".
  virtual std::string version() const = 0;
  virtual GlLimits limits() const = 0;
  // What could not be used before this one was taken, and why: "device 0, EGL device 0 (/dev/dri/card0):
  // eglInitialize failed (0x3001)"; empty where it was the first choice.
  virtual std::string passed_over() const = 0;
};

// One way that EGL offers to reach OpenGL, and what it leads to.
struct GlDeviceInfo {
  int index = 0;
  std::string platform;  // "EGL device 0 (/dev/dri/card0)", "surfaceless", "default display"
  std::string vendor, renderer, version;
  std::string reason;  // why it cannot be used; empty when it can
};

// All that EGL offers on this machine: its devices, then Mesa's surfaceless platform, then the
// default display. The last is tried only when nothing before it works. Throws Error
// (BackendUnavailable) where there is no EGL.
std::vector<GlDeviceInfo> list_gl_devices();

// Throws Error (BackendUnavailable) when no device works, or the one asked for does not.
std::unique_ptr<GlDevice> make_gl_device(const GlOptions& options = {});

}  // namespace caustics
