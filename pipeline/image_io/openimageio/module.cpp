#include "pipeline/image_io/openimageio/module.hpp"

#include <OpenImageIO/oiioversion.h>

#include <algorithm>

namespace caustics::openimageio {

std::string reason(std::string message) {
  while (!message.empty() && (message.back() == '\n' || message.back() == '.')) message.pop_back();
  std::replace(message.begin(), message.end(), '\n', ' ');
  return message.empty() ? "the data are damaged" : message;
}

}  // namespace caustics::openimageio

extern "C" const caustics::ImageIo& caustics_image_io() {
  using namespace caustics;
  static constexpr ImageIo functions{OIIO_VERSION_STRING, openimageio::decode, openimageio::read_planes,
                                     openimageio::read_size, openimageio::encode};
  return functions;
}
