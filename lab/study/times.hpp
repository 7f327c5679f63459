// What frames took, in a few figures.
#pragma once
#include <vector>

namespace caustics::study {

// Milliseconds of several frames. All 0 where there was none.
struct Times {
  double median = 0.0, least = 0.0, most = 0.0;
  double deviation = 0.0;  // the median of how far the times are from their median
};
// The median is the middle one of an odd number, the mean of the middle two of an even one.
Times times_of(std::vector<double> milliseconds);

}  // namespace caustics::study
