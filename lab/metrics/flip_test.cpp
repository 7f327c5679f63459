#include "lab/metrics/flip.hpp"

#include <cmath>
#include <limits>

#include "lab/metrics/flip_color.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

// Every pixel of this encoded colour.
Image plain(float r, float g, float b, int width = 5, int height = 4) {
  Image image(Format::RGBA32F, width, height);
  for (std::size_t i = 0; i < image.values.size(); i += 4) {
    image.values[i] = r;
    image.values[i + 1] = g;
    image.values[i + 2] = b;
    image.values[i + 3] = 1.0f;
  }
  return image;
}

// White pixels on black where `lit` is true.
Image drawn(int width, int height, const auto& lit) {
  Image image(Format::RGBA32F, width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < 3; ++c) image.at(x, y, c) = lit(x, y) ? 1.0f : 0.0f;
    }
  }
  return image;
}

// Two plain pictures differ everywhere alike; that value.
double of_plain(const Image& a, const Image& b) {
  const FlipFigures figures = flip_figures(flip_map(a, b));
  CHECK(figures.mean == Approx(figures.largest));
  return figures.mean;
}

}  // namespace

TEST_CASE("flip: identical pictures differ nowhere") {
  const Image picture = drawn(24, 20, [](int x, int y) { return (x / 3 + y / 2) % 2 == 0; });
  for (const float value : flip_map(picture, picture).values) CHECK(value == 0.0f);
}

TEST_CASE("flip: colour spaces at their corners") {
  const flip::Color white = flip::hunt_lab_from_linear({1, 1, 1});
  CHECK(white[0] == Approx(100.0));
  CHECK(std::abs(white[1]) < 1e-9);
  CHECK(std::abs(white[2]) < 1e-9);
  // CIE L*a*b* of the sRGB primaries under D65, from published tables: green (87.73,
  // -86.18, 83.18), blue (32.30, 79.19, -107.86). Hunt's factor is 0.8773 and 0.3230.
  const flip::Color green = flip::hunt_lab_from_linear({0, 1, 0});
  CHECK(green[0] == Approx(87.73).margin(0.02));
  CHECK(green[1] == Approx(0.8773 * -86.18).margin(0.05));
  CHECK(green[2] == Approx(0.8773 * 83.18).margin(0.05));
  const flip::Color blue = flip::hunt_lab_from_linear({0, 0, 1});
  CHECK(blue[1] == Approx(0.3230 * 79.19).margin(0.05));
  CHECK(blue[2] == Approx(0.3230 * -107.86).margin(0.05));
  const flip::Color back = flip::linear_from_ycxcz(flip::ycxcz_from_linear({0.2, 0.5, 0.9}));
  CHECK(back[0] == Approx(0.2));
  CHECK(back[1] == Approx(0.5));
  CHECK(back[2] == Approx(0.9));
}

TEST_CASE("flip: black against white") {
  // The distance is 100, and 203.3 between green and blue (from the table above: 55.44 in
  // lightness,
  // (-101.19, 107.82) across). Powers of 0.7: 25.119 and 41.276. 0.4 of the latter is 16.510, so
  // 0.95 + 0.05 (25.119 - 16.510) / (41.276 - 16.510) = 0.96738.
  CHECK(of_plain(plain(0, 0, 0), plain(1, 1, 1)) == Approx(0.96738).margin(1e-5));
}

TEST_CASE("flip: two greys differ by their lightness alone") {
  // sRGB 0.5 is 0.21404 linear, L* = 116 * 0.21404^(1/3) - 16 = 53.389; 0.6 is 0.31855, L*
  // = 63.223. 9.8336^0.7 = 4.9534; below the knee of 16.510: 0.95 * 4.9534 / 16.510 = 0.28502.
  CHECK(of_plain(plain(0.5f, 0.5f, 0.5f), plain(0.6f, 0.6f, 0.6f)) == Approx(0.28502).margin(2e-5));
}

TEST_CASE("flip: swapping the pictures changes nothing") {
  const Image a = drawn(20, 16, [](int x, int) { return x < 9; });
  const Image b = drawn(20, 16, [](int x, int y) { return x < 12 && y > 3; });
  CHECK(flip_map(a, b).values == flip_map(b, a).values);
}

TEST_CASE("flip: a point counts more than the colour that is left of it") {
  // One white pixel on black is blurred to a dim spot; that it stands there at all is seen as a
  // feature.
  const Image black = plain(0, 0, 0, 41, 41);
  const Image map = flip_map(drawn(41, 41, [](int x, int y) { return x == 20 && y == 20; }), black);
  CHECK(flip_figures(map).largest == Approx(static_cast<double>(map.at(20, 20, 0))));
  CHECK(map.at(0, 0, 0) == 0.0f);  // farther than any filter reaches
  // Turned and mirrored places are alike.
  CHECK(map.at(17, 20, 0) == Approx(map.at(20, 23, 0)));
  CHECK(map.at(18, 19, 0) == Approx(map.at(22, 21, 0)));
}

TEST_CASE("flip: values outside of a screen's range are clamped") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const FlipFigures figures = flip_figures(flip_map(plain(nan, -3, 9), plain(0, 0, 1)));
  CHECK(figures.largest == 0.0);
}

TEST_CASE("flip: the median is weighted by the error") {
  Image map(Format::R32F, 5, 1);
  map.values = {0.4f, 0.1f, 0.1f, 0.0f, 0.2f};
  const FlipFigures figures = flip_figures(map);
  CHECK(figures.mean == Approx(0.16));
  CHECK(figures.largest == Approx(0.4));
  // Of a sum of 0.8 the lower three hold 0.4 from 0.2 on, and a quarter, 0.2, from the second 0.1
  // on.
  CHECK(figures.median == Approx(0.2));
  CHECK(figures.first_quartile == Approx(0.1));
  CHECK(figures.third_quartile == Approx(0.4));
  const std::vector<std::uint8_t> mask = {0, 1, 1, 1, 0};
  CHECK(flip_figures(map, mask).largest == Approx(0.1));
  CHECK(flip_figures(Image(Format::R32F, 2, 2)).mean == 0.0);
}
