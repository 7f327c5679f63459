#include "raster/workers.hpp"

#include <algorithm>
#include <atomic>
#include <thread>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif
#if CAUSTICS_HAS_TBB
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#endif

#include "pipeline/gpu/happens_before.hpp"
#include "pipeline/gpu/interrupt.hpp"

namespace caustics::raster {

FlushDenormals::FlushDenormals() {
#if defined(__SSE2__)
  saved_ = _mm_getcsr();
  // Flush-to-zero and denormals-are-zero set, rounding to nearest even, all exceptions masked.
  _mm_setcsr((static_cast<unsigned>(saved_) & ~0x6000u) | 0x8040u | 0x1f80u);
#elif defined(__aarch64__)
  asm volatile("mrs %0, fpcr" : "=r"(saved_));
  // FZ, bit 24, flushes operands and results; the rounding mode is in bits 22 and 23, FEAT_FP16's flushing in
  // bit 19.
  asm volatile("msr fpcr, %0" : : "r"((saved_ & ~0xc80000ull) | 0x1000000ull) : "memory");
#endif
}

FlushDenormals::~FlushDenormals() {
#if defined(__SSE2__)
  _mm_setcsr(static_cast<unsigned>(saved_));
#elif defined(__aarch64__)
  asm volatile("msr fpcr, %0" : : "r"(saved_) : "memory");
#endif
}

#if CAUSTICS_HAS_TBB

// Asks for as many threads as were wished even where the machine has fewer cores.
struct Workers::Arena {
  explicit Arena(int threads)
      : control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)),
        arena(threads) {}
  tbb::global_control control;
  tbb::task_arena arena;
};

Workers::Workers(int threads)
    : threads_(threads > 0 ? threads : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()))),
      arena_(std::make_unique<Arena>(threads_)) {}

void Workers::run(int count, const std::function<void(int)>& task) const {
  // Each thread takes the next number, so that a caller who sorts by cost gets the longest first.
  std::atomic<int> next{0};
  char start = 0, end = 0;
  const auto work = [&](int) {
    happens_after(&start);
    const FlushDenormals mode;
    for (int i = next++; i < count; i = next++) {
      stop_if_interrupted();
      task(i);
    }
    happens_before(&end);
  };
  const int threads = std::min(threads_, count);
  if (threads <= 1) {
    work(0);
    return;
  }
  happens_before(&start);
  arena_->arena.execute([&] { tbb::parallel_for(0, threads, work, tbb::simple_partitioner()); });
  happens_after(&end);
}

#else

struct Workers::Arena {};

Workers::Workers(int) {}

void Workers::run(int count, const std::function<void(int)>& task) const {
  const FlushDenormals mode;
  for (int i = 0; i < count; ++i) {
    stop_if_interrupted();
    task(i);
  }
}

#endif

Workers::~Workers() = default;

}  // namespace caustics::raster
