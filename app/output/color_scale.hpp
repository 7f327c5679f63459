// Scales of colours that people see alike, whatever their eyes tell apart: each grows steadily from black to
// white, also on paper without colours. And the colour of what has no place on any scale.
#pragma once

namespace caustics::app {

// Display values, 0..1.
struct Color {
  double r, g, b;
};

// NaN and infinities.
inline constexpr Color kFaultColor{1.0, 0.0, 1.0};

// From black (0) to white (1): D. A. Green, "A colour scheme for the display of astronomical intensity
// images", 2011, eq. 2 with its defaults.
Color cubehelix(double level);

// A logarithmic scale from `darkest`, still seen beside black, to `largest`, which is white; black is kept
// for 0, kFaultColor for what is not finite.
Color logarithmic_color(double magnitude, double darkest, double largest);
// Six powers of ten below: as far as a logarithmic scale goes.
double darkest_of(double largest);

}  // namespace caustics::app
