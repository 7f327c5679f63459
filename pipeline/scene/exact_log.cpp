#include "pipeline/scene/exact.hpp"

namespace caustics::exact {

double log(double x) {
  int exponent = 0;
  double m = std::frexp(x, &exponent);  // exact: m in [1/2, 1)
  if (m < 0.70710678118654752440) {
    m *= 2.0;
    --exponent;
  }
  // ln m = 2 artanh((m - 1) / (m + 1)); |s| < 0.172, so the term after s^21 is below 1e-18.
  const double s = (m - 1.0) / (m + 1.0);
  const double z = s * s;
  double sum = 1.0 / 21.0;
  for (int n = 19; n >= 1; n -= 2) sum = sum * z + 1.0 / static_cast<double>(n);
  return 2.0 * s * sum + static_cast<double>(exponent) * 0.69314718055994530942;
}

}  // namespace caustics::exact
