#include "pipeline/gpu/difference.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace caustics {

namespace {

// Floats in their order as integers: the sign-and-magnitude bits as a signed distance from 0.
std::int64_t rank(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  const auto magnitude = static_cast<std::int64_t>(bits & 0x7fffffffu);
  return (bits >> 31) != 0 ? -magnitude : magnitude;
}

// Of `count` values of which those in `others` are not 0 and the rest are.
template <typename Value>
Spread spread_of(std::vector<Value> others, std::size_t count) {
  Spread spread;
  if (others.empty()) return spread;
  double sum = 0.0;
  for (const Value value : others) sum += static_cast<double>(value);
  spread.mean = sum / static_cast<double>(count);
  spread.largest = static_cast<double>(*std::max_element(others.begin(), others.end()));
  // ceil(count * 0.999), in integers; the index of that rank from 0.
  const std::size_t at = count - count / 1000 - 1, zeros = count - others.size();
  if (at < zeros) return spread;
  const auto nth = others.begin() + static_cast<std::ptrdiff_t>(at - zeros);
  std::nth_element(others.begin(), nth, others.end());
  spread.p999 = static_cast<double>(*nth);
  return spread;
}

bool texel_is(const Image& image, int x, int y, const std::array<float, 4>& value) {
  for (int c = 0; c < image.channels(); ++c) {
    if (!same_value(image.at(x, y, c), value[static_cast<std::size_t>(c)])) return false;
  }
  return true;
}

// 1/255 and half a step of rounding.
bool beyond_a_step(float a, float b) { return std::abs(a - b) > 1.5f / 255.0f; }

// The channels of one texel into the counters; true where one differs.
bool add_texel(const Image& a, const Image& b, int x, int y, DifferenceCounter& all,
               std::vector<DifferenceCounter>& channels) {
  bool differs = false;
  for (int c = 0; c < a.channels(); ++c) {
    const ValuePair pair{x, y, c, a.at(x, y, c), b.at(x, y, c)};
    all.add(pair);
    channels[static_cast<std::size_t>(c)].add(pair);
    differs = differs || !same_value(pair.a, pair.b);
  }
  return differs;
}

// The largest finite magnitude in an image.
float scale_of(const Image& image) {
  float largest = 0.0f;
  for (const float value : image.values)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  return largest;
}

// The sums of one texel, what covers it, and whether it jumps in images of this scale.
void add_to_sums(const Image& a, const Image& b, int x, int y, const std::array<float, 4>& background,
                 float scale, ImageDifference& result) {
  const bool in_a = !texel_is(a, x, y, background), in_b = !texel_is(b, x, y, background);
  result.covered += in_a;
  result.coverage_mismatches += in_a != in_b;
  float largest = 0.0f, apart = 0.0f;
  for (int c = 0; c < a.channels(); ++c) {
    const float of_a = a.at(x, y, c), of_b = b.at(x, y, c);
    largest = std::max({largest, std::abs(of_a), std::abs(of_b)});
    apart = std::max(apart, std::abs(of_a - of_b));
    result.sums.add(of_a, of_b);
    result.beyond_a_step += beyond_a_step(of_a, of_b);
  }
  const bool jumps = apart > 0.01f * largest && apart > 1e-6f * scale;
  result.jumps += jumps;
  if (jumps || !in_a || !in_b) return;
  for (int c = 0; c < a.channels(); ++c) result.steady.add(a.at(x, y, c), b.at(x, y, c));
}

}  // namespace

std::uint32_t ulps_between(float a, float b) {
  const std::int64_t distance = rank(a) - rank(b);
  return static_cast<std::uint32_t>(distance < 0 ? -distance : distance);
}

bool same_value(float a, float b) { return a == b || (std::isnan(a) && std::isnan(b)); }

void DifferenceCounter::add(const ValuePair& pair) {
  ++sum_.values;
  const bool same = same_value(pair.a, pair.b);
  if (!same) {
    ++sum_.differing;
    if (!sum_.first) sum_.first = pair;
  }
  if (std::isnan(pair.a) || std::isnan(pair.b) || (!same && (std::isinf(pair.a) || std::isinf(pair.b)))) {
    add_non_finite(pair);
  } else if (!same) {
    add_finite(pair);
  }
}

void DifferenceCounter::add_non_finite(const ValuePair& pair) {
  const bool nan_a = std::isnan(pair.a), nan_b = std::isnan(pair.b);
  sum_.nan_both += nan_a && nan_b;
  sum_.nan_only_a += nan_a && !nan_b;
  sum_.nan_only_b += nan_b && !nan_a;
  sum_.infinite += !nan_a && !nan_b;
  sum_.beyond_tolerance += !(nan_a && nan_b);
  if (!worst_is_non_finite_) sum_.worst = pair;
  worst_is_non_finite_ = true;
}

void DifferenceCounter::add_finite(const ValuePair& pair) {
  const double a = pair.a, b = pair.b;
  const double absolute = std::abs(a - b);
  // Not 0: the values differ, so one of them is not 0.
  const double magnitude = std::max(std::abs(a), std::abs(b));
  if (absolute > tolerance_.absolute && absolute > tolerance_.relative * magnitude) {
    ++sum_.beyond_tolerance;
  }
  if (!worst_is_non_finite_ && (!sum_.worst || absolute > sum_.absolute.largest)) {
    sum_.worst = pair;
  }
  sum_.absolute.largest = std::max(sum_.absolute.largest, absolute);
  absolute_.push_back(absolute);
  relative_.push_back(absolute / magnitude);
  ulps_.push_back(ulps_between(pair.a, pair.b));
}

ValueDifference DifferenceCounter::result() const {
  ValueDifference result = sum_;
  const std::size_t finite = sum_.values - sum_.nan_only_a - sum_.nan_only_b - sum_.nan_both - sum_.infinite;
  result.absolute = spread_of(absolute_, finite);
  result.relative = spread_of(relative_, finite);
  result.ulps = spread_of(ulps_, finite);
  return result;
}

ValueDifference difference(const ChannelView& a, const ChannelView& b, const Tolerance& tolerance) {
  DifferenceCounter counter(tolerance);
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) counter.add({x, y, 0, a.at(x, y), b.at(x, y)});
  }
  return counter.result();
}

void DifferenceSums::add(float of_a, float of_b) {
  if (!std::isfinite(of_a) || !std::isfinite(of_b)) return;
  const double x = of_a, y = of_b;
  a += x;
  b += y;
  magnitude += std::abs(x);
  difference += std::abs(x - y);
}

double DifferenceSums::relative() const { return difference == 0.0 ? 0.0 : difference / magnitude; }
double DifferenceSums::relative_total() const { return a == b ? 0.0 : std::abs(a - b) / magnitude; }

ImageDifference difference(const Image& a, const Image& b, const Tolerance& tolerance,
                           const std::array<float, 4>& background) {
  ImageDifference result;
  result.same_shape = a.shape == b.shape;
  if (!result.same_shape) return result;
  const float scale = scale_of(a) > 0.0f ? std::max(scale_of(a), scale_of(b)) : 1.0f;
  DifferenceCounter all(tolerance);
  std::vector<DifferenceCounter> channels(static_cast<std::size_t>(a.channels()), all);
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      ++result.texels;
      add_to_sums(a, b, x, y, background, scale, result);
      if (!add_texel(a, b, x, y, all, channels)) continue;
      if (result.differing_texels++ == 0) {
        for (int c = 0; c < a.channels(); ++c) {
          result.first_a[static_cast<std::size_t>(c)] = a.at(x, y, c);
          result.first_b[static_cast<std::size_t>(c)] = b.at(x, y, c);
        }
      }
    }
  }
  result.all = all.result();
  for (const DifferenceCounter& channel : channels) result.channels.push_back(channel.result());
  return result;
}

}  // namespace caustics
