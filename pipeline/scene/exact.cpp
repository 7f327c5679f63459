#include "pipeline/scene/exact.hpp"

#include <algorithm>

namespace caustics::exact {

namespace {
double absolute(double x) { return x < 0 ? -x : x; }
bool finite(double x) { return x - x == 0.0; }
}  // namespace

double length(const glm::dvec3& v) {
  const double largest = std::max({absolute(v.x), absolute(v.y), absolute(v.z)});
  if (!(largest > 0) || !finite(largest)) return largest;
  const glm::dvec3 scaled = v / largest;
  return largest * std::sqrt(dot(scaled, scaled));
}

bool finite(const glm::dvec3& v) { return finite(v.x) && finite(v.y) && finite(v.z); }

glm::dvec3 normalise(const glm::dvec3& v, const glm::dvec3& fallback) {
  const double largest = std::max({absolute(v.x), absolute(v.y), absolute(v.z)});
  if (!finite(v) || !(largest > 0)) return fallback;
  const glm::dvec3 scaled = v / largest;
  return scaled / std::sqrt(dot(scaled, scaled));
}

glm::dvec3 perpendicular(const glm::dvec3& n) {
  const glm::dvec3 helper =
      absolute(n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, absolute(n.x) < 0.9 ? 0 : 1, 1);
  return normalise(cross(cross(n, helper), n), {0, 1, 0});
}

glm::dvec3 Affine::direction(const glm::dvec3& v) const { return (x * v.x + y * v.y) + z * v.z; }

glm::dvec3 Affine::normal(const glm::dvec3& n) const {
  const glm::dvec3 transformed = (cross(y, z) * n.x + cross(z, x) * n.y) + cross(x, y) * n.z;
  return determinant() < 0 ? -transformed : transformed;
}

bool Affine::finite() const {
  return exact::finite(x) && exact::finite(y) && exact::finite(z) && exact::finite(translation);
}

Affine operator*(const Affine& outer, const Affine& inner) {
  return {outer.direction(inner.x), outer.direction(inner.y), outer.direction(inner.z),
          outer.point(inner.translation)};
}

Affine from_trs(const glm::dvec3& translation, const glm::dvec4& rotation, const glm::dvec3& scale) {
  const double squared = (rotation.x * rotation.x + rotation.y * rotation.y) +
                         (rotation.z * rotation.z + rotation.w * rotation.w);
  const double inverse = 1.0 / std::sqrt(squared);
  const double a = rotation.x * inverse, b = rotation.y * inverse;
  const double c = rotation.z * inverse, w = rotation.w * inverse;
  Affine result;
  result.x = glm::dvec3(1 - 2 * (b * b + c * c), 2 * (a * b + w * c), 2 * (a * c - w * b));
  result.y = glm::dvec3(2 * (a * b - w * c), 1 - 2 * (a * a + c * c), 2 * (b * c + w * a));
  result.z = glm::dvec3(2 * (a * c + w * b), 2 * (b * c - w * a), 1 - 2 * (a * a + b * b));
  result.x *= scale.x;
  result.y *= scale.y;
  result.z *= scale.z;
  result.translation = translation;
  return result;
}

void sin_cos(double angle, double& sine, double& cosine) {
  // Reduced to |r| <= pi/4 by quarter turns; pi/2 in two parts, the first with trailing zero bits,
  // so that its product with the number of quarter turns is exact.
  constexpr double kHigh = 1.57079632673412561417, kLow = 6.07710050650619224932e-11;
  const double turns = angle * (2.0 / kPi);
  const long long quarter = static_cast<long long>(turns + (turns < 0 ? -0.5 : 0.5));
  const double r = (angle - static_cast<double>(quarter) * kHigh) - static_cast<double>(quarter) * kLow;
  const double r2 = r * r;
  // Taylor series by Horner; the first term left out is below 1e-17 of the sum.
  double s = 1, c = 1;
  for (int k = 17; k >= 3; k -= 2) s = 1 - r2 / (k * (k - 1)) * s;
  for (int k = 18; k >= 2; k -= 2) c = 1 - r2 / (k * (k - 1)) * c;
  s *= r;
  switch (((quarter % 4) + 4) % 4) {
    case 0:
      sine = s, cosine = c;
      break;
    case 1:
      sine = c, cosine = -s;
      break;
    case 2:
      sine = -s, cosine = -c;
      break;
    default:
      sine = -c, cosine = s;
      break;
  }
}

double srgb_to_linear(double encoded) {
  if (encoded <= 0.04045) return encoded / 12.92;
  const double base = (encoded + 0.055) / 1.055;
  // base^2.4 = base^2 * (base^2)^(1/5); the fifth root by Newton from above, where it converges
  // monotonically.
  const double square = base * base;
  double root = 1.0;
  for (int i = 0; i < 24; ++i) {
    const double fourth = (root * root) * (root * root);
    root = (4 * root + square / fourth) / 5;
  }
  return square * root;
}

}  // namespace caustics::exact
