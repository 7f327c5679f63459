#include "pipeline/scene/caster_texels.hpp"

#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

// Every texel of a picture tells which picture it is of, and where it lies in it.
Image told(int number, int width, int height) {
  Image image(Format::RGBA16F, width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      image.at(x, y, 0) = static_cast<float>(number);
      image.at(x, y, 1) = static_cast<float>(x);
      image.at(x, y, 2) = static_cast<float>(y);
    }
  return image;
}

}  // namespace

TEST_CASE("caster texels: each picture is there whole, and none lies on another") {
  Scene scene;
  scene.images = {told(0, 5, 3), told(1, 2, 7), told(2, 64, 64), told(3, 4, 1)};
  const CasterTexels texels = caster_texels(scene, {0, 1, 3});
  REQUIRE(texels.places.size() == 3);
  for (const auto& [index, place] : texels.places) {
    const Image& image = scene.images[static_cast<std::size_t>(index)];
    REQUIRE(place.width == image.width());
    REQUIRE(place.height == image.height());
    for (int y = 0; y < place.height; ++y)
      for (int x = 0; x < place.width; ++x)
        for (int c = 0; c < 4; ++c) CHECK(texels.image.at(place.x + x, place.y + y, c) == image.at(x, y, c));
  }
}

TEST_CASE("caster texels: where they are too many the largest picture is halved, by means of four") {
  Scene scene;
  scene.images = {told(0, 8, 8), told(1, 2, 2)};
  const CasterTexels texels = caster_texels(scene, {0, 1}, {}, 60);
  const CasterTexels::Place place = texels.places.at(0);
  REQUIRE(place.width == 4);
  REQUIRE(place.height == 4);
  CHECK(texels.image.at(place.x + 1, place.y + 2, 1) == 2.5f);
  CHECK(texels.image.at(place.x + 1, place.y + 2, 2) == 4.5f);
  CHECK(texels.places.at(1).width == 2);
}

TEST_CASE("caster texels: without pictures there is one texel") {
  CHECK(caster_texels({}, {}).image.width() == 1);
}
