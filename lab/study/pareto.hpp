// The choices that nothing beats in both error and time.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

namespace caustics::study {

struct Cost {
  double error = 0.0, milliseconds = 0.0;
};

// Indices from the quickest to the most accurate: those for which no other is at least as good in
// both and better in one; of equal costs the first. A slower one must also be worth it: its error is
// smaller than that of the one before it by more than the share `worthwhile` (0: by anything).
// Without a cost, or with one that is not finite, a choice takes no part.
std::vector<std::size_t> pareto_front(const std::vector<std::optional<Cost>>& costs, double worthwhile = 0.0);

}  // namespace caustics::study
