// Work in pieces on several threads, and the floating-point mode that it runs in.
#pragma once
#include <cfenv>
#include <functional>

namespace caustics::tracer {

// While it lives, this thread computes in the default mode: to nearest, denormals kept, nothing trapped.
// Embree flushes denormals while it builds a scene, and so do the rasterizer's workers; neither may reach
// the tracer, nor stay behind it.
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

// Calls work(0) .. work(pieces - 1), each once, in any order, on at most `threads` threads (0: one a core).
// What work throws is thrown here.
void in_pieces(int pieces, int threads, const std::function<void(int)>& work);

}  // namespace caustics::tracer
