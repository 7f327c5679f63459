#include "lab/study/pareto.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace caustics::study {

std::vector<std::size_t> pareto_front(const std::vector<std::optional<Cost>>& costs, double worthwhile) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    if (costs[i] && std::isfinite(costs[i]->error) && std::isfinite(costs[i]->milliseconds))
      order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (costs[a]->milliseconds != costs[b]->milliseconds)
      return costs[a]->milliseconds < costs[b]->milliseconds;
    return costs[a]->error < costs[b]->error;
  });
  // From the quickest on, whatever lowers the error enough.
  double below = std::numeric_limits<double>::infinity();
  std::erase_if(order, [&](std::size_t i) {
    if (!(costs[i]->error < below)) return true;
    below = costs[i]->error * (1.0 - worthwhile);
    return false;
  });
  return order;
}

}  // namespace caustics::study
