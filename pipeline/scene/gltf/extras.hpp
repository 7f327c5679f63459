// What `extras` may say to us, whoever reads it.
#pragma once
#include <string>
#include <vector>

#include "pipeline/scene/gltf/cursor.hpp"
#include "pipeline/scene/gltf/nodes.hpp"
#include "pipeline/scene/scene.hpp"

namespace caustics::gltf {

// owner.extras.key, or nothing. `extras` may be anything; only objects say something.
Cursor extra(const Cursor& owner, const char* key);
// Of the node that places a mesh or else of the mesh itself, or nothing.
Cursor extra_of(const Cursor& root, const Placement& placement, const char* key);

// Fails where the object has other keys: a word that is misspelt would be left out without a word.
void check_keys(const Cursor& cursor, const std::vector<std::string>& known);

// The only one of the scene's meshes that the placement of this number put there. Fails, at `extra`, where
// there is none or are several.
int only_mesh(const Cursor& extra, const Scene& scene, int object);

}  // namespace caustics::gltf
