// Creates a software device, sends an image through it, and says what it is and what OpenGL there is.
#include <cstdio>

#include "gl_backend/gl_device.hpp"
#include "passes/registry.hpp"
#include "pipeline/gpu/error.hpp"
#include "raster/software_device.hpp"

int main() {
  const auto device = caustics::make_software_device();
  caustics::Image image(caustics::Format::RGBA32F, 2, 2);
  image.at(1, 0, 2) = 0.25f;
  const caustics::TextureId texture = device->upload(image);
  const bool same = device->read_back(texture).values == image.values;
  std::printf("%s; %zu passes\n", device->description().c_str(), caustics::pass_registry().size());
  try {
    std::printf("%zu OpenGL devices\n", caustics::list_gl_devices().size());
  } catch (const caustics::Error& error) {
    std::printf("%s\n", error.what());
  }
  return same && !caustics::pass_registry().empty() ? 0 : 1;
}
