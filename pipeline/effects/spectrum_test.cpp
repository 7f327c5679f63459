#include "pipeline/effects/spectrum.hpp"

#include <algorithm>

#include "tests/support/catch.hpp"

using namespace caustics;

TEST_CASE("spectrum: all wavelengths together are white") {
  for (const int count : {8, 9, 16, 64}) {
    glm::vec3 sum(0.0f);
    for (const Wavelength& w : spectrum(count)) sum += w.color;
    for (int c = 0; c < 3; ++c) CHECK(sum[c] == Approx(1.0).epsilon(1e-5));
  }
  glm::vec3 lines(0.0f);
  for (const Wavelength& w : fraunhofer_lines()) lines += w.color;
  CHECK(lines == glm::vec3(1.0f));
}

TEST_CASE("spectrum: short waves are blue, long ones red, those between green") {
  const std::vector<Wavelength> waves = spectrum(30);
  const auto strongest = [&](double nanometres) {
    const auto nearest = std::min_element(waves.begin(), waves.end(), [&](const auto& a, const auto& b) {
      return std::abs(a.nanometres - nanometres) < std::abs(b.nanometres - nanometres);
    });
    const glm::vec3& color = nearest->color;
    return color.x > color.y && color.x > color.z ? 'r' : color.y > color.z ? 'g' : 'b';
  };
  CHECK(strongest(450.0) == 'b');
  CHECK(strongest(530.0) == 'g');
  CHECK(strongest(620.0) == 'r');
}

TEST_CASE("spectrum: colours are those of the CIE 1931 observer in sRGB") {
  // Of 520 to 530 nm over those of 600 to 610: the means of the table's entries at their ends, XYZ =
  // (0.114385, 0.786, 0.060205) and (1.0324, 0.567, 0.00057), by the matrix of IEC 61966-2-1. White falls out
  // of the ratio.
  const std::vector<Wavelength> waves = spectrum(30);
  const glm::vec3 ratio = waves[12].color / waves[20].color;
  CHECK(ratio.x == Approx(-0.867581 / 2.473719).epsilon(1e-4));
  CHECK(ratio.y == Approx(1.366049 / 0.063311).epsilon(1e-4));
  CHECK(ratio.z == Approx(0.090336 / 0.057561).epsilon(1e-4));
}

TEST_CASE("spectrum: the F and C lines bend apart by one, the d line not at all") {
  CHECK(bend_of(kLineD) == 0.0);
  CHECK(bend_of(kLineF) - bend_of(kLineC) == Approx(1.0));
  CHECK(bend_of(kLineF) > 0.0);
  // By the inverse square of the wavelength (Cauchy): 0.239343 of the way from C to F at the e line.
  CHECK(bend_of(546.074) == Approx(0.23934).epsilon(1e-3));
}

TEST_CASE("spectrum: Cauchy's formula is near Sellmeier's for BK7 glass") {
  // N-BK7 by its catalogue: n_d = 1.51680, n_F - n_C = 0.008054, and 1.51872 at the e line, 546.074 nm.
  const double n_e = 1.516800 + 0.008054 * bend_of(546.074);
  CHECK(n_e == Approx(1.51872).margin(2e-4));
}
