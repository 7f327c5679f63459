// The ways of a lattice of grid vertices, by every estimator: each surface that their light meets, and each
// iterate of the search for it.
#pragma once
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>

#include "app/frame_options.hpp"

namespace caustics::app {

class LoadedScene;

// By index into Scene::lights what the page reads as Light.paths; none of lights that throw no caustic.
// `loaded` as the request has it.
std::map<int, nlohmann::ordered_json> vertex_paths(const FrameRequest& request,
                                                   const std::shared_ptr<LoadedScene>& loaded);

}  // namespace caustics::app
