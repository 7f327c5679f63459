#include "pipeline/settings/splat_kernel.hpp"

#include "pipeline/settings/settings.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;

TEST_CASE("splat kernel: the shares of any partition add up to 1") {
  Settings settings;
  settings.splat = Splat::Gaussian;
  for (const float sigma : {0.2f, 0.7f, 3.0f}) {
    settings.gaussian_sigma = sigma;
    const SplatKernel k = splat_kernel(settings);
    for (double offset : {0.0, 0.1, 0.5, 0.9}) {
      double sum = 0.0;
      for (int i = -12; i <= 12; ++i) sum += k.share(i - offset, i + 1 - offset);
      CHECK(sum == Approx(1.0).epsilon(1e-12));
    }
    CHECK(k.point_size >= 2.0 * k.radius + 1.0);
  }
}

TEST_CASE("splat kernel: a point's whole share lies in the interval that holds it") {
  Settings settings;
  settings.splat = Splat::Point;
  const SplatKernel k = splat_kernel(settings);
  CHECK(k.share(-0.5, 0.5) == 1.0);
  CHECK(k.share(0.5, 1.5) == 0.0);
  CHECK(k.point_size == 1.0);
}
