// What `extras` of the scene say of the haze that fills it. docs/medium.md has the keys.
#pragma once
#include "pipeline/scene/gltf/container.hpp"

namespace caustics::gltf {

// Nothing where the scene in use has no medium. Fails on values that are no medium.
Medium read_medium(Context& context, const Document& document);

}  // namespace caustics::gltf
