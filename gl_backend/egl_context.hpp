// An OpenGL 4.5 core context without a window, and the ways that EGL offers to get one.
#pragma once
#include <epoxy/egl.h>

#include <string>
#include <vector>

namespace caustics::gl {

enum class Platform { Device, Surfaceless, DefaultDisplay };

// A way to a display. `device` is set for Platform::Device only.
struct EglCandidate {
  Platform platform = Platform::DefaultDisplay;
  EGLDeviceEXT device = nullptr;
  std::string name;  // for people
};

// In the order in which they are tried. Throws Error (BackendUnavailable) where EGL or OpenGL
// libraries are missing.
std::vector<EglCandidate> egl_candidates();

// An initialised display. EGL hands out one for each device, however often it is asked, and keeps
// it until the process ends: terminating it would end the contexts of others and unload the driver,
// whose libraries do not clean up after themselves.
class EglDisplay {
 public:
  explicit EglDisplay(const EglCandidate& candidate);  // throws Error (BackendUnavailable)
  EGLDisplay handle() const { return display_; }
  bool has(const char* extension) const;

 private:
  EGLDisplay display_ = EGL_NO_DISPLAY;
};

// Made current in the calling thread. Throws Error (BackendUnavailable) with the reason.
class EglContext {
 public:
  EglContext(const EglCandidate& candidate, bool debug);
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;
  // Costs next to nothing when it is current already. Throws Error (BackendUnavailable).
  void make_current();
  // The same without an Error, for destructors; false when it failed.
  bool try_make_current() noexcept;

 private:
  void create(bool debug);
  EGLConfig choose_config() const;
  void release() noexcept;

  EglDisplay display_;
  EGLSurface surface_ = EGL_NO_SURFACE;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace caustics::gl
