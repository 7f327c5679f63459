// Files of images. The same texels give the same bytes: no dates, no names.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/gpu/image_view.hpp"
#include "pipeline/image_io/image_io.hpp"

namespace caustics::app {

// An 8-bit RGB picture from the first three channels of an image; its values are already encoded
// for display (sRGB). To standard output too.
void write_png(const std::filesystem::path& path, const ImageView& picture);
// Its first three channels as JPEG or TIFF, or linear values as HDR.
void write_picture(const std::filesystem::path& path, ImageFormat format, const ImageView& picture);

// Is there an image file whose head can be read, of this size? Its contents are not looked at.
bool is_image_of_size(const std::filesystem::path& path, int width, int height);

// One channel of an EXR file: a channel of an image, plus a constant where `covered_by` (a channel
// of the same image, or -1 for everywhere) is not 0.
struct ExrChannel {
  std::string name;
  const Image* image = nullptr;
  int channel = 0;
  double offset = 0.0;
  int covered_by = -1;
};

// 32-bit float, ZIP-compressed; all images have one size.
void write_exr(const std::filesystem::path& path, const std::vector<ExrChannel>& channels);

// All channels of one image, as R, G, B, A (or R; R, G; Z for depth).
std::vector<ExrChannel> channels_of(const Image& image);

}  // namespace caustics::app
