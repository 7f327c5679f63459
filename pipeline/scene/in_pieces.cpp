#include "pipeline/scene/in_pieces.hpp"

#include <algorithm>
#include <optional>

#if CAUSTICS_HAS_TBB
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#endif

#include "pipeline/gpu/happens_before.hpp"
#include "pipeline/gpu/interrupt.hpp"

namespace caustics {

namespace {

void one_by_one(int pieces, const std::function<void(int)>& work) {
  const PlainFloats plain;
  for (int piece = 0; piece < pieces; ++piece) {
    stop_if_interrupted();
    work(piece);
  }
}

}  // namespace

#if CAUSTICS_HAS_TBB

void in_pieces(int pieces, int threads, const std::function<void(int)>& work) {
  if (pieces <= 1 || threads == 1) return one_by_one(pieces, work);
  char started = 0, ended = 0;
  const auto run = [&] {
    oneapi::tbb::parallel_for(
        0, pieces,
        [&](int piece) {
          stop_if_interrupted();
          happens_after(&started);
          {
            const PlainFloats plain;
            work(piece);
          }
          happens_before(&ended);
        },
        oneapi::tbb::simple_partitioner());
    happens_after(&ended);
  };
  happens_before(&started);
  // As many threads as were wished, even where the machine has fewer cores.
  std::optional<oneapi::tbb::global_control> control;
  if (threads > 0)
    control.emplace(oneapi::tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  oneapi::tbb::task_arena arena(threads > 0 ? threads : oneapi::tbb::task_arena::automatic);
  arena.execute(run);
}

#else

void in_pieces(int pieces, int, const std::function<void(int)>& work) { one_by_one(pieces, work); }

#endif

void in_runs(std::size_t count, int threads,
             const std::function<void(std::size_t first, std::size_t end)>& work) {
  constexpr std::size_t kRun = 8192;
  in_pieces(static_cast<int>((count + kRun - 1) / kRun), threads, [&](int run) {
    const std::size_t first = static_cast<std::size_t>(run) * kRun;
    work(first, std::min(first + kRun, count));
  });
}

}  // namespace caustics
