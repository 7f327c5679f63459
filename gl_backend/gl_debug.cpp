#include "gl_backend/gl_debug.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "pipeline/gpu/error.hpp"

namespace caustics::gl {

namespace {

// The driver may be any language: nothing may be thrown through it.
void GLAPIENTRY on_message(GLenum, GLenum type, GLuint, GLenum severity, GLsizei, const GLchar* message,
                           const void* log) noexcept {
  if (type == GL_DEBUG_TYPE_ERROR || severity == GL_DEBUG_SEVERITY_HIGH)
    static_cast<DebugLog*>(const_cast<void*>(log))->add(message);
}

// The first error flag that is set; a lost context sets its own again and again.
GLenum take_error() {
  const GLenum first = glGetError();
  for (int i = 0; i < 8 && first != GL_NO_ERROR && glGetError() != GL_NO_ERROR; ++i) continue;
  return first;
}

// Faults of the device, which no caller can have made.
void check_device(const std::string& what, GLenum error) {
  if (glGetGraphicsResetStatus() != GL_NO_ERROR || error == GL_CONTEXT_LOST)
    throw Error(ExitCode::BackendUnavailable,
                what +
                    ": the graphics driver was reset and its contents are lost; start again, or "
                    "use --backend software");
  if (error == GL_OUT_OF_MEMORY)
    throw Error(ExitCode::BackendUnavailable,
                what + ": the graphics memory has run out; use smaller maps or --backend software");
}

}  // namespace

DebugLog::DebugLog(bool messages) : messages_(messages) {
  if (!messages_) return;
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(on_message, this);
}

DebugLog::~DebugLog() {
  if (messages_) glDebugMessageCallback(nullptr, nullptr);
}

void DebugLog::add(const char* message) {
  if (first_.empty()) first_ = message;
  std::replace(first_.begin(), first_.end(), '\n', ' ');
}

void DebugLog::forget(const std::string& what) {
  first_.clear();
  check_device(what, take_error());
}

void DebugLog::drop() {
  take_error();
  first_.clear();
}

void DebugLog::check(const std::string& what) {
  const GLenum error = take_error();
  const std::string message = std::exchange(first_, {});
  check_device(what, error);
  if (error == GL_NO_ERROR && message.empty()) return;
  char code[16];
  std::snprintf(code, sizeof code, "0x%04x", error);
  throw Error(ExitCode::InternalError,
              what + ": OpenGL reports " + (message.empty() ? "error " + std::string(code) : message));
}

}  // namespace caustics::gl
