// Full-screen passes that leave out fragments where a texture is 0: shaded square by square.
#include "tests/gl/gl_or_skip.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace caustics {
extern const Shader raster_kept_shader;
}

namespace {

// Every third texel and a few rows as a whole; one value of several that are not 0.
Image wanted(int width, int height) {
  Image image(Format::RGBA32F, width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if ((x + 2 * y) % 3 == 0 || y % 7 == 2) image.at(x, y, (x + y) % 4) = static_cast<float>(x + 1);
  return image;
}

Image drawn(Device& device, const Image& wanted) {
  const PassDefinition definition{.name = "test",
                                  .purpose = "test",
                                  .reads = {{.name = "wanted", .meaning = "m", .discards_where_zero = true}},
                                  .writes = {{.name = "numbers", .meaning = "m", .blend = kAccumulate}},
                                  .shader = &raster_kept_shader};
  return run_pass(device, definition,
                  {.width = wanted.width(),
                   .height = wanted.height(),
                   .uniforms = UniformBytes(16),
                   .textures = {wanted}})["numbers"];
}

}  // namespace

TEST_CASE("squares: each pixel whose texel is not 0 is drawn once, at tiles' ends too") {
  // Tiles are of 32 x 32 pixels.
  for (const auto& [width, height] : {std::pair{1, 1}, {3, 2}, {37, 45}, {64, 32}, {70, 9}}) {
    const Image texels = wanted(width, height);
    const Image image = drawn(*make_software_device({.threads = 1}), texels);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const bool is_drawn = texel(texels, x, y) != glm::vec4(0.0f);
        const glm::vec4 expected(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f,
                                 texels.at(x, y, 0), 1.0f);
        CHECK(texel(image, x, y) == (is_drawn ? expected : glm::vec4(0.0f)));
      }
  }
}

TEST_CASE("squares: OpenGL draws the same pixels") {
  const auto gl = gl_or_skip();
  const Image texels = wanted(37, 45);
  CHECK(drawn(*gl, texels).values == drawn(*make_software_device({.threads = 1}), texels).values);
}
