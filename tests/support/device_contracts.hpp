// What every Device promises of runs that draw into nothing or depend on an occlusion query, for the tests of
// each.
#pragma once
#include "pipeline/gpu/error.hpp"
#include "tests/raster/raster_bench.hpp"
#include "tests/support/catch.hpp"

namespace caustics {
extern const Shader raster_two_targets_shader;
}

namespace caustics::test {

// A pass into one 4 x 4 target that counts samples, and a mesh that covers all of it.
class CountedSquare {
 public:
  explicit CountedSquare(Device& device) : device_(device) {
    bench_.width = bench_.height = 4;
    bench_.definition.count_samples = true;
    bench_.definition.writes[0].clear = {0.5f, 0.0f, 0.0f, 0.0f};
    MeshData mesh;
    mesh.layout = {{"position", 4}, {"color", 4}, {"size", 1}};
    for (const RasterVertex& v : {bench_.at(0, 0, 2.0f), bench_.at(8, 0, 2.0f), bench_.at(0, 8, 2.0f)})
      for (const float f : {v.x, v.y, v.z, v.w, v.red, v.green, v.blue, v.alpha, v.size})
        mesh.vertices.push_back(f);
    mesh_ = device.create_mesh(mesh);
    target_ = device.create_texture(Format::R32F, 4, 4);
  }

  // Draws it that many times, and returns what the first texel holds.
  float draw(std::size_t times, OcclusionQuery counts_into, OcclusionQuery only_if) {
    PassRun run{.definition = &bench_.definition, .colors = {target_}};
    run.draws.assign(times, Draw{.mesh = mesh_});
    run.counts_into = counts_into;
    run.only_if = only_if;
    result_ = device_.run(run);
    return device_.read_back(target_).at(0, 0, 0);
  }
  const PassResult& result() const { return result_; }

 private:
  Device& device_;
  RasterBench bench_;
  MeshId mesh_{};
  TextureId target_{};
  PassResult result_;
};

// `measures`: the device was asked to, and can tell what was left out.
inline void check_occlusion_queries(Device& device, bool measures) {
  constexpr auto kNone = OcclusionQuery::None;
  constexpr OcclusionQuery kFirst{1}, kSecond{2}, kUnknown{3};
  CountedSquare square(device);
  CHECK(square.draw(1, kFirst, kNone) == 2.0f);
  CHECK(square.draw(0, kSecond, kNone) == 0.5f);
  // 16 samples in the first, none in the second.
  CHECK(square.draw(1, kNone, kFirst) == 2.0f);
  CHECK_FALSE(square.result().left_out);
  CHECK(square.draw(1, kNone, kSecond) == 0.5f);
  CHECK(square.result().left_out == measures);
  CHECK(square.draw(1, kNone, kUnknown) == 2.0f);
  CHECK_FALSE(square.result().left_out);
  // Counted anew, the same query decides the other way.
  CHECK(square.draw(1, kSecond, kNone) == 2.0f);
  CHECK(square.draw(1, kNone, kSecond) == 2.0f);
  // A run may count where its own drawing depends on another query.
  CHECK(square.draw(0, kFirst, kNone) == 0.5f);
  CHECK(square.draw(1, kSecond, kFirst) == 0.5f);
  CHECK(square.draw(1, kNone, kSecond) == 0.5f);
}

inline void check_absent_targets(Device& device) {
  RasterBench bench;
  bench.width = bench.height = 4;
  bench.definition.shader = &raster_two_targets_shader;
  bench.definition.writes = {{.name = "a", .meaning = "m"}, {.name = "b", .meaning = "m"}};
  bench.on = &device;
  const auto triangle = {bench.at(0, 0, 1.0f), bench.at(8, 0, 2.0f), bench.at(0, 8, 3.0f)};
  const std::vector<Image> both = bench.draw(triangle);
  for (const std::size_t absent : {0u, 1u}) {
    bench.absent = {absent == 0, absent == 1};
    const std::vector<Image> one = bench.draw(triangle);
    REQUIRE(one.size() == 1);
    CHECK(one[0].values == both[1 - absent].values);
  }
  bench.absent = {true, true};
  CHECK_THROWS_AS(bench.draw(triangle), Error);
}

}  // namespace caustics::test
