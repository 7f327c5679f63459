#include "gl_backend/gl_texture.hpp"

#include <algorithm>
#include <cstring>
#include <vector>

#include "gl_backend/gl_state.hpp"

namespace caustics::gl {

namespace {

// Rows that are moved at a time: at most 64 MiB, so that sizes in bytes fit OpenGL's 32 bits.
int rows_at_a_time(const ImageShape& shape) {
  const std::size_t row = bytes_per_texel(shape.format) * static_cast<std::size_t>(shape.width);
  return static_cast<int>(std::max<std::size_t>(1, (std::size_t{64} << 20) / row));
}

std::vector<std::byte> packed(Format format, const float* values, std::size_t count) {
  std::vector<std::byte> bytes(count * bytes_per_texel(format) /
                               static_cast<std::size_t>(channel_count(format)));
  if (format == Format::RGBA16F) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint16_t half = half_from_float(values[i]);
      std::memcpy(&bytes[2 * i], &half, 2);
    }
  } else if (format == Format::RGBA8) {
    for (std::size_t i = 0; i < count; ++i) bytes[i] = std::byte{unorm8_from_float(values[i])};
  } else {
    std::memcpy(bytes.data(), values, bytes.size());
  }
  return bytes;
}

void unpack(Format format, const std::vector<std::byte>& bytes, float* values, std::size_t count) {
  if (format == Format::RGBA16F) {
    for (std::size_t i = 0; i < count; ++i) {
      std::uint16_t half = 0;
      std::memcpy(&half, &bytes[2 * i], 2);
      values[i] = float_from_half(half);
    }
  } else if (format == Format::RGBA8) {
    for (std::size_t i = 0; i < count; ++i)
      values[i] = static_cast<float>(std::to_integer<int>(bytes[i])) / 255.0f;
  } else {
    std::memcpy(values, bytes.data(), count * sizeof(float));
  }
}

// Calls move(first row, rows, index of the first value, number of values) for bands of the image.
template <class Move>
void in_bands(const ImageShape& shape, Move move) {
  const std::size_t per_row =
      static_cast<std::size_t>(shape.width) * static_cast<std::size_t>(channel_count(shape.format));
  const int step = rows_at_a_time(shape);
  for (int y = 0; y < shape.height; y += step) {
    const int rows = std::min(step, shape.height - y);
    move(y, rows, per_row * static_cast<std::size_t>(y), per_row * static_cast<std::size_t>(rows));
  }
}

}  // namespace

Texture make_texture(const ImageShape& shape) {
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &id);
  Texture texture{TextureObject(id), shape};
  glTextureStorage2D(id, 1, texel_layout(shape.format).internal_format, shape.width, shape.height);
  glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTextureParameteri(id, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(id, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

void write_texels(const Texture& texture, const Image& image) {
  const ImageShape& shape = texture.shape;
  const TexelLayout layout = texel_layout(shape.format);
  in_bands(shape, [&](int y, int rows, std::size_t first, std::size_t count) {
    const std::vector<std::byte> bytes = packed(shape.format, &image.values[first], count);
    glTextureSubImage2D(texture.object.id(), 0, 0, y, shape.width, rows, layout.channels, layout.type,
                        bytes.data());
  });
}

Image read_texels(const Texture& texture) {
  const ImageShape& shape = texture.shape;
  const TexelLayout layout = texel_layout(shape.format);
  Image image(shape.format, shape.width, shape.height);
  in_bands(shape, [&](int y, int rows, std::size_t first, std::size_t count) {
    std::vector<std::byte> bytes(bytes_per_texel(shape.format) * static_cast<std::size_t>(shape.width) *
                                 static_cast<std::size_t>(rows));
    glGetTextureSubImage(texture.object.id(), 0, 0, y, 0, shape.width, rows, 1, layout.channels, layout.type,
                         static_cast<GLsizei>(bytes.size()), bytes.data());
    unpack(shape.format, bytes, &image.values[first], count);
  });
  return image;
}

}  // namespace caustics::gl
