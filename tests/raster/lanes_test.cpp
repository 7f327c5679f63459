// Lane widths, threads and batches never show: random triangles and points, seeded, hashed.
#include <algorithm>
#include <random>

#include "pipeline/gpu/error.hpp"
#include "tests/raster/raster_bench.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// Uniform in [-1, 1) from the generator's bits alone: the library's distributions differ.
float random_value(std::mt19937& bits) { return static_cast<float>(bits() >> 8) * 0x1p-23f - 1.0f; }

std::string digest(Topology topology, Compare compare, SoftwareOptions options) {
  std::mt19937 bits(20260u + static_cast<unsigned>(topology));
  RasterBench b;
  b.width = 117;
  b.height = 85;
  b.options = options;
  b.definition.topology = topology;
  b.definition.writes[0] = {.name = "a", .meaning = "m", .blend = kAccumulate};
  b.definition.depth =
      DepthWrite{.name = "depth", .meaning = "m", .clear = compare == Compare::Greater ? 0.0f : 1.0f};
  b.definition.depth_state = {compare, true};
  std::vector<RasterVertex> v(topology == Topology::Points ? 20000 : 9000);
  for (std::size_t i = 0; i < v.size(); ++i) {
    const float spread = i / 3 % 4 == 0 ? 2.5f : 1.05f;
    v[i].w = 1.0f + 0.9f * random_value(bits);
    v[i].x = spread * random_value(bits) * v[i].w;
    v[i].y = spread * random_value(bits) * v[i].w;
    v[i].z = (0.5f + 0.6f * random_value(bits)) * v[i].w;
    v[i].red = random_value(bits);
    v[i].green = 1e-38f * random_value(bits);  // denormals on the way
    v[i].size = 3.0f + 4.0f * random_value(bits);
  }
  std::string all;
  for (const Image& image : b.draw(v)) all += sha256(image);
  CHECK(b.result.fragments > 1000);
  return all;
}

}  // namespace

TEST_CASE("lanes: random triangles and points give the same bits on every width, thread count and batch") {
  for (const Topology topology : {Topology::Triangles, Topology::Points})
    for (const Compare compare : {Compare::LessEqual, Compare::Less, Compare::Greater}) {
      const std::string expected = digest(topology, compare, {.threads = 1, .lanes = Lanes::Scalar});
      for (const Lanes lanes : supported_lanes())
        for (const int threads : {1, 2, 7}) {
          INFO(lanes_name(lanes) << ", " << threads << " threads");
          CHECK(digest(topology, compare, {.threads = threads, .lanes = lanes}) == expected);
        }
      // 9000 vertices are 3000 triangles.
      for (const std::size_t batch : {1u, 999u, 1024u})
        CHECK(digest(topology, compare, {.threads = 2, .batch = batch}) == expected);
    }
}

TEST_CASE("lanes: a width that the processor lacks, and a senseless number of threads, are refused") {
  CHECK(supported_lanes().size() >= 2);
  CHECK_THROWS_AS(make_software_device({.threads = -1}), Error);
  for (int i = 0; i < kLanesCount; ++i) {
    const auto lanes = static_cast<Lanes>(i);
    const std::vector<Lanes> supported = supported_lanes();
    if (std::find(supported.begin(), supported.end(), lanes) != supported.end()) {
      CHECK_NOTHROW(make_software_device({.lanes = lanes}));
    } else {
      CHECK_THROWS_AS(make_software_device({.lanes = lanes}), Error);
    }
  }
}

TEST_CASE("device: sizes beyond the limit are refused, one texel is enough") {
  const auto device = make_software_device({.threads = 1});
  CHECK_THROWS_AS(device->create_texture(Format::R32F, 0, 1), Error);
  CHECK_THROWS_AS(device->create_texture(Format::R32F, 1, 16385), Error);
  RasterBench b;
  b.width = b.height = 1;
  CHECK(b.draw({b.at(0, 0, 4.0f), b.at(2, 0, 4.0f), b.at(0, 2, 4.0f)})[0].values == std::vector<float>{4.0f});
}

TEST_CASE("device: ids that do not exist, indices beyond the vertices and other sizes are refused") {
  const auto device = make_software_device();
  CHECK_THROWS_AS(device->read_back(static_cast<TextureId>(99)), Error);
  CHECK_THROWS_AS(device->shape(static_cast<TextureId>(99)), Error);
  MeshData mesh{.layout = {{"position", 1}}, .vertices = {1.0f}, .indices = {1}};
  CHECK_THROWS_AS(device->create_mesh(mesh), Error);
  mesh.indices = {0};
  const MeshId one = device->create_mesh(mesh);
  mesh.vertices = {2.0f};
  CHECK_NOTHROW(device->update(one, mesh));
  mesh.vertices = {2.0f, 3.0f};
  CHECK_THROWS_AS(device->update(one, mesh), Error);
  CHECK_THROWS_AS(device->update(static_cast<MeshId>(99), mesh), Error);
}
