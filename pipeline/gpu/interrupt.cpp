#include "pipeline/gpu/interrupt.hpp"

#include <atomic>

namespace caustics {

namespace {
// Lock-free, so that a signal handler may write it.
std::atomic<int> asked{0};
static_assert(std::atomic<int>::is_always_lock_free);
}  // namespace

void ask_to_stop(ExitCode code) noexcept {
  int nothing = 0;
  if (code == ExitCode::Done)
    asked = 0;
  else
    asked.compare_exchange_strong(nothing, static_cast<int>(code));
}

ExitCode interruption() noexcept { return static_cast<ExitCode>(asked.load(std::memory_order_relaxed)); }

void stop_if_interrupted() {
  if (const ExitCode code = interruption(); code != ExitCode::Done) throw Error(code, "interrupted");
}

}  // namespace caustics
