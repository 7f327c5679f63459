// What of a scene is to be shown, and what only stands around it: floors, walls, backdrops.
#pragma once
#include <vector>

#include "pipeline/scene/scene.hpp"

namespace caustics {

// A floor reaches beyond what stands on it by this much of the latter's largest extent, to all sides: a
// shadow at 63 degrees ends on it, and a picture of the thing shows the floor around it. A base, a plinth or
// a tray is smaller.
inline constexpr double kFloorBeyond = 0.5;

// A receiver stands around the rest of the scene if it is at least twice as wide as the rest, and
// - flat, and the rest lies before, above or below it, as a wall or a floor has it; or
// - a floor to it, whatever its shape: a room in one mesh, a table, a landscape.
// An open sheet, such as a cloth, needs to be half as much wider and to reach half as far.
struct Surroundings {
  std::vector<bool> around;  // by Scene::meshes
  Bounds thing;              // of all others
  // Does what stands around lie below the thing and reach beyond it by kFloorBeyond, or as far as a wall, in
  // at least three quarters of all directions? A thing may stand near the edge of a table.
  bool has_floor = false;
};
Surroundings surroundings_of(const Scene& scene);

}  // namespace caustics
