#include "lab/study/times.hpp"

#include <algorithm>
#include <cmath>

namespace caustics::study {

namespace {

double middle_of(std::vector<double>& values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

}  // namespace

Times times_of(std::vector<double> values) {
  if (values.empty()) return {};
  Times times{.median = middle_of(values), .least = values.front(), .most = values.back()};
  for (double& value : values) value = std::fabs(value - times.median);
  times.deviation = middle_of(values);
  return times;
}

}  // namespace caustics::study
