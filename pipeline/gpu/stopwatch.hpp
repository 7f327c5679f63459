// What a piece of work takes: time on the wall, and on processors, of all threads of the process.
#pragma once
#include <time.h>

#include <chrono>

namespace caustics {

class Stopwatch {
 public:
  double milliseconds() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }
  double processor_milliseconds() const { return processor_now() - processor_start_; }

 private:
  static double processor_now() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
  }

  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double processor_start_ = processor_now();
};

}  // namespace caustics
