// Reads an environment image that the user names: Radiance .hdr or OpenEXR, told apart by content.
//
// The image is equirectangular, linear, in nit; its horizontal centre looks along -z. It becomes
// RGBA32F with alpha 1; negative and non-finite values become 0; what is wider than 8192 pixels is
// averaged down by a power of two. Throws Error(ExitCode::BadInput).
#pragma once
#include <filesystem>

#include "pipeline/scene/gltf/load_gltf.hpp"

namespace caustics {

Environment load_environment(const std::filesystem::path& path, const LoadOptions& options = {});

}  // namespace caustics
