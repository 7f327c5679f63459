#include "passes/shared/hierarchy_reads.hpp"

namespace caustics {

std::vector<Read> path_reads() {
  return {path_read("path_start", "ray_start"), path_read("path_direction", "ray_direction"),
          path_read("path_flux", "ray_flux"),   path_read("path_media", "ray_media"),
          path_read("path_width", "ray_width"), path_read("path_spread", "ray_spread")};
}

std::vector<Write> path_writes() {
  return {
      {.name = "ray_start",
       .meaning = "xyz: where the ray starts, metres, scene space; w: number of the triangle there plus 1, "
                  "0 where no light is under way, -1 where it has been given up"},
      {.name = "ray_direction",
       .meaning = "xyz: unit direction; w: a number for the bodies and events on its path"},
      {.name = "ray_flux",
       .meaning = "rgb: flux, relative to the light's intensity, of all wavelengths; w: the light's on the "
                  "grid vertex's cell"},
      {.name = "ray_media",
       .meaning = "the bodies that it is in, the last one entered first: row of caster_materials plus 1, "
                  "or 0"},
      {.name = "ray_width",
       .meaning = "how the start moves along the grid's rows (xy) and columns (zw), metres, across the "
                  "direction"},
      {.name = "ray_spread", .meaning = "how the direction turns likewise, radians"},
      {.name = kLandingFresnel,
       .meaning = "rgb: flux reflected at the surfaces and not followed; w: flux that entered the cell",
       .blend = kAccumulate,
       .keeps = true},
      {.name = kLandingAbsorbed,
       .meaning = "rgb: flux absorbed in the material",
       .blend = kAccumulate,
       .keeps = true}};
}

}  // namespace caustics
