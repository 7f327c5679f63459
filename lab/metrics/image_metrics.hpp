// By how much a tested picture A misses a truth B, in figures that each answer another question.
//
// Over the N selected values a, b, all channels that are given together:
//   relative_l1   sum |a - b| / sum |b|
//   rmse          sqrt(sum (a - b)^2 / N)
//   relative_mse  for boxes of 1, 4 and 16 texels a side, which begin at the top left corner: both
//                 images are averaged over each box's selected texels, then the mean over the
//                 boxes, each weighted by its number of selected texels, of (A - B)^2 / (B^2 +
//                 eps), where eps = (0.01 * mean |b|)^2, the same for all boxes. How it falls from
//                 1 to 16 tells a shift of few texels (falls) from a wrong amount of light (stays).
//   clipped       the same of min(a, clip) and min(b, clip); eps from these b. `clip` is the 99.9th
//                 percentile (nearest rank) of the values b > 0: of those alone, since black around
//                 a caustic must not move it.
//   flux_ratio    sum a / sum b
//   flux_error    |sum a - sum b| / |sum b|
//   psnr          20 log10(max b / rmse), decibel
// Sums are of doubles, row by row from the top, channel after channel.
//
// A figure that does not exist is none, never a NaN or an infinity: all of them where a selected
// value of either image is not finite, or nothing is selected; relative figures where the truth is
// 0 and the tested picture is not (both 0: relative_l1, relative_mse and flux_error are 0);
// flux_ratio where sum b is 0; psnr where the images are equal or no value of B is above 0.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pipeline/gpu/difference.hpp"

namespace caustics {

// Side of the boxes of relative_mse, in texels.
inline constexpr std::array<int, 3> kMetricBoxes = {1, 4, 16};

struct ImageMetrics {
  std::size_t values = 0;      // pairs measured
  std::size_t non_finite = 0;  // of these with a NaN or an infinity
  std::optional<double> relative_l1, rmse;
  std::array<std::optional<double>, 3> relative_mse, clipped;  // by kMetricBoxes
  std::optional<double> clip;  // none where no value of B is above 0: nothing is clipped then
  std::optional<double> flux_ratio, flux_error, psnr;
};

// One channel of both images. Row 0 is the top.
struct PlanePair {
  ChannelView a, b;
};

// All pairs have one size. `mask` has a value for each texel, row by row from the top, and selects
// those that are not 0; empty, it selects all.
ImageMetrics image_metrics(std::span<const PlanePair> planes, std::span<const std::uint8_t> mask = {});

// Of the red, green and blue channels of two images of one shape; an image of fewer has those. Rows
// of `mask` run as those of the images, from the bottom. The figures are those of the images'
// files.
ImageMetrics image_metrics(const Image& a, const Image& b, std::span<const std::uint8_t> mask = {});

// A figure and its name: "relative_l1", "rmse", "relative_mse_1", "relative_mse_4",
// "relative_mse_16", "clipped_relative_mse_1", ..., "flux_ratio", "flux_error", "psnr".
struct NamedMetric {
  std::string name;
  std::optional<double> value;
  bool grows_with_error = true;  // not flux_ratio, not psnr
};
std::vector<NamedMetric> named_metrics(const ImageMetrics& metrics);

}  // namespace caustics
