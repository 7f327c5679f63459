// Images of any kind that OpenImageIO reads, as named channels of floats.
#pragma once
#include <filesystem>

#include "pipeline/image_io/image_io.hpp"

namespace caustics::app {

// ImageIo::read_planes of a plain file. Throws Error (BadInput).
ImagePlanes read_planes(const std::filesystem::path& path);

}  // namespace caustics::app
