// Which file was it? Path, size and hash, so that a later study knows whether it is still the same.
#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>

namespace caustics::study {

// { "path", "bytes", "sha256" }. Throws Error (BadInput).
nlohmann::ordered_json fingerprint(const std::filesystem::path& path);
// The same of a scene; a .gltf has "files" with those that it names by uri.
nlohmann::ordered_json scene_fingerprint(const std::filesystem::path& path);

}  // namespace caustics::study
