#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "pipeline/image_io/openimageio/module.hpp"

namespace caustics::openimageio {

namespace {

struct Encoding {
  const char* name;  // of OpenImageIO
  OIIO::TypeDesc::BASETYPE type;
  const char* compression;
  const char* color_space;
};

Encoding encoding_of(ImageFormat format) {
  switch (format) {
    case ImageFormat::Exr:
      return {"exr", OIIO::TypeDesc::FLOAT, "zip", "Linear"};
    case ImageFormat::Hdr:
      return {"hdr", OIIO::TypeDesc::FLOAT, "", "Linear"};
    case ImageFormat::Tiff:
      // With a colour space it would get a directory of Exif data, which goes wrong in memory (2.4.7).
      return {"tiff", OIIO::TypeDesc::UINT16, "zip", ""};
    case ImageFormat::Jpeg:
      return {"jpeg", OIIO::TypeDesc::UINT8, "jpeg:92", "sRGB"};
  }
  return {};
}

OIIO::ImageSpec spec_of(const ImageToEncode& image, const Encoding& encoding) {
  OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(image.channels.size()), encoding.type);
  if (*encoding.color_space) spec.attribute("oiio:ColorSpace", encoding.color_space);
  spec.attribute("compression", encoding.compression);
  spec.attribute("jpeg:subsampling", "4:4:4");
  // OpenImageIO would put the present time here, and no two files would be equal.
  spec.attribute("DateTime", "");
  spec.channelnames = image.channels;
  return spec;
}

}  // namespace

std::string encode(const ImageToEncode& image, std::vector<unsigned char>& bytes) {
  const Encoding encoding = encoding_of(image.format);
  const OIIO::ImageSpec spec = spec_of(image, encoding);
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const auto output = OIIO::ImageOutput::create(encoding.name);
  if (!output || !output->supports("ioproxy"))
    return std::string("this OpenImageIO cannot encode ") + encoding.name + " in memory";
  output->set_ioproxy(&memory);
  if (!output->open(std::string("memory.") + encoding.name, spec)) return output->geterror();
  std::vector<float> row(static_cast<std::size_t>(image.width) * image.channels.size());
  for (int y = 0; y < image.height; ++y) {
    image.row(y, row.data());
    if (!output->write_scanline(y, 0, OIIO::TypeDesc::FLOAT, row.data())) return output->geterror();
  }
  return output->close() ? "" : output->geterror();
}

}  // namespace caustics::openimageio
