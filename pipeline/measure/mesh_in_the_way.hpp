// What keeps light from a caster, by name instead of as "something".
#pragma once
#include "pipeline/scene/scene.hpp"

namespace caustics {

// Of the straight ways from the scene's lights to some points of this mesh, what most of them meet before it:
// an index into Scene::meshes, -1 where nothing stands before it. The scene must have its vertices.
int mesh_in_the_way(const Scene& scene, int caster);

}  // namespace caustics
