// The checked document as tinygltf's typed structures, and the bytes behind them.
//
// tinygltf sees only what it reads well: buffers' contents come from read_buffers, and images,
// materials, animations, extensions and extras are left out (they are read through Cursor where we
// need them), so that it opens no file, decodes no image and meets no unchecked number.
#pragma once
#include <tiny_gltf.h>

#include "pipeline/scene/gltf/container.hpp"

namespace caustics::gltf {

// Buffers, buffer views, accessors, meshes, nodes, scenes. check_structure must have passed.
tinygltf::Model build_model(Context& context, const Document& document, std::vector<Bytes> buffers);

}  // namespace caustics::gltf
