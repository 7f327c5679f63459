// The start-up probe: what a driver makes of arithmetic, interpolation, corners and points, drawn and
// counted. It decides the driver's class, by which parity judges (pipeline/gpu/parity_bounds.hpp). Run on
// request only, by `caustics doctor`, `caustics parity` and the tests; no frame waits for it. Two small
// programs and nine draws.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "gl_backend/gl_device.hpp"
#include "pipeline/gpu/parity_bounds.hpp"

namespace caustics {

// How smooth varyings are evaluated from exact planes: fma(d/dy, y, fma(d/dx, x, a)), as the software device
// does; the same with every product rounded; otherwise.
enum class Interpolated : std::uint8_t { Fused, Unfused, Otherwise };

struct GlFindings {
  std::string renderer;
  // Of kOperands random operands: results that are not the nearest floats.
  static constexpr int kOperands = 65536;
  int wrong_quotients = 0, wrong_roots = 0;
  int wrong_sums = 0;       // a * b + c, marked precise
  int contracted_sums = 0;  // of these, rounded once instead of twice
  bool fuses_fma = false;   // fma(a, b, c) rounds once
  bool keeps_denormals = false, makes_nan = true;
  Interpolated interpolated = Interpolated::Fused;
  int subpixel_bits = 8;                                // as the driver says
  int drawn_subpixel_bits = 8;                          // as corners show
  float smallest_point = 1.0f, largest_point = 255.0f;  // as the driver says
  int misplaced_points = 0;  // of kPoints, that cover other pixels than pixels_of_point() says
  static constexpr int kPoints = 4096;
  bool draws_points_off_target = false;  // those whose centre is outside
};

// Throws Error like any run.
GlFindings probe(GlDevice& device);
// The same of a device that says this of itself.
GlFindings probe(Device& device, const std::string& renderer, const GlLimits& limits);

DriverClass class_of(const GlFindings& findings);

// What was found, in words: {"division", "64 of 65536 are not the nearest float"}.
std::vector<std::pair<std::string, std::string>> rows_of(const GlFindings& findings);

}  // namespace caustics
