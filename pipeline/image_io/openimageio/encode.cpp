#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "pipeline/image_io/openimageio/module.hpp"

namespace caustics::openimageio {

namespace {

OIIO::ImageSpec spec_of(const ImageToEncode& image) {
  const bool png = image.encoding == ImageEncoding::Png;
  OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(image.channels.size()),
                       png ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT);
  spec.attribute("oiio:ColorSpace", png ? "sRGB" : "Linear");
  if (!png) {
    spec.attribute("compression", "zip");
    // OpenImageIO would put the present time here, and no two files would be equal.
    spec.attribute("DateTime", "");
    spec.channelnames = image.channels;
  }
  return spec;
}

}  // namespace

std::string encode(const ImageToEncode& image, std::vector<unsigned char>& bytes) {
  const std::string format = image.encoding == ImageEncoding::Png ? "png" : "exr";
  const OIIO::ImageSpec spec = spec_of(image);
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const auto output = OIIO::ImageOutput::create(format);
  if (!output || !output->supports("ioproxy"))
    return "this OpenImageIO cannot encode " + format + " in memory";
  output->set_ioproxy(&memory);
  if (!output->open("memory." + format, spec)) return output->geterror();
  std::vector<unsigned char> row(spec.scanline_bytes());
  for (int y = 0; y < image.height; ++y) {
    image.row(y, row.data());
    if (!output->write_scanline(y, 0, spec.format, row.data())) return output->geterror();
  }
  return output->close() ? "" : output->geterror();
}

}  // namespace caustics::openimageio
