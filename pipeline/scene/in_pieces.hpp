// Work in pieces on several threads, and the floating-point mode that it runs in.
#pragma once
#include <cfenv>
#include <cstddef>
#include <functional>

namespace caustics {

// While it lives, this thread computes in the default mode: to nearest, denormals kept, nothing trapped.
// Embree flushes denormals while it builds a scene, and so do the rasterizer's workers; neither may reach
// the tracer or a scene's preparation, nor stay behind it.
class PlainFloats {
 public:
  PlainFloats() {
    std::fegetenv(&saved_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~PlainFloats() { std::fesetenv(&saved_); }
  PlainFloats(const PlainFloats&) = delete;
  PlainFloats& operator=(const PlainFloats&) = delete;

 private:
  std::fenv_t saved_;
};

// Calls work(0) .. work(pieces - 1), each once, in any order, on at most `threads` threads (0: one a core,
// and no more than a software device that lives was given). What work throws is thrown here; so is
// an interruption, before the next piece (pipeline/gpu/interrupt.hpp).
void in_pieces(int pieces, int threads, const std::function<void(int)>& work);

// Likewise work(first, end) for all of 0 .. count - 1, a run of some thousands at a time.
void in_runs(std::size_t count, int threads,
             const std::function<void(std::size_t first, std::size_t end)>& work);

}  // namespace caustics
