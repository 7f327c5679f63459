#include "pipeline/scene/gltf/water.hpp"

namespace caustics::gltf {

namespace {

// `extras` may be anything; only objects say something about water.
Cursor extra(const Cursor& owner) {
  const Cursor extras = owner.member("extras");
  if (extras.present() && extras.json().is_object()) return extras.member("water");
  return {owner.context(), nullptr, extras.path() + ".water"};
}

// A word that is misspelt would be left out without a word.
void check_keys(const Cursor& cursor, const std::vector<std::string>& known) {
  for (const std::string& key : cursor.keys()) {
    bool found = false;
    for (const std::string& name : known) found = found || name == key;
    if (found) continue;
    std::string names;
    for (const std::string& name : known) names += (names.empty() ? "" : ", ") + name;
    cursor.member(key).fail("is not known", "use " + names);
  }
}

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
  s.seed = static_cast<std::uint64_t>(plops.member("seed").integer(
      0, std::int64_t{1} << 53, static_cast<std::int64_t>(s.seed)));
  return s;
}

// The mesh that a node put into the scene.
int only_mesh(const Cursor& water, const Scene& scene, int object) {
  int found = -1;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    if (scene.meshes[i].object != object) continue;
    if (found >= 0) water.fail("stands on a mesh of several primitives", "join them to one");
    found = static_cast<int>(i);
  }
  if (found < 0) water.fail("stands on a mesh without triangles", "take it out");
  return found;
}

}  // namespace

void read_waters(const Cursor& root, const std::vector<Placement>& placements, Scene& scene) {
  for (std::size_t object = 0; object < placements.size(); ++object) {
    const Placement& placement = placements[object];
    const Cursor of_node =
        extra(root.member("nodes").element(static_cast<std::size_t>(placement.node)));
    const Cursor water =
        of_node.present()
            ? of_node
            : extra(root.member("meshes").element(static_cast<std::size_t>(placement.index)));
    if (!water.present()) continue;
    if (!water.json().is_object()) water.fail("is no object", "write \"water\": {} for the defaults");
    const int mesh = only_mesh(water, scene, static_cast<int>(object));
    const std::string problem = add_water(scene, mesh, placement.to_world.x, settings_of(water));
    if (!problem.empty()) water.fail("cannot be: " + problem);
    if (!placement.name.empty()) scene.waters.back().name = printable(placement.name);
  }
}

}  // namespace caustics::gltf
