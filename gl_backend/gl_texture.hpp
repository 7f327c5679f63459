// Textures, and moving images to and from them.
#pragma once
#include "gl_backend/gl_object.hpp"
#include "pipeline/gpu/image.hpp"

namespace caustics::gl {

struct Texture {
  TextureObject object;
  ImageShape shape;
};

// One level, nearest, clamped to the edge; undefined contents.
Texture make_texture(const ImageShape& shape);
// Values are converted here (stored_value), not by the driver.
void write_texels(const Texture& texture, const Image& image);
Image read_texels(const Texture& texture);

}  // namespace caustics::gl
