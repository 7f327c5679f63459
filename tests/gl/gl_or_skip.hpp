// The OpenGL Device for tests, where this machine has one.
#pragma once
#include <cstdlib>
#include <memory>
#include <string>

#include "gl_backend/gl_probe.hpp"
#include "pipeline/gpu/error.hpp"
#include "tests/support/catch.hpp"

namespace caustics::test {

// Null with a printed reason where OpenGL cannot be used: the test returns. Where the environment
// says CAUSTICS_REQUIRE_GL=1, that is a failure instead.
inline std::unique_ptr<GlDevice> gl_or_skip(const GlOptions& options = {.measure = true, .debug = true}) {
  try {
    return make_gl_device(options);
  } catch (const Error& error) {
    const char* required = std::getenv("CAUSTICS_REQUIRE_GL");
    if (required && std::string(required) == "1") FAIL(error.what());
    WARN("skipped: " << error.what());
    return nullptr;
  }
}

// Of this machine's driver: every device of a test program is made by the same.
inline DriverClass driver_class(GlDevice& device) {
  static const DriverClass found = class_of(probe(device));
  return found;
}

}  // namespace caustics::test
