// What happened to single texels: replay_fragments draws them again, fragment by fragment.
#include <random>

#include "raster/texel_history.hpp"
#include "tests/raster/raster_bench.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A run whose textures stay, so that it can be drawn again.
struct Replay {
  std::unique_ptr<Device> device = make_software_device({.threads = 1});
  PassRun run;
  TargetsBefore before;

  Replay(const RasterBench& bench, const std::vector<RasterVertex>& vertices, const Image* kept = nullptr) {
    MeshData mesh;
    mesh.layout = {{"position", 4}, {"color", 4}, {"size", 1}};
    for (const RasterVertex& v : vertices)
      for (const float f : {v.x, v.y, v.z, v.w, v.red, v.green, v.blue, v.alpha, v.size})
        mesh.vertices.push_back(f);
    run.definition = &bench.definition;
    run.colors = {kept
                      ? device->upload(*kept)
                      : device->create_texture(bench.definition.writes[0].format, bench.width, bench.height)};
    if (bench.definition.depth)
      run.depth = device->create_texture(Format::Depth32F, bench.width, bench.height);
    if (kept) {
      run.keep = {true};
      before.colors = {*kept};
    }
    Draw draw;
    draw.mesh = device->create_mesh(mesh);
    run.draws.push_back(draw);
    device->run(run);
  }

  std::vector<FragmentOnTexel> at(const TexelRectangle& where) const {
    std::vector<FragmentOnTexel> fragments;
    replay_fragments(*device, run, before, where,
                     [&](const FragmentOnTexel& fragment) { fragments.push_back(fragment); });
    return fragments;
  }
};

// Triangles over the whole target of these values at these depths, in order.
std::vector<RasterVertex> layers(const RasterBench& b, const std::vector<std::pair<float, float>>& list) {
  std::vector<RasterVertex> v;
  for (const auto& [value, z] : list) {
    v.push_back(b.at(0, 0, value, z));
    v.push_back(b.at(2 * b.width, 0, value, z));
    v.push_back(b.at(0, 2 * b.height, value, z));
  }
  return v;
}

RasterBench nearest_first() {
  RasterBench b;
  b.definition.depth = DepthWrite{.name = "depth", .meaning = "m", .clear = 1.0f};
  b.definition.depth_state = {Compare::Less, true};
  return b;
}

}  // namespace

TEST_CASE("history: what is added, with the values before and after") {
  const RasterBench b = counting();
  const std::vector<FragmentOnTexel> f =
      Replay(b, layers(b, {{1.0f, 0.5f}, {2.0f, 0.5f}, {4.0f, 0.5f}})).at({3, 5});
  REQUIRE(f.size() == 3);
  const float before[] = {0.0f, 1.0f, 3.0f}, given[] = {1.0f, 2.0f, 4.0f};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(f[i].x == 3);
    CHECK(f[i].y == 5);
    CHECK(f[i].primitive == i);
    CHECK(f[i].outcome == FragmentOutcome::Passed);
    CHECK(f[i].depth == 0.0f);  // without a depth attachment
    CHECK(f[i].before[0][0] == before[i]);
    CHECK(f[i].given[0][0] == given[i]);
    CHECK(f[i].after[0][0] == before[i] + given[i]);
  }
}

TEST_CASE("history: what lies behind fails the depth test, and is told with both depths") {
  const RasterBench b = nearest_first();
  const std::vector<FragmentOnTexel> f =
      Replay(b, layers(b, {{1.0f, 0.5f}, {2.0f, 0.75f}, {4.0f, 0.25f}})).at({0, 0});
  REQUIRE(f.size() == 3);
  CHECK(f[0].outcome == FragmentOutcome::Passed);
  CHECK(f[0].depth_before == 1.0f);
  CHECK(f[1].outcome == FragmentOutcome::Behind);
  CHECK(f[1].depth == 0.75f);
  CHECK(f[1].depth_before == 0.5f);
  CHECK(f[1].given[0][0] == 2.0f);
  CHECK(f[1].after[0][0] == 1.0f);
  CHECK(f[2].outcome == FragmentOutcome::Passed);
  CHECK(f[2].after[0][0] == 4.0f);
}

TEST_CASE("history: a fragment that the shader discards changes nothing") {
  RasterBench b;
  b.definition.shader = &raster_discard_shader;
  const std::vector<FragmentOnTexel> f = Replay(b, layers(b, {{0.0f, 0.5f}, {1.0f, 0.5f}})).at({2, 2});
  REQUIRE(f.size() == 2);
  CHECK(f[0].outcome == FragmentOutcome::Discarded);
  CHECK(f[0].after[0][0] == f[0].before[0][0]);
  CHECK(f[1].outcome == FragmentOutcome::Passed);
}

TEST_CASE("history: it begins with what the target held") {
  const RasterBench b = counting();
  Image held(Format::R32F, b.width, b.height);
  held.at(3, 5, 0) = 7.0f;
  const std::vector<FragmentOnTexel> f = Replay(b, layers(b, {{1.0f, 0.5f}}), &held).at({3, 5});
  REQUIRE(f.size() == 1);
  CHECK(f[0].before[0][0] == 7.0f);
  CHECK(f[0].after[0][0] == 8.0f);
}

TEST_CASE("history: values are rounded to the target's format") {
  RasterBench b = counting();
  b.definition.writes[0].format = Format::RGBA16F;
  // Half floats between 1 and 2 are 2^-10 apart.
  const std::vector<FragmentOnTexel> f = Replay(b, layers(b, {{1.0f + 0x1p-12f, 0.5f}})).at({1, 1});
  REQUIRE(f.size() == 1);
  CHECK(f[0].given[0][0] == 1.0f);
}

TEST_CASE("history: of a triangle that is cut by the near plane, both parts have its number") {
  RasterBench b;
  std::vector<RasterVertex> v = layers(b, {{1.0f, 0.5f}, {2.0f, 0.5f}});
  v[3].z = -0.5f;  // of the second triangle
  for (const FragmentOnTexel& f : Replay(b, v).at({0, 0, b.width, b.height}))
    CHECK(f.primitive == (f.given[0][0] == 1.0f ? 0u : 1u));
}

TEST_CASE("history: only what covers the texel is told") {
  RasterBench b;
  const std::vector<RasterVertex> v = {b.at(0, 0), b.at(4, 0), b.at(0, 4)};
  CHECK(Replay(b, v).at({0, 0}).size() == 1);
  CHECK(Replay(b, v).at({7, 7}).empty());
}

TEST_CASE("history: ends with what was rendered, of many random triangles, on every texel") {
  RasterBench b = nearest_first();
  b.width = 70;  // three tiles, the last one narrow
  b.height = 40;
  std::mt19937 random(5);
  std::vector<RasterVertex> v;
  for (int i = 0; i < 3 * 200; ++i)
    v.push_back(b.at(static_cast<double>(random() % 900) / 10.0 - 10.0,
                     static_cast<double>(random() % 600) / 10.0 - 10.0, static_cast<float>(random() % 1000),
                     static_cast<float>(random() % 1000) / 1000.0f));
  const Replay replay(b, v);
  Image last(Format::R32F, b.width, b.height);
  std::size_t behind = 0;
  for (const FragmentOnTexel& f : replay.at({0, 0, b.width, b.height})) {
    CHECK(f.before[0][0] == last.at(f.x, f.y, 0));
    last.at(f.x, f.y, 0) = f.after[0][0];
    behind += f.outcome == FragmentOutcome::Behind;
  }
  CHECK(behind > 100);
  CHECK(last.values == replay.device->read_back(replay.run.colors[0]).values);
}
