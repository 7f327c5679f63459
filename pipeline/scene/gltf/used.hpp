// What the shown scene of a file uses. The rest of the file is neither checked nor read, so it cannot be a
// reason to refuse the file, and takes no memory.
#pragma once
#include <vector>

#include "pipeline/scene/gltf/container.hpp"

namespace caustics::gltf {

// Of each element of the document's arrays, whether it is reached from the nodes of the scene that is shown,
// or from the chosen animation. An element may count as used that is not, such as the texture of an extension
// that is ignored; never the other way round: what is not marked here stays empty in the Model.
struct Used {
  std::vector<bool> scenes, nodes, meshes, skins, materials, textures, images, accessors, views, buffers;
};

// References that lead nowhere are passed over: check_structure refuses them where they are used. Throws
// Error (WrongUsage) for an unknown LoadOptions::animation.
Used used_by_scene(const Context& context, const Document& document);

}  // namespace caustics::gltf
