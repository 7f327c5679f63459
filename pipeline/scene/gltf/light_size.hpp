// What `extras` say of a light's size, which KHR_lights_punctual leaves out. docs/lights.md has the
// keys.
#pragma once
#include "pipeline/scene/gltf/nodes.hpp"

namespace caustics::gltf {

// Reads `extras` of the light and of its node, which counts more. Fails on values that are no size.
void read_size(Context& context, const Cursor& cursor, const Cursor& node, const exact::Affine& to_world,
               Light& light);

}  // namespace caustics::gltf
