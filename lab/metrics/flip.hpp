// LDR-FLIP: how much of a difference a person sees who flips between two pictures.
//
// P. Andersson, J. Nilsson, T. Akenine-Moller, M. Oskarsson, K. Astrom, M. D. Fairchild, "FLIP: A
// Difference Evaluator for Alternating Images", Proceedings of the ACM in Computer Graphics and
// Interactive Techniques 3(2), 2020. Colours are blurred as the eye blurs them at this distance
// (section 4.1), compared in L*a*b* with Hunt's adjustment (4.2, 4.3), and the difference is
// amplified where an edge or a point stands in one picture alone (4.4, 4.5). The white point and
// the matrix of sRGB are those of the authors' programs.
#pragma once
#include <cstdint>
#include <span>

#include "pipeline/gpu/image.hpp"

namespace caustics {

// A screen 0.7 m wide with 3840 pixels, seen from 0.7 m: the authors' default, 67.02.
inline constexpr double kFlipPixelsPerDegree = 3840.0 * 3.14159265358979323846 / 180.0;

// The first three channels are sRGB-encoded display values, 0..1 (others are clamped to that, a NaN
// to 0); both pictures have one size. R32F, each texel 0 (the same) to 1. Swapping the pictures
// changes nothing.
Image flip_map(const Image& test, const Image& reference, double pixels_per_degree = kFlipPixelsPerDegree);

// Of the selected texels of a map. Quartiles and median are weighted by the error itself: texels up
// to the median hold half of the sum of all errors. All 0 where nothing is selected or all errors
// are 0.
struct FlipFigures {
  double mean = 0.0;
  double first_quartile = 0.0, median = 0.0, third_quartile = 0.0;
  double largest = 0.0;
};

// `mask`: one value a texel, in the order of the image's rows, 0 for those left out; empty for all.
FlipFigures flip_figures(const Image& map, std::span<const std::uint8_t> mask = {});

}  // namespace caustics
