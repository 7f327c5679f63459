// A value that is known at some moments, and between them by interpolation.
// Source: glTF 2.0 section 3.11 and appendix C. Arithmetic is exact (pipeline/scene/exact.hpp): the
// same moment gives the same bits everywhere.
#pragma once
#include <cstdint>
#include <vector>

namespace caustics {

enum class KeyframeInterpolation : std::uint8_t { Step, Linear, CubicSpline };

struct Keyframes {
  KeyframeInterpolation interpolation = KeyframeInterpolation::Linear;
  bool rotation = false;     // four components that are a unit quaternion (x, y, z, w)
  std::size_t width = 1;     // components of a value
  std::vector<float> times;  // seconds, strictly increasing, at least one
  // `width` components a moment; of a CubicSpline three times as many: in-tangent, value, out-tangent.
  std::vector<float> values;

  // The value at a moment: `width` components. Before the first moment and after the last it stays.
  // Rotations are unit quaternions, interpolated along the shorter way (spherically where Linear).
  std::vector<double> at(double seconds) const;
};

// From the unit quaternion a (share 0) to b (share 1) at an even pace, the shorter way round; four
// components each.
void slerp(const double* a, const double* b, double share, double* result);

}  // namespace caustics
