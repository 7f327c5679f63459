#include "pipeline/scene/gltf/extras.hpp"

#include <algorithm>

namespace caustics::gltf {

Cursor extra(const Cursor& owner, const char* key) {
  const Cursor extras = owner.member("extras");
  if (extras.present() && extras.json().is_object()) return extras.member(key);
  return {owner.context(), nullptr, extras.path() + "." + key};
}

Cursor extra_of(const Cursor& root, const Placement& placement, const char* key) {
  Cursor of_node = extra(root.member("nodes").element(static_cast<std::size_t>(placement.node)), key);
  if (of_node.present()) return of_node;
  return extra(root.member("meshes").element(static_cast<std::size_t>(placement.index)), key);
}

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

int only_mesh(const Cursor& extra, const Scene& scene, int object) {
  // Objects are numbered in the order of their meshes.
  const auto beginning_with = [&](int number) {
    return std::partition_point(scene.meshes.begin(), scene.meshes.end(),
                                [&](const Mesh& mesh) { return mesh.object < number; });
  };
  const auto first = beginning_with(object), end = beginning_with(object + 1);
  if (first == end) extra.fail("stands on a mesh without triangles", "take it out");
  if (end - first > 1) extra.fail("stands on a mesh of several primitives", "join them to one");
  return static_cast<int>(first - scene.meshes.begin());
}

}  // namespace caustics::gltf
