// Checks the structure of a glTF document before anything is built from it: versions, required
// extensions, types, ranges, references, and that every accessor lies inside its view and buffer.
//
// What passes can be read without further bounds checks, except the values that accessors hold.
// Source: glTF 2.0 section 5 (properties reference).
#pragma once
#include "pipeline/scene/gltf/used.hpp"

namespace caustics::gltf {

// asset.version, extensionsRequired (fails on what we lack), extensionsUsed (notes what is
// ignored).
void check_extensions(Context& context, const Document& document);

// Of what is used: buffers and their views, accessors, meshes, nodes, scenes and images.
void check_structure(const Context& context, const Document& document, const Used& used);

}  // namespace caustics::gltf
