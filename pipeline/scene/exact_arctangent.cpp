#include "pipeline/scene/exact.hpp"

namespace caustics::exact {

double arctangent(double x) {
  if (x < 0) return -arctangent(-x);
  if (x > 1) return kPi / 2 - arctangent(1 / x);
  // atan x = 2 atan(x / (1 + sqrt(1 + x^2))): twice, which leaves at most tan(pi / 16) = 0.199.
  for (int i = 0; i < 2; ++i) x = x / (1 + std::sqrt(1 + x * x));
  const double x2 = x * x;
  // x - x^3/3 + x^5/5 - ...; the first term left out is below 1e-18 of the sum.
  double sum = 0;
  for (int k = 25; k >= 1; k -= 2) sum = 1.0 / k - x2 * sum;
  return 4 * x * sum;
}

}  // namespace caustics::exact
