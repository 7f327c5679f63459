// Small pictures of the same frame over one setting, for the page's sliders.
#pragma once
#include <memory>
#include <nlohmann/json_fwd.hpp>

#include "app/frame_options.hpp"
#include "app/inspect/blobs.hpp"

namespace caustics::app {

class LoadedScene;

// Over iterations, and over grid sizes: what the page reads as Run.sweeps, with each frame's stated error.
// `loaded` as the request has it.
nlohmann::ordered_json setting_sweeps(const FrameRequest& request, const std::shared_ptr<LoadedScene>& loaded,
                                      Blobs& blobs);

}  // namespace caustics::app
