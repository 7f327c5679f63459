// The maps and what is laid into them.
#include <algorithm>
#include <cmath>

#include "lab/paper/floor_shots.hpp"
#include "lab/paper/measures.hpp"
#include "lab/paper/rows.hpp"
#include "pipeline/gpu/text.hpp"

namespace caustics::paper {

Row maps_row() {
  return {
      "16, 17, 18",
      "the positions texture, the vertex grid, the caustic map by splatting",
      {dumped_shot("maps", "glass_sphere.glb", 128, {"--splat", "point"})},
      "maps",
      "the floor's positions on an even lattice; grid vertices on the sphere, normals of length 1; the map "
      "holds what landed: 1e-5",
      [](const Shots& s) -> Finding {
        const Texels floor = s.attachment("maps", "receiver_position[0]");
        const Texels vertices = s.attachment("maps", "caster_position[0]");
        const Texels normals = s.attachment("maps", "caster_normal[0]");
        const double lattice = worst_of_lattice(floor);
        double off_sphere = 0.0, length = 0.0, map = 0.0;
        for (std::size_t i = 0; i < vertices.values.size(); ++i) {
          const auto &p = vertices.values[i], &n = normals.values[i];
          if (p[3] == 0.0) continue;
          const double height = p[1] - floor.values[0][1] - kSphere.distance;
          off_sphere = std::max(off_sphere, std::fabs(std::hypot(p[0], height, p[2]) - kSphere.radius));
          length = std::max(length, std::fabs(std::hypot(n[0], n[1], n[2]) - 1.0));
        }
        for (const auto& texel : s.attachment("maps", "caustic_map[0]").values) map += texel[0];
        const double sum = std::fabs(map / s.flux("maps", "in_map", 0) - 1.0);
        // Facets of 20 480 triangles lie up to a thousandth of the radius below the sphere.
        return {lattice < 1e-5 && off_sphere < 1e-3 * kSphere.radius && length < 1e-6 && sum < 1e-5 &&
                    all_closed(s, {"maps"}),
                "floor within " + significant(lattice, 2) + " m, sphere within " +
                    significant(1e3 * off_sphere, 2) + " mm, normals within " + significant(length, 2) +
                    ", residual " + significant(s.residual("maps"), 2)};
      }};
}

Row gaps_row() {
  return {"24",
          "gaps between points",
          {floor_shot("gaps_point", "glass_sphere.glb", {"--grid", "64", "--splat", "point"}),
           floor_shot("gaps_cell", "glass_sphere.glb", {"--grid", "64"})},
          "gaps_point",
          "points of a grid of 64 leave most of the shadow dark, cells none of it",
          [](const Shots& s) -> Finding {
            const double point = sphere_error(s, "gaps_point").dark_share,
                         cell = sphere_error(s, "gaps_cell").dark_share;
            return {point > 0.5 && cell < 0.01,
                    "dark: " + percent(point) + " by points, " + percent(cell) + " by cells"};
          }};
}

Row gaussian_row() {
  return {"25",
          "points with a Gaussian",
          {floor_shot("gaussian", "glass_sphere.glb", {"--splat", "gaussian"})},
          "gaussian",
          "the kernel is normalised: map, map's edge and losses add up to what entered, 1e-5",
          [](const Shots& s) -> Finding {
            return {all_closed(s, {"gaussian"}), "residual " + significant(s.residual("gaussian"), 2) +
                                                     ", off the edge " +
                                                     percent(s.share("gaussian", "kernel_edge"))};
          }};
}

Row room_row() {
  return {"26",
          "the frustum's limitation: a lamp among its casters in a closed room",
          {{"room", "closed_room.glb", {"-r", "960x540"}}},
          "room",
          "no flux leaves the maps; ledger within 1e-5",
          [](const Shots& s) -> Finding {
            return {all_closed(s, {"room"}) && s.share("room", "outside") == 0.0,
                    "outside " + percent(s.share("room", "outside")) + ", residual " +
                        significant(s.residual("room"), 2)};
          }};
}

Row tessellation_row() {
  Row row{"27",
          "tessellation has no effect, the grid does",
          {floor_shot("grid_64", "glass_sphere.glb", {"--grid", "64"}),
           floor_shot("grid_128", "glass_sphere.glb", {"--grid", "128"}),
           floor_shot("coarse_128", "glass_sphere_coarse.glb", {"--grid", "128"})},
          "coarse_128",
          "half the grid changes the error more than a sixteenth of the triangles",
          {}};
  row.check = [](const Shots& s) -> Finding {
    const double fine = sphere_error(s, "grid_128").relative_l1_in_shadow;
    const double coarse = sphere_error(s, "coarse_128").relative_l1_in_shadow;
    const double half = sphere_error(s, "grid_64").relative_l1_in_shadow;
    return {std::fabs(coarse - fine) < std::fabs(half - fine),
            "relative L1, grid 128: 20 480 triangles " + percent(fine) + ", 1 280 " + percent(coarse) +
                "; grid 64: " + percent(half)};
  };
  return row;
}
}  // namespace caustics::paper
