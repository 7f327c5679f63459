#include "pipeline/scene/keyframes.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/scene/exact.hpp"

namespace caustics {

namespace {

double dot4(const double* a, const double* b) {
  return (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3]);
}

// False, and nothing changed, where the quaternion has no direction.
bool make_unit(double* q) {
  const double squared = dot4(q, q);
  if (!(squared > 1e-24 && squared < 1e24)) return false;
  const double length = std::sqrt(squared);
  for (int i = 0; i < 4; ++i) q[i] /= length;
  return true;
}

using Value = std::vector<double>;

// `slot` counts values: keys, or thirds of a spline's keys.
Value value_at(const Keyframes& keys, std::size_t slot) {
  Value value(keys.width);
  for (std::size_t i = 0; i < keys.width; ++i)
    value[i] = static_cast<double>(keys.values[slot * keys.width + i]);
  return value;
}

Value key_value(const Keyframes& keys, std::size_t key) {
  const bool spline = keys.interpolation == KeyframeInterpolation::CubicSpline;
  Value value = value_at(keys, spline ? 3 * key + 1 : key);
  if (keys.rotation && !make_unit(value.data())) value = {0.0, 0.0, 0.0, 1.0};
  return value;
}

Value linear(const Keyframes& keys, std::size_t key, double share) {
  Value a = key_value(keys, key);
  const Value b = key_value(keys, key + 1);
  if (keys.rotation) {
    slerp(a.data(), b.data(), share, a.data());
    return a;
  }
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = a[i] * (1.0 - share) + b[i] * share;
  return a;
}

// Appendix C.5: tangents are per second, so they count with the length of the interval.
Value spline(const Keyframes& keys, std::size_t key, double share, double length) {
  const Value from = value_at(keys, 3 * key + 1), out = value_at(keys, 3 * key + 2);
  const Value in = value_at(keys, 3 * key + 3), to = value_at(keys, 3 * key + 4);
  const double t = share, t2 = t * t, t3 = t2 * t;
  Value value(keys.width);
  for (std::size_t i = 0; i < value.size(); ++i)
    value[i] = ((2 * t3 - 3 * t2 + 1) * from[i] + length * (t3 - 2 * t2 + t) * out[i]) +
               ((3 * t2 - 2 * t3) * to[i] + length * (t3 - t2) * in[i]);
  if (keys.rotation && !make_unit(value.data())) return key_value(keys, key);
  return value;
}

}  // namespace

void slerp(const double* a, const double* b, double share, double* result) {
  // q and -q are one rotation: the nearer of both is meant.
  const double sign = dot4(a, b) < 0 ? -1.0 : 1.0;
  double apart = 0, together = 0;
  for (int i = 0; i < 4; ++i) {
    apart += (a[i] - sign * b[i]) * (a[i] - sign * b[i]);
    together += (a[i] + sign * b[i]) * (a[i] + sign * b[i]);
  }
  // The angle between two unit vectors, exact where it is small too.
  const double angle = 2 * exact::arctangent(std::sqrt(apart) / std::sqrt(together));
  double whole, from, to, unused;
  exact::sin_cos(angle, whole, unused);
  exact::sin_cos((1 - share) * angle, from, unused);
  exact::sin_cos(share * angle, to, unused);
  if (!(whole > 0)) from = 1, to = 0, whole = 1;
  for (int i = 0; i < 4; ++i) result[i] = (a[i] * from + sign * b[i] * to) / whole;
}

std::vector<double> Keyframes::at(double seconds) const {
  const auto next = std::upper_bound(times.begin(), times.end(), seconds,
                                     [](double t, float key) { return t < static_cast<double>(key); });
  if (next == times.begin()) return key_value(*this, 0);
  const auto key = static_cast<std::size_t>(next - times.begin()) - 1;
  if (next == times.end() || interpolation == KeyframeInterpolation::Step) return key_value(*this, key);
  const double start = static_cast<double>(times[key]);
  const double length = static_cast<double>(times[key + 1]) - start;
  const double share = (seconds - start) / length;
  return interpolation == KeyframeInterpolation::Linear ? linear(*this, key, share)
                                                        : spline(*this, key, share, length);
}

}  // namespace caustics
