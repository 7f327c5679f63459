// A scale of colours that grows steadily from black (0) to white (1), also on paper without
// colours.
#pragma once

namespace caustics::app {

// Display values, 0..1.
struct Color {
  double r, g, b;
};

// D. A. Green, "A colour scheme for the display of astronomical intensity images", 2011, eq. 2 with
// its defaults.
Color cubehelix(double level);

}  // namespace caustics::app
