// Runs that were handed to the driver and are not drawn yet. Drivers take commands for whole frames ahead;
// software renderers then draw for seconds, in which nothing hears that work is to stop.
#pragma once
#include <epoxy/gl.h>

#include <deque>

namespace caustics::gl {

// Its context must be current whenever it is used, and when it goes.
class Backlog {
 public:
  // This many runs may be under way: a GPU has work while the next run is prepared.
  static constexpr std::size_t kMost = 2;

  Backlog() = default;
  ~Backlog() { forget(); }
  Backlog(const Backlog&) = delete;
  Backlog& operator=(const Backlog&) = delete;

  // Hands on all commands so far as a run, and waits until at most kMost runs are under way. Throws Error
  // when work is asked to stop meanwhile (pipeline/gpu/interrupt.hpp).
  void add();
  // Counts no run as under way any more.
  void forget() noexcept;

 private:
  std::deque<GLsync> ends_;  // the oldest first
};

}  // namespace caustics::gl
