// Points larger than the driver's own are drawn whole, as quadrilaterals: on a driver that is made to look as
// if it had points of one pixel alone.
#include "pipeline/gpu/error.hpp"
#include "tests/parity/match.hpp"
#include "tests/raster/raster_bench.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

const GlOptions kTinyPoints{.measure = true, .debug = true, .largest_point = 1.0f};

// Of this size exactly: sizes at which the viewport's arithmetic is exact.
void match_points(const std::string& name, int side, float largest, bool adds) {
  Match match(kTinyPoints);
  Random random(name);
  for (int i = 0; i < 4; ++i) {
    TortureCase c = plain_case(Topology::Points, side, side);
    if (adds) {
      for (ColorWrite& write : c.definition.writes) write.blend = kAccumulate;
      c.definition.depth_state = {};
      c.definition.depth.reset();
    }
    c.vertices = random_points(random, 1000, largest);
    match.compare(c);
  }
  match.finish();
}

}  // namespace

TEST_CASE("point quads: points of every size are those of the software device") {
  match_points("quads", 256, 64.0f, false);
  match_points("small quads", 64, 8.0f, true);
}

TEST_CASE("point quads: on targets of other sizes edges differ no more than a driver's own points may") {
  const auto gl = gl_or_skip(kTinyPoints);
  const auto software = make_software_device();
  Random random("odd quads");
  TortureCase c = plain_case(Topology::Points, 333, 97);
  c.vertices = random_points(random, 3000, 64.0f);
  const TortureResult a = draw(*software, c), b = draw(*gl, c);
  CHECK(a.counts.vertices == b.counts.vertices);
  CHECK(a.counts.primitives == b.counts.primitives);
  for (std::size_t i = 0; i < a.images.size(); ++i)
    CHECK(
        judge(difference(a.images[i], b.images[i]), ImageKind::RandomDraws, DriverClass::LlvmpipeOtherPoints)
            .verdict != Verdict::Beyond);
}

TEST_CASE("point quads: the largest point that passes ask for covers all of its texels") {
  const auto gl = gl_or_skip(kTinyPoints);
  RasterBench b = counting(512, 512);
  b.definition.topology = Topology::Points;
  b.definition.cull = Cull::Front;  // points have no faces
  b.on = gl.get();
  RasterVertex point = b.at(256.5, 256.5);
  point.size = 255.0f;
  CHECK(RasterBench::sum(b.draw({point})[0]) == 255.0 * 255.0);
  CHECK(b.result.vertices == 1);
  CHECK(b.result.samples_passed == 0);
  point.size = 1000.0f;
  CHECK(RasterBench::sum(b.draw({point})[0]) == 255.0 * 255.0);
  // Triangles of the same shader are triangles still.
  b.definition.topology = Topology::Triangles;
  b.definition.cull = Cull::None;
  CHECK(RasterBench::sum(b.draw({b.at(0, 0), b.at(512, 0), b.at(0, 512)})[0]) > 512.0 * 255.0);
}

TEST_CASE("point quads: points of an indexed mesh are refused, not lost") {
  const auto gl = gl_or_skip(kTinyPoints);
  MeshData mesh{.layout = {{"position", 4}, {"color", 4}, {"size", 1}},
                .vertices = std::vector<float>(9, 1.0f)};
  mesh.indices = {0};
  PassDefinition definition{.name = "test",
                            .purpose = "test",
                            .writes = {{.name = "color", .format = Format::R32F, .meaning = "m"}},
                            .topology = Topology::Points,
                            .shader = &raster_probe_shader};
  const TextureId target = gl->create_texture(Format::R32F, 4, 4);
  const Draw draw{.mesh = gl->create_mesh(mesh)};
  CHECK_THROWS_AS(gl->run({.definition = &definition, .colors = {target}, .draws = {draw}}), Error);
}
