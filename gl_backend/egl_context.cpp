#include "gl_backend/egl_context.hpp"

#include <dlfcn.h>
#include <epoxy/gl.h>

#include <cstdio>
#include <sstream>
#include <string_view>

#include "pipeline/gpu/error.hpp"

namespace caustics::gl {

namespace {

[[noreturn]] void refuse(const std::string& why) { throw Error(ExitCode::BackendUnavailable, why); }

std::string egl_error() {
  char text[16];
  std::snprintf(text, sizeof text, "0x%04x", static_cast<unsigned>(eglGetError()));
  return text;
}

// libepoxy ends the process when it cannot load a library, so they are looked for here first.
void require_libraries() {
  const auto exists = [](const char* name) {
    void* library = dlopen(name, RTLD_LAZY | RTLD_LOCAL);
    if (library) dlclose(library);
    return library != nullptr;
  };
  if (!exists("libEGL.so.1")) refuse("the library libEGL.so.1 is missing");
  if (!exists("libOpenGL.so.0") && !exists("libGL.so.1"))
    refuse("the libraries libOpenGL.so.0 and libGL.so.1 are missing");
}

bool has_word(const char* list, std::string_view word) {
  std::istringstream words(list ? list : "");
  for (std::string w; words >> w;)
    if (w == word) return true;
  return false;
}

template <class Function>
Function egl_function(const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

std::vector<EGLDeviceEXT> egl_devices(const char* client) {
  if (!has_word(client, "EGL_EXT_platform_device") ||
      !(has_word(client, "EGL_EXT_device_enumeration") || has_word(client, "EGL_EXT_device_base")))
    return {};
  const auto query = egl_function<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  EGLint count = 0;
  if (!query || !query(0, nullptr, &count) || count <= 0) return {};
  std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
  if (!query(count, devices.data(), &count)) return {};
  devices.resize(static_cast<std::size_t>(count));
  return devices;
}

std::string device_name(EGLDeviceEXT device, std::size_t index) {
  std::string name = "EGL device " + std::to_string(index);
  const auto query = egl_function<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
  if (!query) return name;
  const char* extensions = query(device, EGL_EXTENSIONS);
  if (has_word(extensions, "EGL_EXT_device_drm"))
    if (const char* file = query(device, EGL_DRM_DEVICE_FILE_EXT)) return name + " (" + file + ")";
  return has_word(extensions, "EGL_MESA_device_software") ? name + " (software)" : name;
}

EGLDisplay find_display(const EglCandidate& candidate) {
  if (candidate.platform == Platform::DefaultDisplay) return eglGetDisplay(EGL_DEFAULT_DISPLAY);
  const auto get = egl_function<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  if (!get) return EGL_NO_DISPLAY;
  return candidate.platform == Platform::Device
             ? get(EGL_PLATFORM_DEVICE_EXT, candidate.device, nullptr)
             : get(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
}

}  // namespace

std::vector<EglCandidate> egl_candidates() {
  require_libraries();
  std::vector<EglCandidate> candidates;
  const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const std::vector<EGLDeviceEXT> devices = egl_devices(client);
  for (std::size_t i = 0; i < devices.size(); ++i)
    candidates.push_back({Platform::Device, devices[i], device_name(devices[i], i)});
  if (has_word(client, "EGL_MESA_platform_surfaceless"))
    candidates.push_back({Platform::Surfaceless, nullptr, "surfaceless"});
  candidates.push_back({Platform::DefaultDisplay, nullptr, "default display"});
  return candidates;
}

EglDisplay::EglDisplay(const EglCandidate& candidate) : display_(find_display(candidate)) {
  if (display_ == EGL_NO_DISPLAY) refuse("EGL has no such display");
  EGLint major = 0, minor = 0;
  if (!eglInitialize(display_, &major, &minor)) refuse("eglInitialize failed (" + egl_error() + ")");
}

bool EglDisplay::has(const char* extension) const {
  return has_word(eglQueryString(display_, EGL_EXTENSIONS), extension);
}

EglContext::EglContext(const EglCandidate& candidate, bool debug) : display_(candidate) {
  try {
    create(debug);
    make_current();
    GLint major = 0, minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    if (major * 10 + minor < 45)
      refuse("OpenGL " + std::to_string(major) + "." + std::to_string(minor) + " is older than 4.5");
  } catch (...) {
    release();
    throw;
  }
}

EglContext::~EglContext() { release(); }

EGLConfig EglContext::choose_config() const {
  if (display_.has("EGL_KHR_no_config_context") && display_.has("EGL_KHR_surfaceless_context"))
    return nullptr;  // EGL_NO_CONFIG_KHR
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(display_.handle(), wanted, &config, 1, &count) || count < 1)
    refuse("EGL has no configuration for OpenGL without a window");
  return config;
}

void EglContext::create(bool debug) {
  if (!eglBindAPI(EGL_OPENGL_API)) refuse("EGL does not offer OpenGL (" + egl_error() + ")");
  const EGLConfig config = choose_config();
  if (!display_.has("EGL_KHR_surfaceless_context")) {
    const EGLint size[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
    surface_ = eglCreatePbufferSurface(display_.handle(), config, size);
    if (surface_ == EGL_NO_SURFACE) refuse("eglCreatePbufferSurface failed (" + egl_error() + ")");
  }
  // With everything that helps to explain a fault; drivers that know none of it get a plain
  // context.
  for (const bool tell_resets : {true, false})
    for (const bool with_debug : {debug, false}) {
      std::vector<EGLint> wanted = {
          EGL_CONTEXT_MAJOR_VERSION_KHR,       4,
          EGL_CONTEXT_MINOR_VERSION_KHR,       5,
          EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR};
      if (with_debug) wanted.insert(wanted.end(), {EGL_CONTEXT_FLAGS_KHR, EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR});
      if (tell_resets)
        wanted.insert(wanted.end(),
                      {EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_KHR, EGL_LOSE_CONTEXT_ON_RESET_KHR});
      wanted.push_back(EGL_NONE);
      context_ = eglCreateContext(display_.handle(), config, EGL_NO_CONTEXT, wanted.data());
      if (context_ != EGL_NO_CONTEXT) return;
    }
  refuse("no OpenGL 4.5 core context (" + egl_error() + ")");
}

bool EglContext::try_make_current() noexcept {
  if (eglGetCurrentContext() == context_) return true;
  return eglBindAPI(EGL_OPENGL_API) && eglMakeCurrent(display_.handle(), surface_, surface_, context_);
}

void EglContext::make_current() {
  if (!try_make_current()) refuse("eglMakeCurrent failed (" + egl_error() + ")");
}

void EglContext::release() noexcept {
  if (context_ != EGL_NO_CONTEXT) {
    if (eglGetCurrentContext() == context_)
      eglMakeCurrent(display_.handle(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_.handle(), context_);
  }
  if (surface_ != EGL_NO_SURFACE) eglDestroySurface(display_.handle(), surface_);
}

}  // namespace caustics::gl
