// An OpenGL driver that fails at calls of one's choice. libepoxy reaches the driver through pointers, one for
// each function; while a FaultyDriver lives, those that the backend uses lead through it.
#pragma once
#include <map>
#include <string>

namespace caustics::test {

class FaultyDriver {
 public:
  FaultyDriver();
  ~FaultyDriver();
  FaultyDriver(const FaultyDriver&) = delete;
  FaultyDriver& operator=(const FaultyDriver&) = delete;

  static constexpr int kAlways = -1;

  // The n-th call of `function` from now on, 0 the next, or every call of it, does nothing and answers 0; a
  // function of OpenGL also sets the error flag GL_OUT_OF_MEMORY.
  void fail(const std::string& function, int n);
  // From the n-th question after errors on, 0 the next, the driver says that it was reset.
  void reset_at(int n);
  // What the driver is asked to wait for is never done.
  void stall();
  // EGL tells no extension of a display.
  void hide_display_extensions();
  void mend();

  // Calls of each function since the last mend(), in the order of their names; functions that were not called
  // are absent.
  std::map<std::string, int> calls() const;
};

}  // namespace caustics::test
