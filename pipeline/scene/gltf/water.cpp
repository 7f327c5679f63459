#include "pipeline/scene/gltf/water.hpp"

#include <algorithm>

#include "pipeline/scene/gltf/extras.hpp"

namespace caustics::gltf {

namespace {

std::optional<double> optional_number(const Cursor& cursor) {
  if (!cursor.present()) return {};
  return cursor.number();
}

WaterSettings settings_of(const Cursor& water) {
  check_keys(water, {"speed", "damping", "cells", "start", "plops"});
  const Cursor plops = water.member("plops");
  check_keys(plops, {"interval", "radius", "height", "seed"});
  WaterSettings s;
  s.speed = water.member("speed").number(s.speed);
  s.damping = water.member("damping").number(s.damping);
  s.cells = static_cast<int>(water.member("cells").integer(8, 2048, s.cells));
  s.start = water.member("start").number(s.start);
  s.interval = plops.member("interval").number(s.interval);
  s.radius = optional_number(plops.member("radius"));
  s.height = optional_number(plops.member("height"));
  s.seed = static_cast<std::uint64_t>(
      plops.member("seed").integer(0, std::int64_t{1} << 53, static_cast<std::int64_t>(s.seed)));
  return s;
}

// What the waters that are there leave of the limits; a mesh keeps the triangles that it has.
WaterLimits limits_of(const LoadOptions& options, const Scene& scene) {
  WaterLimits left{.cells = static_cast<double>(options.max_water_cells),
                   .updates = options.max_water_updates};
  std::uint64_t triangles = 0;
  for (const Water& water : scene.waters) {
    const double cells = static_cast<double>(water.columns) * water.rows;
    left.cells -= cells;
    left.updates -= cells * static_cast<double>(water.steps_until(0.0));
  }
  for (const Mesh& mesh : scene.meshes) triangles += mesh.indices.size() / 3;
  const std::uint64_t room = options.max_triangles > triangles ? options.max_triangles - triangles : 0;
  left.triangles = std::min(left.triangles, static_cast<std::size_t>(room));
  return left;
}

}  // namespace

void read_waters(const Cursor& root, const std::vector<Placement>& placements, Scene& scene) {
  for (std::size_t object = 0; object < placements.size(); ++object) {
    const Placement& placement = placements[object];
    const Cursor water = extra_of(root, placement, "water");
    if (!water.present()) continue;
    if (!water.json().is_object()) water.fail("is no object", "write \"water\": {} for the defaults");
    const int mesh = only_mesh(water, scene, static_cast<int>(object));
    const std::string problem = add_water(scene, mesh, placement.to_world.x, settings_of(water),
                                          limits_of(root.context().options(), scene));
    if (!problem.empty()) water.fail("cannot be: " + problem);
    if (!placement.name.empty()) scene.waters.back().name = printable(placement.name);
  }
}

}  // namespace caustics::gltf
