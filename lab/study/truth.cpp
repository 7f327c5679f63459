#include "lab/study/truth.hpp"

#include <algorithm>
#include <cmath>

#include "lab/metrics/image_metrics.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/text.hpp"

namespace caustics::study {

namespace {

void refuse_non_finite(const Image& image, const std::string& name, const std::string& what) {
  if (count_non_finite(image) > 0)
    throw Error(ExitCode::BadInput, one_line(name) + ": its " + what + " has values that are not finite");
}

template <class Use>
void for_each_selected(const Image& image, const Mask& mask, const Use& use) {
  std::size_t pixel = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x, ++pixel)
      if (mask.empty() || mask[pixel] != 0) use(x, y);
}

double sum_of(const Image& image, const Mask& mask) {
  double sum = 0.0;
  for_each_selected(image, mask, [&](int x, int y) {
    for (int c = 0; c < 3; ++c) sum += std::fabs(static_cast<double>(image.at(x, y, c)));
  });
  return sum;
}

}  // namespace

double white_of(const Image& image, const Mask& mask) {
  std::vector<double> lit;
  for_each_selected(image, mask, [&](int x, int y) {
    const float most = std::max({image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)});
    if (most > 0.0f) lit.push_back(static_cast<double>(most));
  });
  if (lit.empty()) return 0.0;
  const auto at = lit.begin() + static_cast<std::ptrdiff_t>((lit.size() - 1) - (lit.size() - 1) / 100);
  std::nth_element(lit.begin(), at, lit.end());
  return *at;
}

Truth make_truth(Image caustic, Mask mask, const std::string& name) {
  Truth truth{.caustic = std::move(caustic), .mask = std::move(mask)};
  refuse_non_finite(truth.caustic, name, "caustic");
  truth.white = white_of(truth.caustic, truth.mask);
  if (!(truth.white > 0.0))
    throw Error(ExitCode::BadInput,
                one_line(name) +
                    ": its caustic is black where it is looked at, so no error can be measured; "
                    "'caustics plan' says why a scene has none, --camera and --mask where to look");
  return truth;
}

void set_noise(Truth& truth, const Image& error, const std::string& name) {
  refuse_non_finite(error, name, "layer caustic_error");
  truth.noise = sum_of(error, truth.mask) / sum_of(truth.caustic, truth.mask);
}

Figures measure_against(const Truth& truth, const Image& caustic) {
  const ImageMetrics metrics = image_metrics(caustic, truth.caustic, truth.mask);
  return {.relative_l1 = metrics.relative_l1,
          .rmse = metrics.rmse,
          .flux_ratio = metrics.flux_ratio,
          .relative_mse_1 = metrics.relative_mse[0],
          .relative_mse_4 = metrics.relative_mse[1],
          .relative_mse_16 = metrics.relative_mse[2]};
}

}  // namespace caustics::study
