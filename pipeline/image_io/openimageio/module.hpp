// How the module is found, and what it is made of.
#pragma once
#include "pipeline/image_io/image_io.hpp"

namespace caustics {

inline constexpr const char* kImageIoModule = "libcaustics_image_io.so";
inline constexpr const char* kImageIoFunctions = "caustics_image_io";

namespace openimageio {

std::string decode(const ImageToDecode& image, Pixels& pixels);
std::string read_planes(const std::filesystem::path& path, const std::function<void()>& next_part,
                        ImagePlanes& planes);
bool read_size(const std::filesystem::path& path, int& width, int& height);
std::string encode(const ImageToEncode& image, std::vector<unsigned char>& bytes);

// What OpenImageIO says, without the line breaks that it may add.
std::string reason(std::string message);

}  // namespace openimageio

}  // namespace caustics
