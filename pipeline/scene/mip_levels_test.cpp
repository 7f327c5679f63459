#include "pipeline/scene/mip_levels.hpp"

#include <algorithm>
#include <utility>

#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

Image counted(int width, int height) {
  Image image(Format::RGBA32F, width, height);
  for (std::size_t i = 0; i < image.values.size(); ++i) image.values[i] = static_cast<float>(i * 7 % 64);
  return image;
}

}  // namespace

TEST_CASE("mip levels: a level's texel is the mean of four, and the levels lie side by side") {
  const Image image = counted(4, 4), levels = coarser_levels(image);
  REQUIRE(levels.width() == 3);
  REQUIRE(levels.height() == 2);
  const auto mean = [&](int x, int y, int channel) {
    return 0.25f * (image.at(x, y, channel) + image.at(x + 1, y, channel) + image.at(x, y + 1, channel) +
                    image.at(x + 1, y + 1, channel));
  };
  CHECK(levels.at(0, 0, 0) == mean(0, 0, 0));
  CHECK(levels.at(1, 1, 2) == mean(2, 2, 2));
  CHECK(levels.at(2, 0, 3) == 0.25f * (mean(0, 0, 3) + mean(2, 0, 3) + mean(0, 2, 3) + mean(2, 2, 3)));
}

TEST_CASE("mip levels: texels count by overlap where a side is odd") {
  // Five texels become two: the middle one counts half in each, of two and a half in all.
  Image image(Format::RGBA32F, 5, 1);
  for (int x = 0; x < 5; ++x) image.at(x, 0, 0) = static_cast<float>(1 << x);
  const Image levels = coarser_levels(image);
  CHECK(levels.at(0, 0, 0) == Approx((1 + 2 + 0.5 * 4) / 2.5));
  CHECK(levels.at(1, 0, 0) == Approx((0.5 * 4 + 8 + 16) / 2.5));
}

TEST_CASE("mip levels: the last is one texel, the mean of the picture, whatever its sides") {
  for (const auto& [width, height] : {std::pair{13, 7}, {1, 9}, {64, 2}, {31, 1}}) {
    const Image image = counted(width, height), levels = coarser_levels(image);
    double mean = 0.0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) mean += static_cast<double>(image.at(x, y, 1)) / (width * height);
    // Beside level 1, above the levels from the second on.
    const int count = mip_level_count(width, height);
    int above = 0;
    for (int level = 2; level < count - 1; ++level) above += std::max(1, height >> level);
    CHECK(levels.at(std::max(1, width / 2), above, 1) == Approx(mean));
  }
  CHECK(mip_level_count(1, 1) == 1);
  CHECK(mip_level_count(16384, 3) == 15);
}

TEST_CASE("mip levels: of an oblong picture each texel is the mean of the rectangle below it") {
  for (const auto& [width, height] : {std::pair{16, 2}, {2, 16}, {8, 4}, {1, 8}}) {
    const Image image = counted(width, height), levels = coarser_levels(image);
    int above = 0;  // of the levels from the second on, which stand beside the first
    for (int level = 1; level < mip_level_count(width, height); ++level) {
      const int wide = std::max(1, width >> level), high = std::max(1, height >> level);
      for (int y = 0; y < high; ++y)
        for (int x = 0; x < wide; ++x) {
          double mean = 0.0;
          for (int j = y * height / high; j < (y + 1) * height / high; ++j)
            for (int i = x * width / wide; i < (x + 1) * width / wide; ++i)
              mean += static_cast<double>(image.at(i, j, 2)) * wide * high / (width * height);
          INFO(width << "x" << height << ", level " << level << ", texel " << x << ", " << y);
          CHECK(levels.at(x + (level > 1 ? std::max(1, width / 2) : 0), above + y, 2) == Approx(mean));
        }
      if (level > 1) above += high;
    }
  }
}

TEST_CASE("mip levels: half floats stay half floats") {
  Image image(Format::RGBA16F, 2, 1);
  image.at(0, 0, 0) = stored_value(Format::RGBA16F, 1.0f / 3.0f);
  image.at(1, 0, 0) = stored_value(Format::RGBA16F, 1e-4f);
  const float mean = coarser_levels(image).at(0, 0, 0);
  CHECK(mean == stored_value(Format::RGBA16F, 0.5f * (image.at(0, 0, 0) + image.at(1, 0, 0))));
}

TEST_CASE("mip levels: made once for each image, for what is no glass") {
  Scene scene;
  scene.images = {counted(4, 4), counted(2, 2), counted(1, 1)};
  scene.materials.resize(3);
  scene.materials[0].base_color_texture.image = scene.materials[0].occlusion_texture.image = 0;
  scene.materials[1].emissive_texture.image = 2;
  scene.materials[2].transmission = 1.0f;
  scene.materials[2].normal_texture.image = 1;
  add_mip_levels(scene);
  CHECK(scene.materials[0].base_color_texture.levels == 3);
  CHECK(scene.materials[0].occlusion_texture.levels == 3);
  CHECK(scene.materials[1].emissive_texture.levels == 1);
  CHECK(scene.materials[2].normal_texture.levels == 1);
  REQUIRE(scene.coarser.size() == 3);
  CHECK(scene.coarser[0].values.size() == 3 * 2 * 4);
  CHECK(scene.coarser[1].values.empty());
  CHECK(scene.coarser[2].values.empty());
}
