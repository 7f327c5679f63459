// Put into the planted copy's main of Catch2's tests (plant.py): writes which places each test case reached,
// and the seconds that it took, a line each, to the file that the variable CAUSTICS_REACH_LOG names.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "pipeline/gpu/fault.hpp"
#include "tests/support/catch.hpp"

namespace {

#if __has_include(<catch2/catch_all.hpp>)
using ListenerBase = Catch::EventListenerBase;
#else
using ListenerBase = Catch::TestEventListenerBase;
#endif

struct ReachListener : ListenerBase {
  using ListenerBase::ListenerBase;

  void testCaseStarting(const Catch::TestCaseInfo& info) override {
    if (log() == nullptr) return;
    name_ = info.name;
    std::memset(caustics_reached, 0, kFaultPlaces);
    begun_ = std::chrono::steady_clock::now();
  }

  void testCaseEnded(const Catch::TestCaseStats& stats) override {
    std::FILE* file = log();
    if (file == nullptr) return;
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun_;
    std::fprintf(file, "%s\t%.4f\t%d\t", name_.c_str(), taken.count(), stats.totals.testCases.failed == 0);
    for (int place = 0; place < kFaultPlaces; ++place)
      if (caustics_reached[place] != 0) std::fprintf(file, "%d ", place);
    std::fputc('\n', file);
    std::fflush(file);
  }

 private:
  static std::FILE* log() {
    static const char* const name = std::getenv("CAUSTICS_REACH_LOG");
    static std::FILE* const file = name == nullptr ? nullptr : std::fopen(name, "w");
    return file;
  }

  std::string name_;
  std::chrono::steady_clock::time_point begun_;
};

CATCH_REGISTER_LISTENER(ReachListener)

}  // namespace
