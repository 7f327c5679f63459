#include "passes/walk/walk.hpp"

#include "pipeline/measure/ledger.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/light_path_bench.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// Parallel light falls straight down on a slab of glass between the heights 0 and 1, over a floor at -1: body
// 1, index 1.5, so that each surface mirrors 0.04. One grid vertex, at (0.5, 1, 0.25), has 16 square metres.
// Numbers plus 1: the slab's upper triangle 1, its lower 2, the floor's 3.
struct Bench {
  BenchMaterial material{};
  int bounces = 16, splits = 2, parts_at = 0;
  unsigned mirrored = 0;
  glm::vec3 channel_share{1.0f};
  Image second_surface{Format::RGBA32F, 1, 1};
  glm::vec3 normal{0.0f, 1.0f, 0.0f};  // smooth, of the slab's upper side
  std::vector<Corners> mirrors{};      // beside the slab: of body 2, numbered behind it

  // The branch that is mirrored at these surfaces, as bits.
  Bench branch(unsigned mirrored_at, int last) const {
    Bench other = *this;
    other.mirrored = mirrored_at;
    other.parts_at = last;
    other.second_surface = run()["second_hit"];
    return other;
  }

  PassImages run() const {
    Corners under = level_triangle(0.0f, -1.0f, -1.0f);
    std::swap(under[1], under[2]);
    HierarchyBench bench;
    bench.caster(mesh_of({level_triangle(1.0f, -1.0f, -1.0f), under}));
    if (!mirrors.empty()) bench.caster(mesh_of(mirrors), 1);
    bench.receiver(mesh_of({level_triangle(-1.0f, -1.0f, -1.0f)}));
    const HierarchyTables tables = bench.tables();
    const View view = down(2.0, 10.0, 20.0);
    std140::Walk u{};
    u.caster = u.receiver = u.caustic = shader_view(view);
    u.light = glm::vec3(view.forward);
    u.cell_area = 16.0f;
    u.grid_side = 1;
    u.channel_share = channel_share;
    u.least_share = 1e-4f;
    u.bounces = bounces;
    u.splits = splits;
    u.mirrored = static_cast<int>(mirrored);
    u.parts_at = parts_at;
    u.most_steps = most_steps(bounces);
    u.first_receiver = bench.first_receiver();
    u.reads_hit = parts_at >= 2 ? 1 : 0;
    return run_pass(
        definition_of(walk_pass()),
        {.uniforms = uniform_bytes(u),
         .textures = {filled(1, 1, {0.5f, 1.0f, 0.25f, 1.0f}), filled(1, 1, {normal, 0.0f}),
                      filled(1, 1, {1.0f, 0.0f, 0.0f, 0.0f}), caster_materials({material, {.mirror = true}}),
                      tables.nodes, tables.triangles, tables.normals, Image(Format::RGBA32F, 1, 1),
                      Image(Format::RGBA32F, 1, 1), second_surface}});
  }
};

LandingStatus status(const PassImages& out) {
  return static_cast<LandingStatus>(static_cast<int>(out["landing"].at(0, 0, 3)));
}

void check_near(const glm::vec4& found, const glm::vec4& expected, double margin = 1e-5) {
  for (int c = 0; c < 4; ++c)
    CHECK(static_cast<double>(found[c]) == Approx(static_cast<double>(expected[c])).margin(margin));
}

}  // namespace

TEST_CASE("walk: light goes through a slab and lands, less what two surfaces mirror") {
  const PassImages out = Bench{}.run();
  CHECK(status(out) == LandingStatus::Landed);
  CHECK(glm::vec3(texel(out["landing"], 0, 0)) == glm::vec3(0.5f, -1.0f, 0.25f));
  const float left = 16.0f * 0.96f * 0.96f;
  check_near(texel(out["landing_flux"], 0, 0), {left, left, left, 0.0f});
  // Both mirrored parts are followed by other branches.
  check_near(texel(out["landing_fresnel"], 0, 0), {0.0f, 0.0f, 0.0f, 16.0f});
  CHECK(texel(out["landing_absorbed"], 0, 0) == glm::vec4(0.0f));
  CHECK(out["landing_path"].at(0, 0, 0) == 5.0f * 251.0f + 5.0f);  // it crosses body 1 twice
  check_near(texel(out["landing_footprint"], 0, 0), {1.0f, 0.0f, 0.0f, 1.0f});
  CHECK(texel(out["second_hit"], 0, 0).w == 2.0f);
  CHECK(texel(out["second_hit"], 0, 0).z == 1.0f);
}

TEST_CASE("walk: what is mirrored and not followed is booked at each surface, in the branch's share") {
  Bench bench;
  bench.splits = 0;
  bench.channel_share = {1.0f, 0.5f, 0.0f};
  const PassImages out = bench.run();
  const float booked = 16.0f * (0.04f + 0.96f * 0.04f);
  check_near(texel(out["landing_fresnel"], 0, 0), {booked, 0.5f * booked, 0.0f, 16.0f});
}

TEST_CASE("walk: a body's absorption on the way is booked, and is missing where the light lands") {
  Bench bench;
  bench.material.absorption = {0.0f, 0.5f, 1.0f};
  const PassImages out = bench.run();
  const glm::vec3 kept{1.0f, 0.6065307f, 0.3678794f};
  check_near(texel(out["landing_flux"], 0, 0), glm::vec4(16.0f * 0.96f * 0.96f * kept, 0.0f));
  check_near(texel(out["landing_absorbed"], 0, 0), glm::vec4(16.0f * 0.96f * (1.0f - kept), 0.0f));
}

TEST_CASE("walk: the branch that is mirrored at the first surface goes up and lands nowhere") {
  const PassImages out = Bench{}.branch(1, 1).run();
  CHECK(status(out) == LandingStatus::Missed);
  check_near(texel(out["landing_flux"], 0, 0), {0.64f, 0.64f, 0.64f, 0.0f});
  check_near(texel(out["landing_fresnel"], 0, 0), glm::vec4(0.0f));
  CHECK(out["landing_path"].at(0, 0, 0) == 6.0f);
}

TEST_CASE(
    "walk: the branch that is mirrored at the second surface leaves by the first, and books from there") {
  const Bench whole;
  const PassImages out = whole.branch(2, 2).run();
  CHECK(status(out) == LandingStatus::Missed);
  // Behind the splits it takes the stronger way; the weaker is booked.
  const float mirrored = 16.0f * 0.96f * 0.04f;
  check_near(texel(out["landing_flux"], 0, 0), glm::vec4(glm::vec3(0.96f * mirrored), 0.0f));
  check_near(texel(out["landing_fresnel"], 0, 0), glm::vec4(glm::vec3(0.04f * mirrored), 0.0f));
  // Together all branches have what came.
  const PassImages through = whole.run(), first = whole.branch(1, 1).run();
  const float sum = through["landing_flux"].at(0, 0, 0) + first["landing_flux"].at(0, 0, 0) +
                    out["landing_flux"].at(0, 0, 0) + out["landing_fresnel"].at(0, 0, 0);
  CHECK(sum == Approx(16.0).epsilon(1e-6));
}

TEST_CASE("walk: a branch that parts behind the first surface has no light where no second is met") {
  Bench bench = Bench{}.branch(2, 2);
  bench.second_surface = Image(Format::RGBA32F, 1, 1);
  CHECK(status(bench.run()) == LandingStatus::Empty);
  CHECK(texel(bench.run()["landing_fresnel"], 0, 0) == glm::vec4(0.0f));
}

TEST_CASE("walk: light that meets a caster still where it may be bent no more is given up, with its flux") {
  Bench bench;
  bench.bounces = 1;
  const PassImages out = bench.run();
  CHECK(status(out) == LandingStatus::GivenUp);
  CHECK(out["landing_flux"].at(0, 0, 0) == Approx(16.0 * 0.96));
}

TEST_CASE("walk: what is mirrored at the first surface is not taken for mirrored at the 33rd") {
  // By 45 degrees aside into a corridor of two mirrors, 6 cm high and some 2 m long: more than 32 surfaces.
  Bench bench = Bench{}.branch(1, 1);
  bench.normal = {0.3826834f, 0.9238795f, 0.0f};
  Corners above = level_triangle(2.06f, 1.0f, -1.0f);
  std::swap(above[1], above[2]);
  bench.mirrors = {level_triangle(2.0f, 1.52f, -1.0f), above};
  bench.bounces = 64;
  const PassImages out = bench.run();
  CHECK(status(out) == LandingStatus::Missed);
  CHECK(out["landing_flux"].at(0, 0, 0) == Approx(16.0 * 0.0401).epsilon(0.01));
  bench.bounces = 32;
  CHECK(status(bench.run()) == LandingStatus::GivenUp);
}
