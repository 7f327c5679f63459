#include "passes/walk/walk.hpp"

#include "pipeline/measure/ledger.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/light_path_bench.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// The first row with roughness 0.5, and further texels.
Image dressed(const Image& materials, const std::vector<glm::vec4>& texels) {
  Image wide(Format::RGBA32F, std::max(materials.width(), 3 + static_cast<int>(texels.size())),
             materials.height());
  for (int y = 0; y < materials.height(); ++y)
    for (int x = 0; x < materials.width(); ++x)
      for (int c = 0; c < 4; ++c) wide.at(x, y, c) = materials.at(x, y, c);
  wide.at(2, 0, 3) = 0.5f;
  for (std::size_t i = 0; i < texels.size(); ++i)
    for (int c = 0; c < 4; ++c) wide.at(3 + static_cast<int>(i), 0, c) = texels[i][c];
  return wide;
}

// Parallel light falls straight down on a slab of glass between the heights 0 and 1, over a floor at -1: body
// 1, index 1.5, so that each surface mirrors 0.04. A grid vertex, at (0.5, 1, 0.25), has 16 square metres.
// Numbers plus 1: the slab's upper triangle 1, its lower 2, the floor's 3.
struct Bench {
  BenchMaterial material{};
  int bounces = 16, splits = 2, mirrored_at = 0;
  bool draws = false, reads_hit = false;
  int side = 1;  // of the grid, whose vertices are all alike
  glm::vec3 channel_share{1.0f};
  Image second_surface{Format::RGBA32F, 1, 1};
  glm::vec3 normal{0.0f, 1.0f, 0.0f};  // smooth, of the slab's upper side
  std::vector<Corners> mirrors{};      // beside the slab: of body 2, numbered behind it
  float rough_from = 1.0f;             // the slab's roughness is 0.5
  std::vector<glm::vec4> dress{};  // further texels of the slab's row in caster_materials, from the third on
  Image caster_texels{};

  // The branch that is mirrored at this surface.
  Bench branch(int surface) const {
    Bench other = *this;
    other.mirrored_at = surface;
    other.second_surface = run()["second_hit"];
    return other;
  }

  PassImages run() const {
    Corners under = level_triangle(0.0f, -1.0f, -1.0f);
    std::swap(under[1], under[2]);
    HierarchyBench bench;
    bench.meshes.dressed = !dress.empty();
    bench.caster(mesh_of({level_triangle(1.0f, -1.0f, -1.0f), under}));
    if (!mirrors.empty()) bench.caster(mesh_of(mirrors), 1);
    bench.receiver(mesh_of({level_triangle(-1.0f, -1.0f, -1.0f)}));
    const HierarchyTables tables = bench.tables();
    const View view = down(2.0, 10.0, 20.0);
    std140::Walk u{};
    u.caster = u.receiver = u.caustic = shader_view(view);
    u.light = glm::vec3(view.forward);
    u.cell_area = 16.0f;
    u.grid_side = side;
    u.channel_share = channel_share;
    u.least_share = 1e-4f;
    u.bounces = bounces;
    u.splits = splits;
    u.mirrored_at = mirrored_at;
    u.most_steps = most_steps(bounces);
    u.first_receiver = bench.first_receiver();
    u.draws = draws ? 1 : 0;
    u.reads_hit = reads_hit || mirrored_at >= 2 ? 1 : 0;
    u.has_rough = rough_from < 1.0f ? 1 : 0;
    u.rough_from = rough_from;
    u.has_textures = dress.empty() ? 0 : 1;
    u.first_uv = first_uv(bench.scene, bench.meshes);
    return run_pass(
        definition_of(walk_pass()),
        {.width = side,
         .height = side,
         .uniforms = uniform_bytes(u),
         .textures = {filled(side, side, {0.5f, 1.0f, 0.25f, 2.0f}), filled(side, side, {normal, 0.0f}),
                      dressed(caster_materials({material, {.mirror = true}}), dress), tables.nodes,
                      tables.triangles, tables.normals, Image(Format::RGBA32F, 1, 1),
                      Image(Format::RGBA32F, 1, 1), second_surface, caster_texels}});
  }
};

LandingStatus status(const PassImages& out) {
  return static_cast<LandingStatus>(static_cast<int>(out["landing"].at(0, 0, 3)));
}

double sum_of(const Image& image) {
  double sum = 0.0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) sum += static_cast<double>(image.at(x, y, 0));
  return sum;
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
  const PassImages out = Bench{}.branch(1).run();
  CHECK(status(out) == LandingStatus::Missed);
  check_near(texel(out["landing_flux"], 0, 0), {0.64f, 0.64f, 0.64f, 0.0f});
  check_near(texel(out["landing_fresnel"], 0, 0), glm::vec4(0.0f));
  CHECK(out["landing_path"].at(0, 0, 0) == 6.0f);
}

TEST_CASE(
    "walk: the branch that is mirrored at the second surface leaves by the first, and books from there") {
  const Bench whole;
  const PassImages out = whole.branch(2).run();
  CHECK(status(out) == LandingStatus::Missed);
  // Behind the splits it takes the stronger way; the weaker is booked.
  const float mirrored = 16.0f * 0.96f * 0.04f;
  check_near(texel(out["landing_flux"], 0, 0), glm::vec4(glm::vec3(0.96f * mirrored), 0.0f));
  check_near(texel(out["landing_fresnel"], 0, 0), glm::vec4(glm::vec3(0.04f * mirrored), 0.0f));
  // Together all branches have what came.
  const PassImages through = whole.run(), first = whole.branch(1).run();
  const float sum = through["landing_flux"].at(0, 0, 0) + first["landing_flux"].at(0, 0, 0) +
                    out["landing_flux"].at(0, 0, 0) + out["landing_fresnel"].at(0, 0, 0);
  CHECK(sum == Approx(16.0).epsilon(1e-6));
}

TEST_CASE("walk: a branch that parts behind the first surface has no light where no second is met") {
  Bench bench = Bench{}.branch(2);
  bench.second_surface = Image(Format::RGBA32F, 1, 1);
  CHECK(status(bench.run()) == LandingStatus::Empty);
  CHECK(texel(bench.run()["landing_fresnel"], 0, 0) == glm::vec4(0.0f));
}

TEST_CASE("walk: a branch that parts at the second surface leaves to the other what the first absorbs") {
  Bench bench;
  bench.material.color = glm::vec3(0.5f);
  check_near(texel(bench.run()["landing_absorbed"], 0, 0), glm::vec4(glm::vec3(16.0f * 0.96f * 0.5f), 0.0f));
  check_near(texel(bench.branch(2).run()["landing_absorbed"], 0, 0), glm::vec4(0.0f));
}

TEST_CASE("walk: light that meets a caster still where it may be bent no more is given up, with its flux") {
  Bench bench;
  bench.bounces = 1;
  const PassImages out = bench.run();
  CHECK(status(out) == LandingStatus::GivenUp);
  CHECK(out["landing_flux"].at(0, 0, 0) == Approx(16.0 * 0.96));
}

TEST_CASE("walk: light that is mirrored where others go both ways parts nowhere behind, and books the rest") {
  // Three surfaces may part light; the branch that is mirrored at the second has 0.04 booked at the third.
  Bench bench;
  bench.splits = 3;
  const PassImages out = bench.branch(2).run();
  check_near(texel(out["landing_fresnel"], 0, 0), glm::vec4(glm::vec3(16.0f * 0.96f * 0.04f * 0.04f), 0.0f));
}

TEST_CASE("walk: what is drawn adds up to what the other branches leave behind, and is booked as theirs") {
  Bench bench;
  bench.splits = 0;
  bench.side = 64;
  const double left = sum_of(bench.run()["landing_fresnel"]);
  bench.draws = true;
  const PassImages drawn = bench.run();
  CHECK(sum_of(drawn["landing_fresnel"]) == Approx(-left).epsilon(0.01));
  CHECK(sum_of(drawn["landing_flux"]) == Approx(left).epsilon(0.01));
  CHECK(drawn["landing_fresnel"].at(0, 0, 3) == 0.0f);  // what entered is counted by the branch that leads
}

TEST_CASE("walk: at the first surface where ways part a third of the vertices draw the weaker one, evenly") {
  Bench bench;
  bench.splits = 0;
  bench.side = 64;
  bench.draws = true;
  const PassImages out = bench.run();
  // Mirrored at once: 0.04 of the light, three times.
  const auto parts = [&](int x, int y) {
    return out["landing_fresnel"].at(x, y, 0) == Approx(-16.0 * 0.04 * 3.0).epsilon(1e-5);
  };
  for (int y = 0; y < 64; y += 8)
    for (int x = 0; x < 64; x += 8) {
      int count = 0;
      for (int i = 0; i < 64; ++i) count += parts(x + i % 8, y + i / 8) ? 1 : 0;
      CHECK(count >= 18);
      CHECK(count <= 26);
    }
}

TEST_CASE("walk: drawn light is as wide as it is seldom") {
  // Off the slab, off a mirror above it, and through the slab: 1/3 and twice 0.96 of the vertices, so that
  // the footprint's area is 3 / 0.96^2 times the cell's.
  Bench bench;
  bench.splits = 0;
  bench.side = 64;
  bench.draws = true;
  Corners above = level_triangle(2.0f, -1.0f, -1.0f);
  std::swap(above[1], above[2]);
  bench.mirrors = {above};
  const PassImages out = bench.run();
  const float path = static_cast<float>(((((6 * 251 + 10) % 65521 * 251) + 5) % 65521 * 251 + 5) % 65521);
  int found = 0;
  for (int i = 0; i < 64 * 64; ++i) {
    if (out["landing_path"].at(i % 64, i / 64, 0) != path) continue;
    ++found;
    const glm::vec4 print = texel(out["landing_footprint"], i % 64, i / 64);
    const double wide = 64.0 * static_cast<double>(print.x);
    CHECK(wide * wide == Approx(3.0 / (0.96 * 0.96)).epsilon(1e-4));
    CHECK(out["landing_flux"].at(i % 64, i / 64, 0) == Approx(16.0 * 0.04 * 3.0).epsilon(1e-4));
  }
  CHECK(found > 1000);
}

TEST_CASE("walk: of light that goes where another branch's goes, nothing is drawn") {
  // At the first vertex the smallest number is drawn: mirrored where both ways are followed, so that it goes
  // up.
  Bench bench;
  bench.draws = true;
  const PassImages out = bench.run();
  CHECK(status(out) == LandingStatus::Empty);
  CHECK(texel(out["landing_fresnel"], 0, 0) == glm::vec4(0.0f));
  CHECK(texel(out["landing_absorbed"], 0, 0) == glm::vec4(0.0f));
}

TEST_CASE("walk: drawn light finds its second surface where a branch before it has, unless it is mirrored") {
  Bench bench;
  bench.splits = 1;
  bench.side = 64;
  const Image second = bench.run()["second_hit"];
  bench.draws = true;
  const PassImages alone = bench.run();
  bench.second_surface = second;
  bench.reads_hit = true;
  const PassImages shared = bench.run();
  for (const char* name : {"landing", "landing_flux", "landing_fresnel", "landing_path"})
    CHECK(shared[name].values == alone[name].values);
  bench.second_surface = Image(Format::RGBA32F, 64, 64);
  CHECK(bench.run()["landing"].values != alone["landing"].values);
}

TEST_CASE("walk: what is mirrored at the first surface is not taken for mirrored at the 33rd") {
  // By 45 degrees aside into a corridor of two mirrors, 6 cm high and some 2 m long: more than 32 surfaces.
  Bench bench = Bench{}.branch(1);
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

TEST_CASE("walk: half of rough glass' microfacets lean less than their width, its roughness squared") {
  // A facet that leans by 0.25, 14.036 degrees, turns light by 4.732 degrees: 0.0828 over the metre to the
  // slab's lower side.
  Bench bench;
  bench.side = 64;
  bench.rough_from = 0.2f;
  const Image hits = bench.run()["second_hit"];
  int less = 0;
  double x = 0.0, z = 0.0;
  for (int i = 0; i < 64 * 64; ++i) {
    // The lower side's corners are at (-1, -1), (3, -1) and (-1, 3).
    const glm::dvec4 hit(texel(hits, i % 64, i / 64));
    REQUIRE(hit.w == 2.0);
    const glm::dvec2 aside(4.0 * hit.x - 1.5, 4.0 * hit.y - 1.25);
    less += glm::length(aside) < 0.08278 ? 1 : 0;
    x += aside.x;
    z += aside.y;
  }
  CHECK(less / 4096.0 == Approx(0.5).epsilon(0.01));
  CHECK(std::fabs(x / 4096.0) < 0.002);
  CHECK(std::fabs(z / 4096.0) < 0.002);
}

TEST_CASE("walk: rough glass sends on what Fresnel's equations leave, but for what its microfacets mask") {
  Bench bench;
  bench.side = 64;
  bench.splits = 0;
  bench.rough_from = 0.2f;
  const PassImages out = bench.run();
  const double entered = 64.0 * 64.0 * 16.0, masked = sum_of(out["landing_absorbed"]);
  CHECK(sum_of(out["landing_flux"]) + sum_of(out["landing_fresnel"]) + masked ==
        Approx(entered).epsilon(1e-4));
  CHECK(masked > 0.0);
  CHECK(masked < 0.1 * entered);
  // As these 4096 facets do it.
  CHECK(masked / entered == Approx(0.06607).epsilon(1e-3));
}

TEST_CASE("walk: light that has met microfacets joins no cell, and is wider for those that it has not met") {
  Bench bench;
  bench.side = 8;
  bench.splits = 0;
  bench.rough_from = 0.2f;
  const auto area = [](const PassImages& out) {
    const glm::dvec4 print(texel(out["landing_footprint"], 3, 3));
    return std::fabs(print.x * print.w - print.y * print.z);
  };
  const PassImages out = bench.run();
  for (int y = 0; y < 7; ++y)
    for (int x = 0; x < 7; ++x) CHECK(out["landing_path"].at(x, y, 0) != out["landing_path"].at(x + 1, y, 0));
  bench.rough_from = 1.0f;
  // A step of the grid is 0.5 m. A width turns light by 0.083 within and 0.25 below, over a metre each: 0.33
  // m.
  CHECK(area(out) / area(bench.run()) == Approx(2.78).epsilon(0.15));
}

TEST_CASE("walk: a picture on a caster tints what enters, and none what leaves") {
  // One texel of base colour and one of transmission, side by side.
  Bench bench;
  bench.dress = {{1.0f, 1.0f, 1.0f, 0.0f},  // transmission, and no mask
                 {0, 0, 1, 1},
                 {1, 0, 0, 0},
                 {0, 1, 0, 0},  // base colour
                 {1, 0, 1, 1},
                 {1, 0, 0, 0},
                 {0, 1, 0, 0},  // transmission
                 glm::vec4(0.0f),
                 glm::vec4(0.0f),
                 glm::vec4(0.0f)};  // no normals
  bench.caster_texels = Image(Format::RGBA16F, 2, 1);
  bench.caster_texels.values = {0.5f, 0.25f, 1.0f, 1.0f, 0.5f, 0.0f, 0.0f, 1.0f};
  const PassImages out = bench.run();
  const glm::vec3 left = glm::vec3(0.5f, 0.25f, 1.0f) * (0.5f * 16.0f * 0.96f * 0.96f);
  check_near(texel(out["landing_flux"], 0, 0), glm::vec4(left, 0.0f));
}

TEST_CASE("walk: light passes a hole in a further surface as if nothing were there") {
  // The texel's opacity is below the cutoff: the lower side does not mirror, and the light goes on straight.
  Bench bench;
  bench.dress = {{1.0f, 1.0f, 1.0f, 0.5f}, {0, 0, 1, 1},    {1, 0, 0, 0},    {0, 1, 0, 0},
                 glm::vec4(0.0f),          glm::vec4(0.0f), glm::vec4(0.0f), glm::vec4(0.0f),
                 glm::vec4(0.0f),          glm::vec4(0.0f)};
  bench.caster_texels = Image(Format::RGBA16F, 1, 1);
  bench.caster_texels.values = {1.0f, 1.0f, 1.0f, 0.25f};
  const PassImages out = bench.run();
  CHECK(status(out) == LandingStatus::Landed);
  check_near(texel(out["landing_flux"], 0, 0), glm::vec4(glm::vec3(16.0f * 0.96f), 0.0f));
}

TEST_CASE("walk: a normal texture leans further surfaces") {
  // Whose lower side faces aside by 0.6 over 0.8 along the tangent, the x axis: light leaves it aside.
  Bench bench;
  bench.dress = {{1.0f, 1.0f, 1.0f, 0.0f}, glm::vec4(0.0f), glm::vec4(0.0f), glm::vec4(0.0f), glm::vec4(0.0f),
                 glm::vec4(0.0f),          glm::vec4(0.0f), {0, 0, 1, 1},    {1, 0, 0, 0},    {0, 1, 0, 0}};
  bench.caster_texels = Image(Format::RGBA16F, 1, 1);
  bench.caster_texels.values = {0.5f + 0.5f * 0.6f, 0.5f, 0.5f + 0.5f * 0.8f, 1.0f};
  const PassImages out = bench.run();
  // From within at 36.87 degrees to the normal, sin 0.6: it leaves at sin 0.9, 64.16 degrees, that is 27.29
  // degrees aside, over a fall of 1 m.
  CHECK(status(out) == LandingStatus::Landed);
  CHECK(std::fabs(static_cast<double>(out["landing"].at(0, 0, 0)) - 0.5) == Approx(0.5158).epsilon(2e-3));
}
