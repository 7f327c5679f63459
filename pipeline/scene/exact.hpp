// Double-precision arithmetic for everything that prepares a scene: + - * / and sqrt only, each
// written in a fixed order, so that a scene has the same bits on every machine and compiler.
#pragma once
#include <cmath>
#include <glm/glm.hpp>

namespace caustics::exact {

inline constexpr double kPi = 3.14159265358979323846;

inline double dot(const glm::dvec3& a, const glm::dvec3& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }
inline glm::dvec3 cross(const glm::dvec3& a, const glm::dvec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
// Of linear sRGB (Rec. 709).
inline double luminance(const glm::dvec3& color) { return dot(color, {0.2126, 0.7152, 0.0722}); }
// Scaled by the largest component first, so that neither tiny nor huge vectors lose their length.
double length(const glm::dvec3& v);
// The unit vector along v, or `fallback` where v is zero or not finite.
glm::dvec3 normalise(const glm::dvec3& v, const glm::dvec3& fallback);
bool finite(const glm::dvec3& v);
// A unit vector perpendicular to the unit vector n.
glm::dvec3 perpendicular(const glm::dvec3& n);

// p -> x * p.x + y * p.y + z * p.z + translation.
struct Affine {
  glm::dvec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  glm::dvec3 translation{0};

  glm::dvec3 direction(const glm::dvec3& v) const;
  glm::dvec3 point(const glm::dvec3& p) const { return direction(p) + translation; }
  double determinant() const { return dot(x, cross(y, z)); }
  // What surface normals are transformed with, up to a positive factor: the cofactor matrix with
  // the determinant's sign.
  glm::dvec3 normal(const glm::dvec3& n) const;
  bool finite() const;
};
Affine operator*(const Affine& outer, const Affine& inner);

// Translation, rotation by the quaternion (x, y, z, w), which is normalised first, and scale.
Affine from_trs(const glm::dvec3& translation, const glm::dvec4& rotation, const glm::dvec3& scale);

// Sine and cosine, to about 1e-15 for |angle| up to 1e5.
void sin_cos(double angle, double& sine, double& cosine);

// The angle within -pi/2..pi/2 whose tangent is x, to about 1e-15; x may be infinite, not NaN.
double arctangent(double x);

// Natural logarithm of x > 0, to about 1e-15.
double log(double x);

// e^x, to about 1e-15 of it; 0 below x = -700, infinite above 709.
double exp(double x);

// The sRGB transfer function (IEC 61966-2-1): encoded 0..1 to linear 0..1, to about 1e-15.
double srgb_to_linear(double encoded);

}  // namespace caustics::exact
