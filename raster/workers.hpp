// Threads, and the floating-point mode that they compute in.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>

namespace caustics::raster {

// Flushes denormal results and operands to zero while it lives, as the GPU does, and rounds to nearest.
// On x86 and aarch64; other machines lack such a mode, or it is not known here.
class FlushDenormals {
 public:
  FlushDenormals();
  ~FlushDenormals();
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  std::uint64_t saved_ = 0;
};

// A fixed number of threads of this device's own.
class Workers {
 public:
  explicit Workers(int threads);  // 0: all that the machine has
  ~Workers();
  int threads() const { return threads_; }
  // Calls task(0) .. task(count - 1), in any order, on the threads, denormals flushed.
  // Throws what a task throws, and an interruption (pipeline/gpu/interrupt.hpp).
  void run(int count, const std::function<void(int)>& task) const;

 private:
  struct Arena;
  int threads_ = 1;
  std::unique_ptr<Arena> arena_;
};

}  // namespace caustics::raster
