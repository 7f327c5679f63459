// What textures and meshes hold: cleared or kept, of several tiles and of large pages; indices.
#include <algorithm>
#include <glm/glm.hpp>

#include "pipeline/gpu/error.hpp"
#include "tests/raster/raster_bench.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

RasterBench of_format(Format format) {
  RasterBench b;
  b.definition.writes[0].format = format;
  return b;
}

}  // namespace

TEST_CASE("targets: of two channels, what nothing is drawn onto is cleared or kept in every tile") {
  // Beside each other: tiles that are drawn full, one that is drawn in part, and some where a triangle lies.
  RasterBench b = of_format(Format::RG32F);
  b.definition.writes[0].clear = {0.5f, 0.25f, 0.0f, 0.0f};
  b.width = 300;
  b.height = 40;
  Image before(Format::RG32F, b.width, b.height);
  for (std::size_t i = 0; i < before.values.size(); ++i) before.values[i] = static_cast<float>(i);
  for (const bool kept : {false, true}) {
    b.keep = {kept};
    const Image image =
        b.draw({b.at(0, 0, -7), b.at(150, 0, -7), b.at(150, 40, -7), b.at(0, 0, -7), b.at(150, 40, -7),
                b.at(0, 40, -7), b.at(280, 10, -7), b.at(290, 10, -7), b.at(280, 20, -7)},
               &before)[0];
    int drawn = 0, others = 0;
    for (int y = 0; y < b.height; ++y)
      for (int x = 0; x < b.width; ++x) {
        const glm::vec2 found(image.at(x, y, 0), image.at(x, y, 1));
        drawn += found == glm::vec2(-7.0f);
        others +=
            found == (kept ? glm::vec2(before.at(x, y, 0), before.at(x, y, 1)) : glm::vec2(0.5f, 0.25f));
      }
    CHECK(drawn > 150 * 40 + 40);
    CHECK(drawn < 150 * 40 + 60);
    CHECK(drawn + others == 300 * 40);
  }
}

TEST_CASE("targets: a large image that was uploaded is cleared or kept as any other") {
  RasterBench b = of_format(Format::RGBA32F);
  b.width = 512;
  b.height = 256;  // 2 MiB: large pages
  Image before(Format::RGBA32F, b.width, b.height);
  std::fill(before.values.begin(), before.values.end(), 3.0f);
  const std::vector<RasterVertex> corner = {b.at(500, 250, 7), b.at(512, 250, 7), b.at(512, 256, 7)};
  CHECK(b.draw(corner, &before)[0].at(0, 0, 0) == 0.0f);
  b.keep = {true};
  CHECK(b.draw(corner, &before)[0].at(0, 0, 0) == 3.0f);
}

TEST_CASE("meshes: an index beyond the vertices is refused, when a mesh is made and when it is updated") {
  RasterBench b;
  const std::vector<RasterVertex> triangle = {b.at(0, 0), b.at(8, 0), b.at(0, 8)};
  b.indices = {0, 1, 2};
  const MeshData good = b.mesh_of(triangle);
  b.indices = {0, 1, 3};
  const MeshData wrong = b.mesh_of(triangle);
  const auto device = make_software_device({.threads = 1});
  CHECK_THROWS_WITH(device->create_mesh(wrong), "a mesh's index 3 is beyond its 3 vertices");
  const MeshId mesh = device->create_mesh(good);
  CHECK_THROWS_AS(device->update(mesh, wrong), Error);
}
