#include "app/machine_limits.hpp"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "pipeline/gpu/stopwatch.hpp"

namespace caustics::app {

namespace {

constexpr int kRounds = 5;

// Of each of the three arrays: together four times the last-level cache, within bounds.
std::size_t values_an_array() {
  const long cache = sysconf(_SC_LEVEL3_CACHE_SIZE);  // 0 or -1 where it is not known
  const long bytes = std::clamp(4 * std::max(cache, 0L), 192L << 20, 1L << 30);
  return static_cast<std::size_t>(bytes) / (3 * sizeof(double));
}

// Calls work(first, end) for parts of 0 .. count, a thread each.
void in_parts(int threads, std::size_t count, const std::function<void(std::size_t, std::size_t)>& work) {
  const auto parts = static_cast<std::size_t>(threads);
  std::vector<std::thread> others;
  for (std::size_t i = 1; i < parts; ++i)
    others.emplace_back(work, count * i / parts, count * (i + 1) / parts);
  work(0, count / parts);
  for (std::thread& other : others) other.join();
}

// Independent chains of products and sums, enough to hide what each waits for, by name: an array's would lie
// in memory.
constexpr int kChains = 10, kSteps = 200'000;

template <class Vector>
[[gnu::always_inline]] inline float chains() {
  Vector factor = Vector{} + 0.5f, term = Vector{} + 1.0f;
  // Each starts elsewhere: equal ones would be worked out once.
  Vector a = term, b = a + term, c = b + term, d = c + term, e = d + term, f = e + term, g = f + term,
         h = g + term, i = h + term, j = i + term;
  for (int step = 0; step < kSteps; ++step) {
    // Not known to the compiler.
    __asm__ volatile("" : "+m"(factor), "+m"(term));
    const Vector by = factor, plus = term;
    a = a * by + plus;
    b = b * by + plus;
    c = c * by + plus;
    d = d * by + plus;
    e = e * by + plus;
    f = f * by + plus;
    g = g * by + plus;
    h = h * by + plus;
    i = i * by + plus;
    j = j * by + plus;
  }
  return a[0] + b[0] + c[0] + d[0] + e[0] + f[0] + g[0] + h[0] + i[0] + j[0];
}

using Four = float __attribute__((vector_size(16)));
float four_wide() { return chains<Four>(); }
#if defined(__x86_64__)
using Eight = float __attribute__((vector_size(32)));
using Sixteen = float __attribute__((vector_size(64)));
[[gnu::target("avx2")]] float eight_wide() { return chains<Eight>(); }
[[gnu::target("avx512f")]] float sixteen_wide() { return chains<Sixteen>(); }
#endif

struct Width {
  int lanes;
  float (*work)();
};

Width widest() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f")) return {16, sixteen_wide};
  if (__builtin_cpu_supports("avx2")) return {8, eight_wide};
#endif
  return {4, four_wide};
}

}  // namespace

double arithmetic_peak(int threads) {
  const Width width = widest();
  double best = 0.0;
  for (int round = 0; round < kRounds; ++round) {
    std::atomic<bool> sound = true;
    const Stopwatch watch;
    // Each value ends at the sum of 1, 1/2, 1/4 ...: 2.
    in_parts(threads, static_cast<std::size_t>(threads),
             [&](std::size_t, std::size_t) { sound = sound && width.work() == 2.0f * kChains; });
    const double operations = 2.0 * kChains * kSteps * width.lanes * threads;
    best = std::max(best, 1e3 * operations / watch.milliseconds());
    if (!sound) return 0.0;
  }
  return best;
}

double memory_bandwidth(int threads) {
  const std::size_t count = values_an_array();
  const auto array = [&] { return std::unique_ptr<double[]>(new double[count]); };
  const auto a = array(), b = array(), c = array();
  in_parts(threads, count, [&](std::size_t first, std::size_t end) {
    std::fill(a.get() + first, a.get() + end, 0.0);
    std::fill(b.get() + first, b.get() + end, 1.0);
    std::fill(c.get() + first, c.get() + end, 2.0);
  });
  double best = 0.0;
  for (int round = 0; round < kRounds; ++round) {
    const double factor = 1.0 + round;
    const Stopwatch watch;
    in_parts(threads, count, [&](std::size_t first, std::size_t end) {
      double* const sum = a.get();
      const double *const x = b.get(), *const y = c.get();
      for (std::size_t i = first; i < end; ++i) sum[i] = x[i] + factor * y[i];
    });
    const double bytes = 3.0 * sizeof(double) * static_cast<double>(count);
    best = std::max(best, 1e3 * bytes / watch.milliseconds());
    // Looked at, so that no round can be left out.
    if (a[count / 2] != 1.0 + 2.0 * factor) return 0.0;
  }
  return best;
}

}  // namespace caustics::app
