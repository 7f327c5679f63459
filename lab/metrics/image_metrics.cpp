#include "lab/metrics/image_metrics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace caustics {

namespace {

using Mask = std::span<const std::uint8_t>;

// Calls use(a, b) for the selected values of one channel within a rectangle of texels.
template <typename Use>
void each_value(const PlanePair& plane, Mask mask, int left, int top, int right, int bottom, const Use& use) {
  const auto width = static_cast<std::size_t>(plane.a.width);
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) {
      const std::size_t texel = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
      if (!mask.empty() && mask[texel] == 0) continue;
      use(static_cast<double>(plane.a.at(x, y)), static_cast<double>(plane.b.at(x, y)));
    }
  }
}

template <typename Use>
void each_value(std::span<const PlanePair> planes, Mask mask, const Use& use) {
  for (const PlanePair& plane : planes) {
    each_value(plane, mask, 0, 0, plane.a.width, plane.a.height, use);
  }
}

struct Sums {
  std::size_t values = 0, non_finite = 0;
  double a = 0.0, b = 0.0, absolute_b = 0.0;
  double absolute_difference = 0.0, squared_difference = 0.0;
  double largest_b = -std::numeric_limits<double>::infinity();
};

// `most`: larger values count as this.
Sums sum_up(std::span<const PlanePair> planes, Mask mask, double most) {
  Sums sums;
  each_value(planes, mask, [&](double in_a, double in_b) {
    ++sums.values;
    if (!std::isfinite(in_a) || !std::isfinite(in_b)) {
      ++sums.non_finite;
      return;
    }
    const double a = std::min(in_a, most), b = std::min(in_b, most);
    sums.a += a;
    sums.b += b;
    sums.absolute_b += std::abs(b);
    sums.absolute_difference += std::abs(a - b);
    sums.squared_difference += (a - b) * (a - b);
    sums.largest_b = std::max(sums.largest_b, b);
  });
  return sums;
}

// The 99.9th percentile of the values of B above 0.
std::optional<double> clip_of(std::span<const PlanePair> planes, Mask mask) {
  std::vector<float> lit;
  each_value(planes, mask, [&](double, double b) {
    if (b > 0.0) lit.push_back(static_cast<float>(b));
  });
  if (lit.empty()) return std::nullopt;
  // ceil(count * 0.999), in integers; the index of that rank from 0.
  const std::size_t at = lit.size() - lit.size() / 1000 - 1;
  const auto nth = lit.begin() + static_cast<std::ptrdiff_t>(at);
  std::nth_element(lit.begin(), nth, lit.end());
  return static_cast<double>(*nth);
}

// Box by box of one channel: the squared error of the means over B's, times the box's texels.
double box_errors(const PlanePair& plane, Mask mask, int side, double eps, double most) {
  double sum = 0.0;
  for (int top = 0; top < plane.a.height; top += side) {
    for (int left = 0; left < plane.a.width; left += side) {
      const int right = std::min(left + side, plane.a.width);
      const int bottom = std::min(top + side, plane.a.height);
      double a = 0.0, b = 0.0, count = 0.0;
      each_value(plane, mask, left, top, right, bottom, [&](double in_a, double in_b) {
        a += std::min(in_a, most);
        b += std::min(in_b, most);
        count += 1.0;
      });
      if (count == 0.0) continue;
      const double difference = (a - b) / count, truth = b / count;
      sum += count * (difference * difference / (truth * truth + eps));
    }
  }
  return sum;
}

std::array<std::optional<double>, 3> relative_mse(std::span<const PlanePair> planes, Mask mask, double most) {
  std::array<std::optional<double>, 3> result;
  const Sums sums = sum_up(planes, mask, most);
  const auto count = static_cast<double>(sums.values);
  if (sums.absolute_b == 0.0) {
    if (sums.absolute_difference == 0.0) result.fill(0.0);
    return result;
  }
  const double floor = 0.01 * (sums.absolute_b / count);
  for (std::size_t i = 0; i < kMetricBoxes.size(); ++i) {
    double sum = 0.0;
    for (const PlanePair& plane : planes) {
      sum += box_errors(plane, mask, kMetricBoxes[i], floor * floor, most);
    }
    result[i] = sum / count;
  }
  return result;
}

// None for what is infinite; nothing divided by nothing is 0.
std::optional<double> ratio(double error, double truth) {
  if (truth != 0.0) return error / truth;
  return error == 0.0 ? std::optional<double>(0.0) : std::nullopt;
}

// The channels of an image from the top, as its files hold them.
std::vector<std::vector<float>> planes_of(const Image& image) {
  std::vector<std::vector<float>> planes(static_cast<std::size_t>(std::min(image.channels(), 3)));
  for (std::size_t c = 0; c < planes.size(); ++c) {
    for (int y = image.height() - 1; y >= 0; --y) {
      for (int x = 0; x < image.width(); ++x) {
        planes[c].push_back(image.at(x, y, static_cast<int>(c)));
      }
    }
  }
  return planes;
}

std::vector<std::uint8_t> turned_over(Mask mask, int width) {
  std::vector<std::uint8_t> result;
  const auto row = static_cast<std::size_t>(width);
  for (std::size_t end = mask.size(); end >= row && end > 0; end -= row) {
    const auto first = mask.begin() + static_cast<std::ptrdiff_t>(end - row);
    result.insert(result.end(), first, first + static_cast<std::ptrdiff_t>(row));
  }
  return result;
}

}  // namespace

ImageMetrics image_metrics(std::span<const PlanePair> planes, Mask mask) {
  constexpr double kUnclipped = std::numeric_limits<double>::infinity();
  ImageMetrics metrics;
  const Sums sums = sum_up(planes, mask, kUnclipped);
  metrics.values = sums.values;
  metrics.non_finite = sums.non_finite;
  if (sums.values == 0 || sums.non_finite > 0) return metrics;
  metrics.relative_l1 = ratio(sums.absolute_difference, sums.absolute_b);
  metrics.rmse = std::sqrt(sums.squared_difference / static_cast<double>(sums.values));
  metrics.relative_mse = relative_mse(planes, mask, kUnclipped);
  metrics.clip = clip_of(planes, mask);
  metrics.clipped = metrics.clip ? relative_mse(planes, mask, *metrics.clip) : metrics.relative_mse;
  if (sums.b != 0.0) metrics.flux_ratio = sums.a / sums.b;
  metrics.flux_error = ratio(std::abs(sums.a - sums.b), std::abs(sums.b));
  if (*metrics.rmse > 0.0 && sums.largest_b > 0.0) {
    metrics.psnr = 20.0 * std::log10(sums.largest_b / *metrics.rmse);
  }
  return metrics;
}

ImageMetrics image_metrics(const Image& a, const Image& b, Mask mask) {
  const std::vector<std::vector<float>> of_a = planes_of(a), of_b = planes_of(b);
  std::vector<PlanePair> pairs;
  for (std::size_t c = 0; c < of_a.size(); ++c) {
    pairs.push_back({{of_a[c].data(), 1, a.width(), a.height()}, {of_b[c].data(), 1, b.width(), b.height()}});
  }
  return image_metrics(pairs, turned_over(mask, a.width()));
}

std::vector<NamedMetric> named_metrics(const ImageMetrics& metrics) {
  std::vector<NamedMetric> list = {{"relative_l1", metrics.relative_l1}, {"rmse", metrics.rmse}};
  for (std::size_t i = 0; i < kMetricBoxes.size(); ++i) {
    list.push_back({"relative_mse_" + std::to_string(kMetricBoxes[i]), metrics.relative_mse[i]});
  }
  for (std::size_t i = 0; i < kMetricBoxes.size(); ++i) {
    list.push_back({"clipped_relative_mse_" + std::to_string(kMetricBoxes[i]), metrics.clipped[i]});
  }
  list.push_back({"flux_ratio", metrics.flux_ratio, false});
  list.push_back({"flux_error", metrics.flux_error});
  list.push_back({"psnr", metrics.psnr, false});
  return list;
}

}  // namespace caustics
