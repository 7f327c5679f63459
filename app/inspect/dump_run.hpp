// A folder of `render --dump`, or one that another renderer wrote like it, as a run of the page.
#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "app/inspect/blobs.hpp"

namespace caustics::app {

// Attachments of the same pass and name as in `beside`, a run of the page, mean what they mean there. Throws
// Error (BadInput) where the folder is no dump or an image cannot be read.
nlohmann::ordered_json dump_run(const std::filesystem::path& folder, const nlohmann::ordered_json& beside,
                                Blobs& blobs);

}  // namespace caustics::app
