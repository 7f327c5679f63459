// Numbers spread over 0..1 more evenly than chance would, the same in every run.
#pragma once

namespace caustics {

// 1 / g with g^2 = g + 1: by itself, or beside the strata, the most even step (the golden angle).
inline constexpr double kGoldenStep = 0.61803398874989485;
// 1 / p and 1 / p^2 with p^3 = p + 1: the same for pairs (Roberts' R2 sequence).
inline constexpr double kPairStep1 = 0.75487766624669276, kPairStep2 = 0.56984029099805327;

// The middle of the k-th of `count` equal parts.
inline double stratum(int k, int count) { return (k + 0.5) / count; }

// The k-th of a sequence that goes around 0..1 in steps.
inline double stepped(int k, double step) {
  const double x = 0.5 + k * step;
  return x - static_cast<double>(static_cast<long long>(x));
}

}  // namespace caustics
