#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>

#include "pipeline/image_io/openimageio/module.hpp"

namespace caustics::openimageio {

namespace {

// Reads all pixels in rows from the top.
bool read_pixels(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, bool floats, Pixels& pixels) {
  pixels.width = spec.width;
  pixels.height = spec.height;
  pixels.channels = spec.nchannels;
  const std::size_t count = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) *
                            static_cast<std::size_t>(spec.nchannels);
  if (floats) {
    pixels.floats.resize(count);
    return input.read_image(0, 0, 0, -1, OIIO::TypeDesc::FLOAT, pixels.floats.data());
  }
  if (spec.format == OIIO::TypeDesc::UINT16) {
    pixels.largest = 65535;
    pixels.integers.resize(count);
    return input.read_image(0, 0, 0, -1, OIIO::TypeDesc::UINT16, pixels.integers.data());
  }
  // Read as the bytes they are, so that no conversion of the library touches them.
  pixels.bytes.resize(count);
  return input.read_image(0, 0, 0, -1, OIIO::TypeDesc::UINT8, pixels.bytes.data());
}

// OpenImageIO's WebP reader multiplies by alpha whatever it is asked for: undone, to the bits that are left.
void divide_by_alpha(Pixels& pixels) {
  const auto channels = static_cast<std::size_t>(pixels.channels);
  for (std::size_t texel = 0; texel + channels <= pixels.bytes.size(); texel += channels) {
    const unsigned alpha = pixels.bytes[texel + channels - 1];
    for (std::size_t c = 0; alpha > 0 && c + 1 < channels; ++c) {
      const unsigned divided = (pixels.bytes[texel + c] * 255u + alpha / 2) / alpha;
      pixels.bytes[texel + c] = static_cast<std::uint8_t>(std::min(divided, 255u));
    }
  }
}

}  // namespace

std::string decode(const ImageToDecode& image, Pixels& pixels) {
  const auto input = OIIO::ImageInput::create(image.format);
  if (!input) return "cannot be decoded: OpenImageIO lacks " + image.format + " (" + OIIO::geterror() + ")";
  OIIO::Filesystem::IOMemReader reader(const_cast<std::uint8_t*>(image.bytes.data()), image.bytes.size());
  OIIO::Filesystem::IOProxy* proxy = &reader;
  OIIO::ImageSpec config, spec;
  config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
  config.attribute("oiio:UnassociatedAlpha", 1);  // glTF's alpha is not premultiplied
  if (!input->open("memory." + image.format, spec, config)) {
    return "cannot be decoded: " + reason(input->geterror());
  }
  if (spec.nchannels < 1 || spec.nchannels > 64 || spec.depth > 1) {
    return "has " + std::to_string(spec.nchannels) + " channels";
  }
  std::string refusal = image.refusal(spec.width, spec.height, spec.nchannels);
  if (!refusal.empty()) return refusal;
  if (!read_pixels(*input, spec, image.floats, pixels))
    return "cannot be decoded: " + reason(input->geterror());
  const bool multiplied = image.format == "webp" && spec.alpha_channel >= 0 &&
                          spec.get_int_attribute("oiio:UnassociatedAlpha") == 0;
  if (multiplied) divide_by_alpha(pixels);
  return "";
}

}  // namespace caustics::openimageio
