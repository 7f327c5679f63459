#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "pipeline/image_io/openimageio/module.hpp"

namespace caustics::openimageio {

namespace {

OIIO::ImageSpec spec_of(const ImageToEncode& image) {
  OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(image.channels.size()),
                       OIIO::TypeDesc::FLOAT);
  spec.attribute("oiio:ColorSpace", "Linear");
  spec.attribute("compression", "zip");
  // OpenImageIO would put the present time here, and no two files would be equal.
  spec.attribute("DateTime", "");
  spec.channelnames = image.channels;
  return spec;
}

}  // namespace

std::string encode_exr(const ImageToEncode& image, std::vector<unsigned char>& bytes) {
  const OIIO::ImageSpec spec = spec_of(image);
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const auto output = OIIO::ImageOutput::create("exr");
  if (!output || !output->supports("ioproxy")) return "this OpenImageIO cannot encode exr in memory";
  output->set_ioproxy(&memory);
  if (!output->open("memory.exr", spec)) return output->geterror();
  std::vector<float> row(static_cast<std::size_t>(image.width) * image.channels.size());
  for (int y = 0; y < image.height; ++y) {
    image.row(y, row.data());
    if (!output->write_scanline(y, 0, spec.format, row.data())) return output->geterror();
  }
  return output->close() ? "" : output->geterror();
}

}  // namespace caustics::openimageio
