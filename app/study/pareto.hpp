// The choices that nothing beats in both error and time.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

namespace caustics::app {

struct Cost {
  double error = 0.0, milliseconds = 0.0;
};

// Indices from the quickest to the most accurate: those for which no other is at least as good in
// both and better in one. Of equal costs the first. Without a cost, or with one that is not finite,
// a choice takes no part.
std::vector<std::size_t> pareto_front(const std::vector<std::optional<Cost>>& costs);

}  // namespace caustics::app
