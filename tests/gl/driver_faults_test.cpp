// An OpenGL driver that fails at any of its calls: one line that says so, no wrong picture, and a device that
// goes on.
#include <algorithm>
#include <set>

#include "pipeline/gpu/interrupt.hpp"
#include "tests/gl/faulty_driver.hpp"
#include "tests/gl/gl_or_skip.hpp"
#include "tests/support/device_contracts.hpp"
#include "tests/support/pilot.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

const Settings kSettings = through_two_surfaces(small_settings(16, 16, 8));

std::string frame_on(Device& device) {
  return sha256(render_on(device, sphere_scene(1.5f, 2), kSettings, {}, &pilot().device)["picture"]);
}

const GlOptions kWithAll = {.measure = true, .debug = true};

struct Outcome {
  std::string result, error;
};

// What `work` gives, or its error, which must be the device's and one line.
template <class Work>
Outcome outcome_of(Work work) {
  try {
    return {work(), ""};
  } catch (const Error& error) {
    const std::string line = error.what();
    CHECK(error.code() == ExitCode::BackendUnavailable);
    CHECK(line.find('\n') == std::string::npos);
    CHECK(line.find("--backend software") != std::string::npos);
    return {"", line};
  }
}

// A draw without its array of indices reads at address 0, by OpenGL's own rules; and what tells errors cannot
// fail by one.
const std::set<std::string> kMustNotFail = {"glBindVertexArray", "glGetError"};

// Their failure changes nothing that is seen: the context is made current once more, nothing was reset, an
// object stays.
const std::set<std::string> kMayFail = {"eglGetCurrentContext", "glDeleteBuffers",
                                        "glDeleteFramebuffers", "glDeleteTextures",
                                        "glDeleteVertexArrays", "glGetGraphicsResetStatus"};

// A device starts and ends without them; what they should have deleted goes with its context.
const std::set<std::string> kNotNeeded = {"eglDestroyContext",    "eglGetCurrentContext",
                                          "glDeleteQueries",      "glDeleteTextures",
                                          "glDeleteVertexArrays", "glGetGraphicsResetStatus"};

bool contains(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE(
    "gl: memory that runs out at any call of a frame is told in one line, and the next frame is right") {
  const auto device = gl_or_skip();
  const std::string expected = frame_on(*device);
  FaultyDriver driver;
  CHECK(frame_on(*device) == expected);
  const std::map<std::string, int> calls = driver.calls();
  CHECK(calls.size() > 40);
  std::set<std::string> unnoticed;
  for (const auto& [function, count] : calls) {
    if (kMustNotFail.count(function)) continue;
    for (const int n : std::set<int>{0, count / 2, count - 1}) {
      INFO(function << ", call " << n << " of " << count);
      driver.fail(function, n);
      const Outcome outcome = outcome_of([&] { return frame_on(*device); });
      if (outcome.error.empty()) {
        CHECK(outcome.result == expected);
        unnoticed.insert(function);
      } else {
        CHECK(contains(outcome.error, "the graphics memory has run out"));
      }
      std::map<std::string, int> called = driver.calls();
      CHECK(called["glCreateTextures"] - (function == "glCreateTextures") == called["glDeleteTextures"]);
      driver.mend();
      CHECK(outcome_of([&] { return frame_on(*device); }).result == expected);
    }
  }
  CHECK(unnoticed == kMayFail);
}

TEST_CASE("gl: a driver that is reset says so, whenever it is asked") {
  const auto device = gl_or_skip();
  frame_on(*device);
  FaultyDriver driver;
  frame_on(*device);
  const int questions = driver.calls().at("glGetGraphicsResetStatus");
  for (int n = 0; n < questions; n += 7) {
    driver.reset_at(n);
    CHECK(contains(outcome_of([&] { return frame_on(*device); }).error, "the graphics driver was reset"));
  }
}

TEST_CASE(
    "gl: memory that runs out while a shader is made is told in one line, and the shader is made the next "
    "time") {
  const auto device = gl_or_skip();
  const std::string expected = frame_on(*gl_or_skip());
  FaultyDriver driver;
  for (const char* function :
       {"glCreateProgram", "glCreateShader", "glShaderSource", "glCompileShader", "glGetShaderiv",
        "glAttachShader", "glBindAttribLocation", "glLinkProgram", "glGetProgramiv", "glDetachShader",
        "glDeleteShader", "glGetUniformBlockIndex", "glGetActiveUniformBlockiv"}) {
    INFO(function);
    driver.fail(function, 0);
    CHECK(contains(outcome_of([&] { return frame_on(*device); }).error, "the graphics memory has run out"));
    CHECK(device->made().programs == 0);
  }
  driver.mend();
  CHECK(frame_on(*device) == expected);
}

TEST_CASE("gl: a driver that fails while a device starts gives another device, or one line that says why") {
  gl_or_skip();
  FaultyDriver driver;
  const auto start = [] { return make_gl_device(kWithAll)->renderer(); };
  start();
  const std::map<std::string, int> calls = driver.calls();
  std::set<std::string> renderers, done_without;
  for (const GlDeviceInfo& info : list_gl_devices()) renderers.insert(info.renderer);
  for (const auto& [function, count] : calls) {
    if (kMustNotFail.count(function)) continue;
    for (const int n : {0, count - 1, FaultyDriver::kAlways}) {
      INFO(function << ", call " << n << " of " << count);
      driver.fail(function, n);
      const Outcome outcome = outcome_of(start);
      if (outcome.error.empty()) {
        CHECK(renderers.count(outcome.result) == 1);
        if (n == FaultyDriver::kAlways) done_without.insert(function);
      } else {
        CHECK(contains(outcome.error, "no OpenGL 4.5 core context ("));
      }
      driver.mend();
      CHECK(renderers.count(outcome_of(start).result) == 1);
    }
  }
  // Where a display works too, more can fail for good.
  CHECK(std::includes(done_without.begin(), done_without.end(), kNotNeeded.begin(), kNotNeeded.end()));
  CHECK(done_without.count("eglInitialize") + done_without.count("eglCreateContext") +
            done_without.count("eglMakeCurrent") ==
        0);
}

TEST_CASE("gl: a display that offers no contexts without a surface gets a surface of one pixel") {
  const auto device = gl_or_skip();
  FaultyDriver driver;
  driver.hide_display_extensions();
  const Outcome outcome = outcome_of([&] { return frame_on(*make_gl_device(kWithAll)); });
  CHECK(driver.calls().count("eglCreatePbufferSurface") == 1);
  CHECK(outcome.error == "");
  CHECK(outcome.result == frame_on(*device));
  driver.fail("eglChooseConfig", FaultyDriver::kAlways);
  driver.hide_display_extensions();
  CHECK(contains(outcome_of([] { return make_gl_device(kWithAll)->renderer(); }).error,
                 "EGL has no configuration"));
}

TEST_CASE("gl: a device that takes the place of one that fails says which, and why") {
  gl_or_skip();
  CHECK(make_gl_device()->passed_over() == "");
  const std::string first = list_gl_devices().front().platform;
  FaultyDriver driver;
  driver.fail("eglInitialize", 0);
  const std::string passed_over = make_gl_device()->passed_over();
  CHECK(contains(passed_over, ("device 0, " + first + ": eglInitialize failed").c_str()));
  CHECK(!contains(passed_over, "device 1"));
}

TEST_CASE("gl: a frame waits, counts and hears the driver's messages only on request") {
  for (const bool requested : {true, false}) {
    const auto device = gl_or_skip({.measure = requested, .debug = requested});
    frame_on(*device);
    FaultyDriver driver;
    make_gl_device({.measure = requested, .debug = requested});
    frame_on(*device);
    const std::map<std::string, int> calls = driver.calls();
    INFO(requested);
    CHECK((calls.count("glDebugMessageCallback") == 1) == requested);
    CHECK((calls.count("glFinish") + calls.count("glGetQueryObjectui64v") > 0) == requested);
  }
}

TEST_CASE("gl: at most two runs are ahead of the driver, and waiting for it ends when work is to stop") {
  const auto device = gl_or_skip({});
  PassDefinition definition{.name = "clear",
                            .purpose = "test",
                            .writes = {{.name = "a", .meaning = "m"}},
                            .shader = &raster_probe_shader};
  const PassRun run{.definition = &definition,
                    .colors = {device->create_texture(definition.writes[0].format, 3, 2)}};
  FaultyDriver driver;
  driver.stall();
  device->run(run);
  device->run(run);
  CHECK(driver.calls().count("glClientWaitSync") == 0);
  ask_to_stop(ExitCode::Terminated);
  CHECK_THROWS_WITH(device->run(run), "interrupted");
  ask_to_stop(ExitCode::Done);
  CHECK(driver.calls().at("glClientWaitSync") == 1);
  // What was under way is forgotten; a driver that goes on is waited for once a run.
  driver.mend();
  for (int i = 0; i < 5; ++i) device->run(run);
  CHECK(driver.calls().at("glClientWaitSync") == 3);
  CHECK(driver.calls().at("glDeleteSync") == 3);
}

TEST_CASE("gl: each shader is told before it is compiled, once for each of its programs") {
  std::vector<std::string> told;
  const auto device = gl_or_skip({.compiling = [&](std::string_view shader) { told.emplace_back(shader); }});
  frame_on(*device);
  CHECK(told.size() == device->made().programs);
  CHECK(std::set<std::string>(told.begin(), told.end()).size() == told.size());
  frame_on(*device);
  CHECK(told.size() == device->made().programs);
}
