#include <algorithm>

#include "passes/landing/landing.hpp"
#include "pipeline/measure/ledger.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/light_path_bench.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A floor at height 0, which the light's receiver map and the hierarchy know alike, unless they are told
// otherwise; both maps see 8 x 8 m from above. Number 1 is a caster's triangle, 2 the floor's.
struct Bench {
  View view = down(4.0, 10.0, 20.0);
  BenchPath path{.start = {0.5f, 1.0f, 0.25f}};
  glm::vec4 hit{0.25f, 0.25f, 1.0f, 2.0f};  // as hit_texel.glsl has it
  BenchMaterial material{};                 // of body 1
  Image receiver = level_map(0.0f);
  Corners floor = level_triangle(0.0f, -1.0f, -1.0f);
  glm::vec3 channel_share{1.0f};
  int can_be_hidden = 0;  // by other receivers, from the light
  glm::vec3 light{0.0f};

  // What the receiver map holds of a floor at this height.
  static Image level_map(float height) {
    Image image(Format::RGBA32F, 64, 64);
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        image.at(x, y, 0) = -4.0f + (static_cast<float>(x) + 0.5f) / 8.0f;
        image.at(x, y, 1) = height;
        image.at(x, y, 2) = 4.0f - (static_cast<float>(y) + 0.5f) / 8.0f;
        image.at(x, y, 3) = 1.0f;
      }
    return image;
  }

  PassImages run() const {
    const HierarchyTables tables =
        HierarchyBench{}.caster(mesh_of({level_triangle(0.5f)})).receiver(mesh_of({floor})).tables();
    std140::Walk u{};
    u.receiver = u.caustic = shader_view(view);
    u.channel_share = channel_share;
    u.first_receiver = 1;
    u.can_be_hidden = can_be_hidden;
    u.light = light;
    std::vector<Image> textures = path.textures();
    for (const Image& image :
         {filled(1, 1, hit), caster_materials({material}), tables.triangles, tables.normals, receiver})
      textures.push_back(image);
    return run_pass(
        part_of_walk(walk_land_shader,
                     {"start_before", "direction_before", "flux_before", "media_before", "width_before",
                      "spread_before", "hit_ahead", "caster_materials", "hierarchy_triangles",
                      "hierarchy_normals", "receiver_position"},
                     {"landing", "landing_flux", "landing_absorbed", "landing_path", "landing_footprint"}),
        {.uniforms = uniform_bytes(u), .textures = textures});
  }
};

LandingStatus status(const PassImages& out) {
  return static_cast<LandingStatus>(static_cast<int>(out["landing"].at(0, 0, 3)));
}
glm::vec3 landing(const PassImages& out) { return glm::vec3(texel(out["landing"], 0, 0)); }

void check_near(const glm::vec4& found, const glm::vec4& expected, double margin = 1e-6) {
  for (int c = 0; c < 4; ++c)
    CHECK(static_cast<double>(found[c]) == Approx(static_cast<double>(expected[c])).margin(margin));
}

}  // namespace

TEST_CASE(
    "walk: landed, light comes down where the hierarchy has met the floor, with its flux and its path") {
  Bench bench;
  bench.path.flux = {1.0f, 0.5f, 0.25f};
  bench.path.path = 1234.0f;
  bench.channel_share = {1.0f, 1.0f, 0.5f};
  const PassImages out = bench.run();
  CHECK(status(out) == LandingStatus::Landed);
  CHECK(landing(out) == glm::vec3(0.5f, 0.0f, 0.25f));
  CHECK(texel(out["landing_flux"], 0, 0) == glm::vec4(1.0f, 0.5f, 0.125f, 0.0f));
  CHECK(texel(out["landing_absorbed"], 0, 0) == glm::vec4(0.0f));
  CHECK(out["landing_path"].at(0, 0, 0) == 1234.0f);
}

TEST_CASE(
    "walk: landed, what lands where the light does not see is told apart where receivers may hide others") {
  Bench bench;
  bench.can_be_hidden = 1;
  CHECK(status(bench.run()) == LandingStatus::Landed);
  bench.receiver = Bench::level_map(3.0f);
  CHECK(status(bench.run()) == LandingStatus::NotConverged);
  CHECK(landing(bench.run()) == glm::vec3(0.5f, 0.0f, 0.25f));
  bench.receiver = Bench::level_map(0.9f);  // texels of 1/8 m: less than eight off
  CHECK(status(bench.run()) == LandingStatus::Landed);
  bench.can_be_hidden = 0;
  bench.receiver = Image(Format::RGBA32F, 64, 64);
  CHECK(status(bench.run()) == LandingStatus::Landed);
  bench.hit = glm::vec4(0.0f);
  CHECK(status(bench.run()) == LandingStatus::Missed);
}

TEST_CASE("walk: landed, light that meets nothing is missed") {
  Bench bench;
  bench.hit = glm::vec4(0.0f);
  const PassImages out = bench.run();
  CHECK(status(out) == LandingStatus::Missed);
  CHECK(out["landing_flux"].at(0, 0, 0) == 1.0f);
}

TEST_CASE("walk: landed, light that is left on its way to a further caster is given up") {
  Bench bench;
  bench.hit.w = 1.0f;
  CHECK(status(bench.run()) == LandingStatus::GivenUp);
  CHECK(bench.run()["landing_flux"].at(0, 0, 0) == 1.0f);
}

TEST_CASE("walk: landed, light that has ended, or whose walk took too long, is given up at once") {
  Bench ended;
  ended.path.mark = kEnded;
  CHECK(status(ended.run()) == LandingStatus::GivenUp);
  ended.hit.w = 1.0f;
  CHECK(status(ended.run()) == LandingStatus::GivenUp);
  Bench lost;
  lost.hit = {0.0f, 0.0f, 0.0f, HIT_GIVEN_UP};
  CHECK(status(lost.run()) == LandingStatus::GivenUp);
}

TEST_CASE("walk: landed, light that comes down beside the caustic map is outside") {
  Bench bench;
  bench.path.start.x = 5.0f;
  const PassImages out = bench.run();
  CHECK(status(out) == LandingStatus::Outside);
  CHECK(landing(out) == glm::vec3(5.0f, 0.0f, 0.25f));
}

TEST_CASE("walk: landed, water that lies on the floor absorbs down to the landing, by exp(-a d)") {
  Bench bench;
  bench.path.media = {1.0f, 0.0f, 0.0f, 0.0f};
  bench.material.absorption = {0.0f, 1.0f, 4.0f};
  PassImages out = bench.run();
  check_near(texel(out["landing_flux"], 0, 0), {1.0f, 0.3678794f, 0.0183156f, 0.0f}, 1e-5);
  check_near(texel(out["landing_absorbed"], 0, 0), {0.0f, 0.6321206f, 0.9816844f, 0.0f}, 1e-5);
  // exp(-20) is less than a millionth.
  bench.material.absorption = glm::vec3(20.0f);
  CHECK(status(bench.run()) == LandingStatus::Absorbed);
  // What lands nowhere has gone no known way.
  bench.hit = glm::vec4(0.0f);
  out = bench.run();
  CHECK(status(out) == LandingStatus::Missed);
  CHECK(out["landing_flux"].at(0, 0, 0) == 1.0f);
}

TEST_CASE("walk: landed, vertical light's footprint is the grid's step in parts of the map, on any slope") {
  // 0.5 m and 0.25 m of 8; the map's up is -z.
  Bench bench;
  bench.path.width_x = {0.5f, 0.0f, 0.0f};
  bench.path.width_y = {0.0f, 0.0f, -0.25f};
  check_near(texel(bench.run()["landing_footprint"], 0, 0), {0.0625f, 0.0f, 0.0f, 0.03125f});
  bench.floor[2].y += 3.0f;
  check_near(texel(bench.run()["landing_footprint"], 0, 0), {0.0625f, 0.0f, 0.0f, 0.03125f});
}

TEST_CASE("walk: landed, a footprint has grown by the spread on the flight, and lies slanted on the floor") {
  // 0.5 m less 0.25 rad over 1 m; and turned inside out behind a focus.
  Bench bench;
  bench.path.width_x = {0.5f, 0.0f, 0.0f};
  bench.path.spread_x = {-0.25f, 0.0f, 0.0f};
  bench.path.spread_y = {0.0f, 0.0f, -1.0f};
  check_near(texel(bench.run()["landing_footprint"], 0, 0), {0.03125f, 0.0f, 0.0f, 0.125f}, 1e-5);
  bench.path.spread_x = {-0.75f, 0.0f, 0.0f};
  CHECK(bench.run()["landing_footprint"].at(0, 0, 0) == Approx(-0.03125).epsilon(1e-4));
  // At 45 degrees 0.5 m across are 0.5 / cos 45 on the floor.
  const float half = 0.70710678f;
  Bench slanted;
  slanted.path.direction = {half, -half, 0.0f};
  slanted.path.width_x = 0.5f * glm::vec3(half, half, 0.0f);
  slanted.path.width_y = {0.0f, 0.0f, -0.25f};
  slanted.hit.z = 1.4142136f;
  check_near(texel(slanted.run()["landing_footprint"], 0, 0), {0.0625f / half, 0.0f, 0.0f, 0.03125f}, 1e-5);
}

TEST_CASE("walk: landed, in the map of light from a point a footprint is a part of its tangents") {
  // 0.5 m at 10 m, of a window of 2 x 2. Off the axis a step towards the light counts too: on a floor that
  // rises by 1 along x, at x / z = 0.05, it is 0.5 (1 + 0.05) / 10.
  Bench bench;
  bench.view = down(1.0, 10.0, 20.0);
  bench.view.perspective = true;
  bench.view.near = 0.1;
  bench.path.width_x = {0.5f, 0.0f, 0.0f};
  bench.path.width_y = {0.0f, 0.0f, -0.25f};
  bench.receiver = Image(Format::RGBA32F, 64, 64);
  check_near(texel(bench.run()["landing_footprint"], 0, 0), {0.025f, 0.0f, 0.0f, 0.0125f});
  bench.path.start.z = 0.0f;
  bench.floor[2].y += 4.0f;
  check_near(texel(bench.run()["landing_footprint"], 0, 0), {0.025f * 1.05f, 0.0f, 0.0f, 0.0125f});
}

namespace {

// Maps of a lamp 10 m above the floor that looks all around: x to the right, y up, forward along -z. Six
// tiles of 16 x 16 texels of 48 x 48, of which 3 on each side are beyond the tile's face: a tangent is 5
// texels.
Bench all_around() {
  Bench bench;
  bench.view = View{};
  bench.view.origin = {0.0, 10.0, 0.0};
  bench.view.perspective = true;
  bench.view.near = 0.1;
  bench.view.cube = CubeAtlas{.side = 48, .guard = 3, .square = true};
  bench.receiver = Image(Format::RGBA32F, 48, 48);
  return bench;
}
constexpr float kTangent = 5.0f / 48.0f;

}  // namespace

TEST_CASE("walk: landed, in a cube's map a footprint lies in the axes of the face that sees the landing") {
  // Below the lamp: x is the view's x, y its forward. 0.5 m and 0.25 m at 10 m.
  Bench below = all_around();
  below.path.start = {0.0f, 1.0f, 0.0f};
  below.path.width_x = {0.5f, 0.0f, 0.0f};
  below.path.width_y = {0.0f, 0.0f, -0.25f};
  const PassImages out = below.run();
  CHECK(status(out) == LandingStatus::Landed);
  check_near(texel(out["landing_footprint"], 0, 0), {0.05f * kTangent, 0.0f, 0.0f, 0.025f * kTangent});
  // 20 m to the right the right face sees it: x is the view's -forward, y its up. At 20 m to the right, 10 m
  // down and 2 m behind a step of 0.5 m away makes its tangents, 0.1 and -0.5, smaller by 0.5 / 20.
  Bench beside = all_around();
  beside.path.start = {20.0f, 1.0f, 2.0f};
  beside.path.width_x = {0.5f, 0.0f, 0.0f};
  beside.path.width_y = {0.0f, 0.0f, -0.25f};
  check_near(texel(beside.run()["landing_footprint"], 0, 0),
             {-0.0025f * kTangent, 0.0125f * kTangent, -0.0125f * kTangent, 0.0f});
}

TEST_CASE("walk: landed, a cube's map has all that a lamp lights, above it too") {
  Bench bench = all_around();
  bench.path.start = {0.5f, 11.0f, 0.25f};
  bench.path.direction = {0.0f, 1.0f, 0.0f};
  bench.hit.z = 4.0f;
  const PassImages out = bench.run();
  CHECK(status(out) == LandingStatus::Landed);
  CHECK(landing(out) == glm::vec3(0.5f, 15.0f, 0.25f));
}

TEST_CASE(
    "walk: landed, what may hide others from the light is looked for where the receivers are no one plane") {
  const std::vector<Choice> choices = walk_pass().choices;
  const auto hidden = std::find_if(choices.begin(), choices.end(),
                                   [](const Choice& choice) { return choice.name == "can_be_hidden"; });
  REQUIRE(hidden != choices.end());
  Effects effects;
  for (const bool one_plane : {false, true}) {
    effects.receivers_are_one_plane = one_plane;
    CHECK(hidden->value({.effects = &effects}) == (one_plane ? 0 : 1));
  }
}

TEST_CASE("walk: landed, what comes from behind counts as hidden where the farthest receivers' map has it") {
  Bench bench;
  bench.can_be_hidden = 2;
  bench.light = {0.0f, -1.0f, 0.0f};
  CHECK(status(bench.run()) == LandingStatus::Landed);
  bench.light = {0.0f, 1.0f, 0.0f};
  CHECK(status(bench.run()) == LandingStatus::NotConverged);
  bench.can_be_hidden = 1;
  CHECK(status(bench.run()) == LandingStatus::Landed);
}
