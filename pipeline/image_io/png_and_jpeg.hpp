// What nearly all textures are, by libpng and libjpeg-turbo themselves: OpenImageIO, which reads them with
// the same libraries, takes .2 s and 100 MB to load.
#pragma once
#include <cstdint>
#include <span>
#include <string>

#include "pipeline/image_io/image_io.hpp"

namespace caustics {

// Integers as they are stored; palettes become colours, their transparency and that of single colours alpha,
// and fewer than 8 bits 8. Both return what went wrong; empty: nothing did. The caller has looked at the
// size in the header.
std::string decode_png(std::span<const std::uint8_t> bytes, Pixels& pixels);

// Grey, or red, green and blue. Damaged data give what libjpeg-turbo makes of them.
std::string decode_jpeg(std::span<const std::uint8_t> bytes, Pixels& pixels);
// Four inks and unusual subsampling are left to OpenImageIO.
bool is_usual_jpeg(std::span<const std::uint8_t> bytes);

}  // namespace caustics
