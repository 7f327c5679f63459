#include "tests/gl/faulty_driver.hpp"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>
#include <cstring>
#include <stdexcept>
#include <tuple>
#include <type_traits>
#include <utility>

// Made from gl_backend's sources: CALL(glClear) CALL(eglInitialize) ...
#define CALL(name) +1
constexpr std::size_t kFunctions = 0
#include "driver_calls.inc"
    ;
#undef CALL

namespace caustics::test {

namespace {

using Pointer = void (*)();

struct State {
  std::array<Pointer, kFunctions> real{};
  std::array<int, kFunctions> calls{};
  std::size_t failing = kFunctions;  // none
  int at = 0;
  bool out_of_memory = false, extensions_hidden = false, stalled = false;
  int questions = 0, reset_at = -1;
  bool was_reset() const { return reset_at >= 0 && questions > reset_at; }
} state;

constexpr const char* kNames[] = {
#define CALL(name) #name,
#include "driver_calls.inc"
#undef CALL
};

bool is(std::size_t function, const char* name) { return std::strcmp(kNames[function], name) == 0; }

bool fails_now(std::size_t function) {
  const int n = state.calls[function]++;
  if (function != state.failing || (state.at != FaultyDriver::kAlways && n != state.at)) return false;
  if (kNames[function][0] == 'g') state.out_of_memory = true;
  return true;
}

// What stands in a function's pointer while the driver is faulty.
template <class>
struct Through;
template <class R, class... Arguments>
struct Through<R (*)(Arguments...)> {
  using Function = R (*)(Arguments...);

  template <auto* kPointer, std::size_t kFunction>
  static R call(Arguments... arguments) {
    if (fails_now(kFunction)) return R();
    if constexpr (std::is_same_v<R, GLenum>) {
      if (is(kFunction, "glGetError")) {
        ++state.questions;
        if (std::exchange(state.out_of_memory, false)) return GL_OUT_OF_MEMORY;
      }
      if (is(kFunction, "glClientWaitSync") && state.stalled) return GL_TIMEOUT_EXPIRED;
      if (is(kFunction, "glGetGraphicsResetStatus") && state.was_reset()) return GL_UNKNOWN_CONTEXT_RESET;
    }
    if constexpr (std::is_same_v<R, const char*>) {
      if (state.extensions_hidden && std::get<0>(std::tuple(arguments...)) != EGL_NO_DISPLAY) return "";
    }
    return real<kPointer, kFunction>(arguments...);
  }

 private:
  // Until its first call, libepoxy's own pointer leads to what looks the function up, puts it there and calls
  // what is there.
  template <auto* kPointer, std::size_t kFunction>
  static R real(Arguments... arguments) {
    struct ThroughHereAgain {
      ~ThroughHereAgain() {
        state.real[kFunction] = reinterpret_cast<Pointer>(*kPointer);
        *kPointer = &call<kPointer, kFunction>;
      }
    } through_here_again;
    *kPointer = reinterpret_cast<Function>(state.real[kFunction]);
    return (*kPointer)(arguments...);
  }
};

template <auto* kPointer, std::size_t kFunction>
void lead_through() {
  state.real[kFunction] = reinterpret_cast<Pointer>(*kPointer);
  *kPointer = &Through<std::remove_pointer_t<decltype(kPointer)>>::template call<kPointer, kFunction>;
}

template <auto* kPointer, std::size_t kFunction>
void lead_straight() {
  *kPointer = reinterpret_cast<std::remove_pointer_t<decltype(kPointer)>>(state.real[kFunction]);
}

enum : std::size_t {
#define CALL(name) kNumber_##name,
#include "driver_calls.inc"
#undef CALL
};

}  // namespace

FaultyDriver::FaultyDriver() {
#define CALL(name) lead_through<&epoxy_##name, kNumber_##name>();
#include "driver_calls.inc"
#undef CALL
  mend();
}

FaultyDriver::~FaultyDriver() {
#define CALL(name) lead_straight<&epoxy_##name, kNumber_##name>();
#include "driver_calls.inc"
#undef CALL
}

void FaultyDriver::fail(const std::string& function, int n) {
  mend();
  for (state.failing = 0; state.failing < kFunctions; ++state.failing)
    if (function == kNames[state.failing]) break;
  if (state.failing == kFunctions) throw std::invalid_argument(function + " is not called by the backend");
  state.at = n;
}

void FaultyDriver::reset_at(int n) {
  mend();
  state.reset_at = n;
}

void FaultyDriver::stall() { state.stalled = true; }

void FaultyDriver::hide_display_extensions() { state.extensions_hidden = true; }

void FaultyDriver::mend() {
  // An error that nobody has asked for stays, as drivers keep it.
  const State before = state;
  state = State{};
  state.real = before.real;
  state.out_of_memory = before.out_of_memory;
}

std::map<std::string, int> FaultyDriver::calls() const {
  std::map<std::string, int> calls;
  for (std::size_t i = 0; i < kFunctions; ++i)
    if (state.calls[i] > 0) calls[kNames[i]] = state.calls[i];
  return calls;
}

}  // namespace caustics::test
