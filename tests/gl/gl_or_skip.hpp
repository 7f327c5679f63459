// The OpenGL Device for tests, where this machine has one.
#pragma once
#include <cstdlib>
#include <memory>
#include <string>

#include "gl_backend/gl_probe.hpp"
#include "pipeline/gpu/error.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/skip.hpp"

namespace caustics::test {

// Where OpenGL cannot be used, the test is skipped with the reason; where the environment says
// CAUSTICS_REQUIRE_GL=1, it fails instead.
inline std::unique_ptr<GlDevice> gl_or_skip(const GlOptions& options = {.measure = true, .debug = true}) {
  std::string cause;
  try {
    return make_gl_device(options);
  } catch (const Error& error) {
    cause = error.what();
  }
  const char* required = std::getenv("CAUSTICS_REQUIRE_GL");
  if (required && std::string(required) == "1") FAIL(cause);
  skip(cause);
}

// Null where there is none: for tests that do without it first, and call gl_or_skip in the end.
inline std::unique_ptr<GlDevice> gl_if_any() {
  try {
    return make_gl_device({.measure = true, .debug = true});
  } catch (const Error&) {
    return nullptr;
  }
}

// Of this machine's driver: every device of a test program is made by the same.
inline DriverClass driver_class(GlDevice& device) {
  static const DriverClass found = class_of(probe(device));
  return found;
}

}  // namespace caustics::test
