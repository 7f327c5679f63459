#include <cmath>
#include <limits>

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

double exp(double x) {
  if (x < -700.0) return 0.0;
  if (x > 709.0) return std::numeric_limits<double>::infinity();
  // x = k ln 2 + r with |r| <= 0.35, ln 2 in two parts so that k times the first is exact.
  const double k = std::floor(x * 1.44269504088896340736 + 0.5);
  const double r = (x - k * 0.693147180369123816490) - k * 1.90821492927058770002e-10;
  double sum = 1.0;
  for (int n = 14; n >= 1; --n) sum = 1.0 + sum * r / n;
  return std::ldexp(sum, static_cast<int>(k));
}

}  // namespace caustics::exact
