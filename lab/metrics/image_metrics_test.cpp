#include "lab/metrics/image_metrics.hpp"

#include <cmath>
#include <limits>

#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

using Values = std::vector<float>;

// One channel, rows of `width` values from the top.
ImageMetrics measured(const Values& a, const Values& b, int width,
                      const std::vector<std::uint8_t>& mask = {}) {
  const int height = static_cast<int>(a.size()) / width;
  const PlanePair pair{{a.data(), 1, width, height}, {b.data(), 1, width, height}};
  return image_metrics({&pair, 1}, mask);
}

}  // namespace

TEST_CASE("image metrics: sums and squares of four values") {
  // Differences 0, 1, -1, 2; b sums to 10, a to 12.
  const ImageMetrics m = measured({1, 3, 2, 6}, {1, 2, 3, 4}, 2);
  CHECK(m.values == 4);
  CHECK(m.non_finite == 0);
  CHECK(m.relative_l1.value() == Approx(4.0 / 10.0));
  CHECK(m.rmse.value() == Approx(std::sqrt(6.0 / 4.0)));
  CHECK(m.flux_ratio.value() == Approx(1.2));
  CHECK(m.flux_error.value() == Approx(0.2));
  // 10 log10(16 / 1.5).
  CHECK(m.psnr.value() == Approx(10.2803).epsilon(1e-5));
}

TEST_CASE("image metrics: relative squared error over boxes of 1 and 4 texels") {
  // The mean of |b| is 2.5, so eps is 0.025^2 = 0.000625.
  const ImageMetrics m = measured({1, 3, 2, 6}, {1, 2, 3, 4}, 2);
  CHECK(m.relative_mse[0].value() == Approx((1.0 / 4.000625 + 1.0 / 9.000625 + 4.0 / 16.000625) / 4.0));
  // One box, cut by the border: means 3 and 2.5.
  CHECK(m.relative_mse[1].value() == Approx(0.25 / 6.250625));
  CHECK(m.relative_mse[2] == m.relative_mse[1]);
}

TEST_CASE("image metrics: a shift within a box is an error of single texels alone") {
  const ImageMetrics m = measured({0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0},
                                  {1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, 4);
  CHECK(m.relative_l1.value() == Approx(2.0));
  const double eps = (0.01 / 16.0) * (0.01 / 16.0);
  CHECK(m.relative_mse[0].value() == Approx((1.0 / (1.0 + eps) + 1.0 / eps) / 16.0));
  CHECK(m.relative_mse[1].value() == 0.0);
  CHECK(m.flux_error.value() == 0.0);
}

TEST_CASE("image metrics: boxes begin at the top left and count by their texels") {
  // 6 texels a row: a box of 4, off by 1 of 2, and one of 2, equal. eps = 0.02^2.
  const ImageMetrics m = measured({3, 3, 3, 3, 2, 2}, {2, 2, 2, 2, 2, 2}, 6);
  CHECK(m.relative_mse[1].value() == Approx(4.0 / 6.0 * (1.0 / 4.0004)));
}

TEST_CASE("image metrics: clipped figures leave the topmost thousandth of lit texels out") {
  // 2000 values of 1 beside black, of which 2 are 1000; ceil(0.999 * 2000) = 1998, the last 1.
  Values a(4000, 0.0f), b(4000, 0.0f);
  for (std::size_t i = 0; i < 2000; ++i) a[i] = b[i] = 1.0f;
  b[0] = b[1] = 1000.0f;
  a[0] = 500.0f;
  const ImageMetrics m = measured(a, b, 40);
  CHECK(m.clip.value() == 1.0);
  CHECK(m.clipped[0].value() == 0.0);
  CHECK(m.relative_mse[0].value() > 0.0);
  // Texels that are too bright where the truth is black are still seen, as 1.
  a[3000] = 7.0f;
  const double eps = 0.005 * 0.005;
  CHECK(measured(a, b, 40).clipped[0].value() == Approx(1.0 / eps / 4000.0));
}

TEST_CASE("image metrics: a truth of 0 leaves no relative figures") {
  const ImageMetrics m = measured({1, 0, 0, 0}, {0, 0, 0, 0}, 2);
  CHECK(m.rmse.value() == Approx(0.5));
  CHECK_FALSE(m.relative_l1.has_value());
  for (std::size_t i = 0; i < kMetricBoxes.size(); ++i) {
    CHECK_FALSE(m.relative_mse[i].has_value());
    CHECK_FALSE(m.clipped[i].has_value());
  }
  CHECK_FALSE(m.clip.has_value());
  CHECK_FALSE(m.flux_ratio.has_value());
  CHECK_FALSE(m.flux_error.has_value());
  CHECK_FALSE(m.psnr.has_value());
}

TEST_CASE("image metrics: black against black has no error") {
  const ImageMetrics m = measured({0, 0, 0, 0}, {0, 0, 0, 0}, 2);
  CHECK(m.relative_l1 == 0.0);
  CHECK(m.rmse == 0.0);
  CHECK(m.relative_mse[2] == 0.0);
  CHECK(m.clipped[0] == 0.0);
  CHECK(m.flux_error == 0.0);
  CHECK_FALSE(m.flux_ratio.has_value());
}

TEST_CASE("image metrics: equal images have no error and no peak signal-to-noise ratio") {
  const ImageMetrics m = measured({1, 2, 3, 4}, {1, 2, 3, 4}, 2);
  CHECK(m.relative_l1 == 0.0);
  CHECK(m.relative_mse[0] == 0.0);
  CHECK(m.flux_ratio == 1.0);
  CHECK_FALSE(m.psnr.has_value());
}

TEST_CASE("image metrics: a value that is not finite leaves no figure unless the mask leaves it out") {
  for (const float wrong :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    const Values a = {1, 2, wrong, 5}, b = {1, 2, 3, 4};
    const ImageMetrics m = measured(a, b, 2);
    CHECK(m.non_finite == 1);
    for (const NamedMetric& each : named_metrics(m)) CHECK_FALSE(each.value.has_value());
    CHECK(measured(b, a, 2).non_finite == 1);
    const ImageMetrics within = measured(a, b, 2, {1, 1, 0, 1});
    CHECK(within.values == 3);
    CHECK(within.relative_l1.value() == Approx(1.0 / 7.0));
  }
}

TEST_CASE("image metrics: a mask selects texels and boxes average over these alone") {
  const Values a = {4, 9, 9, 9, 2, 9, 9, 9}, b = {2, 0, 0, 0, 2, 0, 0, 0};
  const ImageMetrics m = measured(a, b, 4, {1, 0, 0, 0, 1, 0, 0, 0});
  CHECK(m.relative_l1.value() == Approx(0.5));
  // Means 3 and 2, eps = 0.02^2.
  CHECK(m.relative_mse[1].value() == Approx(1.0 / 4.0004));
  const ImageMetrics none = measured(a, b, 4, {0, 0, 0, 0, 0, 0, 0, 0});
  CHECK(none.values == 0);
  CHECK_FALSE(none.rmse.has_value());
}

TEST_CASE("image metrics: channels of a layer share their sums") {
  const Values a = {2, 4}, b = {1, 4}, c = {0, 0}, d = {1, 2};
  const PlanePair pairs[] = {{{a.data(), 1, 2, 1}, {b.data(), 1, 2, 1}},
                             {{c.data(), 1, 2, 1}, {d.data(), 1, 2, 1}}};
  const ImageMetrics m = image_metrics(pairs);
  CHECK(m.values == 4);
  CHECK(m.relative_l1.value() == Approx((1.0 + 0.0 + 1.0 + 2.0) / 8.0));
  CHECK(m.flux_ratio.value() == Approx(6.0 / 8.0));
}

TEST_CASE("image metrics: images in memory are measured as their files are") {
  // 1 x 6 texels: rows from the bottom in memory, from the top in boxes; alpha does not count.
  Image a(Format::RGBA32F, 1, 6), b(Format::RGBA32F, 1, 6);
  Values from_top_a, from_top_b;
  for (int y = 5; y >= 0; --y) {
    for (int c = 0; c < 3; ++c) {
      a.at(0, y, c) = static_cast<float>(y);
      b.at(0, y, c) = static_cast<float>(y * y);
    }
    a.at(0, y, 3) = 7.0f;
    from_top_a.push_back(static_cast<float>(y));
    from_top_b.push_back(static_cast<float>(y * y));
  }
  const ImageMetrics m = image_metrics(a, b), one = measured(from_top_a, from_top_b, 1);
  CHECK(m.values == 18);
  CHECK(m.relative_l1.value() == Approx(one.relative_l1.value()));
  CHECK(m.relative_mse[1].value() == Approx(one.relative_mse[1].value()));
  // Masks run as the image's rows do: this one keeps y = 0 and 1 alone, where both agree.
  const std::vector<std::uint8_t> bottom = {1, 1, 0, 0, 0, 0};
  CHECK(image_metrics(a, b, bottom).relative_l1 == 0.0);
}
