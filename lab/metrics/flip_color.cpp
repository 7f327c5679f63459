#include "lab/metrics/flip_color.hpp"

#include <algorithm>
#include <cmath>

namespace caustics::flip {

namespace {

using Matrix = std::array<Color, 3>;

// Linear sRGB to XYZ, in the fractions of the authors' programs.
constexpr Matrix kXyzFromLinear = {
    {{10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0},
     {2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0},
     {1425312.0 / 73733382.0, 8788810.0 / 73733382.0, 70074185.0 / 73733382.0}}};

// Each row over its sum: XYZ in units of white.
constexpr Matrix relative(const Matrix& m) {
  Matrix result{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double white = m[i][0] + m[i][1] + m[i][2];
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = m[i][j] / white;
  }
  return result;
}

constexpr Matrix inverse(const Matrix& m) {
  const auto minor = [&](std::size_t i, std::size_t j) {
    const std::size_t a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
    return m[a][c] * m[b][d] - m[a][d] * m[b][c];
  };
  const double determinant = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
  Matrix result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result[j][i] = minor(i, j) / determinant;
  }
  return result;
}

constexpr Matrix kForward = relative(kXyzFromLinear);
constexpr Matrix kBackward = inverse(kForward);

Color times(const Matrix& m, const Color& v) {
  Color result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return result;
}

// What L*a*b* and YCxCz share, of compressed or plain relative XYZ.
Color opponent(const Color& v) { return {116.0 * v[1] - 16.0, 500.0 * (v[0] - v[1]), 200.0 * (v[1] - v[2])}; }

double compressed(double t) {
  constexpr double kDelta = 6.0 / 29.0;
  if (t > kDelta * kDelta * kDelta) return std::cbrt(t);
  return t / (3.0 * kDelta * kDelta) + 4.0 / 29.0;
}

}  // namespace

double linear_from_srgb(double encoded) {
  const double v = encoded > 0.0 ? std::min(encoded, 1.0) : 0.0;
  return v > 0.04045 ? std::pow((v + 0.055) / 1.055, 2.4) : v / 12.92;
}

Color ycxcz_from_linear(const Color& rgb) { return opponent(times(kForward, rgb)); }

Color linear_from_ycxcz(const Color& ycxcz) {
  const double y = (ycxcz[0] + 16.0) / 116.0;
  return times(kBackward, {y + ycxcz[1] / 500.0, y, y - ycxcz[2] / 200.0});
}

Color hunt_lab_from_linear(const Color& rgb) {
  const Color xyz = times(kForward, rgb);
  Color lab = opponent({compressed(xyz[0]), compressed(xyz[1]), compressed(xyz[2])});
  lab[1] *= 0.01 * lab[0];
  lab[2] *= 0.01 * lab[0];
  return lab;
}

double hyab(const Color& a, const Color& b) {
  return std::abs(a[0] - b[0]) + std::sqrt((a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
}

}  // namespace caustics::flip
