// What must hold between settings: maps with room for what is asked to be drawn into them.
#pragma once
#include <string>

#include "pipeline/settings/settings.hpp"

namespace caustics {

// Throws Error (WrongUsage) where a setting is out of its range, or a map is too small for the others.
void check(const Settings& settings);

// Texels by which a face of a cube's caustic map is wider than what it shows: room for splats, and for cells
// that reach over the face's edge.
int caustic_guard(const Settings& settings);
// "grid is 16, must be at least 48" where the maps have no room for six faces, else empty.
std::string too_small_for_cubes(const Settings& settings);

}  // namespace caustics
