// Lights and cameras, placed by their nodes.
// Sources: KHR_lights_punctual; glTF 2.0 sections 3.10 and 5.12-5.14.
#pragma once
#include <vector>

#include "pipeline/scene/gltf/nodes.hpp"

namespace caustics::gltf {

// `origin` is the world position of scene space's origin.
std::vector<Light> read_lights(Context& context, const Document& document,
                               const std::vector<Placement>& placements, const glm::dvec3& origin);
std::vector<Camera> read_cameras(Context& context, const Document& document,
                                 const std::vector<Placement>& placements, const glm::dvec3& origin);

}  // namespace caustics::gltf
