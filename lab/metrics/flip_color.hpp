// The colour spaces that FLIP goes through. All colours are relative to the white of sRGB, whose
// L*a*b* is (100, 0, 0).
#pragma once
#include <array>

namespace caustics::flip {

using Color = std::array<double, 3>;

// sRGB-encoded to linear, IEC 61966-2-1. Outside of 0..1 clamped, a NaN to 0.
double linear_from_srgb(double encoded);
// Linear RGB to YCxCz: a linear opponent space. Y is -16 (black) to 100.
Color ycxcz_from_linear(const Color& rgb);
Color linear_from_ycxcz(const Color& ycxcz);
// Linear RGB to CIE L*a*b*, a* and b* times 0.01 L* (Hunt: dim colours look less colourful).
Color hunt_lab_from_linear(const Color& rgb);
// |L - L'| and the Euclidean distance in a, b, added.
double hyab(const Color& a, const Color& b);

}  // namespace caustics::flip
