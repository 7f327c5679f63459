#include <algorithm>
#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/light_path_bench.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;

// The unit direction that leans by `degrees` from straight down towards +x, and from straight up.
glm::vec3 falling(double degrees) {
  return {static_cast<float>(std::sin(degrees * kDegree)), static_cast<float>(-std::cos(degrees * kDegree)),
          0.0f};
}
glm::vec3 rising(double degrees) { return {falling(degrees).x, -falling(degrees).y, 0.0f}; }

// Light that meets a level surface of glass at (1, 0, 1): from outside where it falls, from inside where it
// rises. Bodies are numbered from 1 on, the surface's is body 1.
struct Bench {
  std::vector<BenchMaterial> materials{{}};
  int row = 0;  // the surface's
  BenchPath path{.direction = falling(0.0)};
  float metres = 1.0f;  // from the surface before
  // How the normal turns on the way from the hit, per metre along x and z.
  float curvature = 0.0f;
  glm::vec3 normal{0.0f, 1.0f, 0.0f};
  float bend = 0.0f;
  float least_share = 1e-3f;
  bool both_ways = false, follows_mirrored = false;

  PassImages run() const {
    Mesh mesh = mesh_of({level_triangle(0.0f)});
    for (Vertex& vertex : mesh.vertices)
      vertex.normal = normal + (vertex.position - glm::vec3(1.0f, 0.0f, 1.0f)) * curvature;
    const HierarchyTables tables = HierarchyBench{}.caster(mesh, row).tables();
    std140::Walk u{};
    u.bend = bend;
    u.least_share = least_share;
    u.splits = both_ways ? 1 : 0;
    u.mirrored_at = follows_mirrored ? 1 : 0;
    std::vector<Image> textures = path.textures();
    textures.push_back(filled(1, 1, {0.25f, 0.25f, metres, 1.0f}));
    textures.push_back(caster_materials(materials));
    textures.push_back(tables.triangles);
    textures.push_back(tables.normals);
    return run_pass(part_of_walk(walk_bend_shader,
                                 {"start_before", "direction_before", "flux_before", "media_before",
                                  "width_before", "spread_before", "hit_ahead", "caster_materials",
                                  "hierarchy_triangles", "hierarchy_normals"},
                                 kPathOutputs),
                    {.uniforms = uniform_bytes(u), .textures = textures});
  }
};

void check_near(const glm::vec3& found, const glm::vec3& expected, double margin = 1e-6) {
  for (int c = 0; c < 3; ++c)
    CHECK(static_cast<double>(found[c]) == Approx(static_cast<double>(expected[c])).margin(margin));
}

// Light in glass that meets its surface from inside.
Bench from_inside(double degrees) {
  Bench bench;
  bench.path.direction = rising(degrees);
  bench.path.media = {1.0f, 0.0f, 0.0f, 0.0f};
  return bench;
}

Bench onto_mirror(double degrees) {
  Bench bench;
  bench.materials = {{.mirror = true, .color = {0.5f, 0.9f, 1.0f}}};
  bench.path.direction = falling(degrees);
  return bench;
}

}  // namespace

TEST_CASE(
    "walk: bent, light goes on from where it meets the surface, by Snell's law, in the body that it enters") {
  // sin t = sin 30 / 1.5 = 1/3, cos t = sqrt(8) / 3.
  Bench bench;
  bench.path.direction = falling(30.0);
  const PassImages out = bench.run();
  const BenchPath on = path_at(out);
  check_near(on.start, {1.0f, 0.0f, 1.0f});
  CHECK(on.mark == 1.0f);
  check_near(on.direction, {1.0f / 3.0f, -0.9428090f, 0.0f});
  CHECK(on.media == glm::vec4(1.0f, 0.0f, 0.0f, 0.0f));
  CHECK(on.whole == 1.0f);
  // rs = (0.866025 - 1.414214) / 2.280239 = -0.240408, rp = (1.299038 - 0.942809) / 2.241847 = 0.158900; R is
  // the mean of their squares.
  check_near(on.flux, glm::vec3(1.0f - 0.0415227f));
  check_near(glm::vec3(texel(out["booked"], 0, 0)), glm::vec3(0.0415227f));
  CHECK(texel(out["absorbed"], 0, 0) == glm::vec4(0.0f));
}

TEST_CASE("walk: bent, light that leaves its body is bent away, and in no body then") {
  // sin t = 1.5 sin 20 = 0.5130302.
  const PassImages out = from_inside(20.0).run();
  check_near(path_at(out).direction, {0.5130302f, 0.8583669f, 0.0f});
  CHECK(path_at(out).media == glm::vec4(0.0f));
}

TEST_CASE(
    "walk: bent, beyond asin(1 / 1.5) = 41.81 degrees all light stays in its body, and nothing is booked") {
  Bench nearly = from_inside(41.7);
  nearly.both_ways = true;  // more is mirrored than let through
  CHECK(path_at(nearly.run()).direction.y > 0.0f);
  const PassImages out = from_inside(41.9).run();
  const BenchPath on = path_at(out);
  check_near(on.direction, falling(41.9));
  CHECK(on.flux == glm::vec3(1.0f));
  CHECK(on.media == glm::vec4(1.0f, 0.0f, 0.0f, 0.0f));
  CHECK(on.mark == 1.0f);
  CHECK(texel(out["booked"], 0, 0) == glm::vec4(0.0f));
}

TEST_CASE("walk: bent, a mirror keeps its colour straight on, and whitens by Schlick's law") {
  // At 60 degrees (1 - cos)^5 = 1/32: 0.5 becomes 0.5 * 31/32 + 1/32 = 0.515625.
  const PassImages out = onto_mirror(60.0).run();
  const BenchPath on = path_at(out);
  check_near(on.direction, rising(60.0));
  check_near(on.flux, {0.515625f, 0.903125f, 1.0f});
  check_near(glm::vec3(texel(out["absorbed"], 0, 0)), {0.484375f, 0.096875f, 0.0f});
  CHECK(texel(out["booked"], 0, 0) == glm::vec4(0.0f));
  CHECK(on.media == glm::vec4(0.0f));
  check_near(path_at(onto_mirror(0.0).run()).flux, {0.5f, 0.9f, 1.0f});
}

TEST_CASE(
    "walk: bent, the body absorbs by exp(-a d) on the stretch to the surface, before anything is mirrored") {
  // 0.5 m with 0, 1 and 4 per metre; 0.04 of what is left is mirrored.
  Bench bench = from_inside(0.0);
  bench.materials[0].absorption = {0.0f, 1.0f, 4.0f};
  bench.metres = 0.5f;
  const PassImages out = bench.run();
  const glm::vec3 left{1.0f, 0.6065307f, 0.1353353f};
  check_near(path_at(out).flux, left * 0.96f);
  check_near(glm::vec3(texel(out["booked"], 0, 0)), left * 0.04f);
  check_near(glm::vec3(texel(out["absorbed"], 0, 0)), glm::vec3(1.0f) - left);
}

TEST_CASE("walk: bent, outside all bodies nothing is absorbed, whatever the body that is met") {
  Bench bench;
  bench.materials[0].absorption = glm::vec3(4.0f);
  check_near(path_at(bench.run()).flux, glm::vec3(0.96f));
}

TEST_CASE("walk: bent, a body tints light once, where it enters") {
  Bench bench;
  bench.materials[0].color = {1.0f, 0.5f, 0.0f};
  const PassImages out = bench.run();
  check_near(path_at(out).flux, {0.96f, 0.48f, 0.0f});
  check_near(glm::vec3(texel(out["absorbed"], 0, 0)), {0.0f, 0.48f, 0.96f});
  Bench leaving = from_inside(0.0);
  leaving.materials[0].color = {1.0f, 0.5f, 0.0f};
  check_near(path_at(leaving.run()).flux, glm::vec3(0.96f));
}

TEST_CASE("walk: bent, a body lets a share through once, where light enters, and mirrors as before") {
  Bench bench;
  bench.materials[0].transmitted = 0.6f;
  const PassImages out = bench.run();
  check_near(path_at(out).flux, glm::vec3(0.96f * 0.6f));
  check_near(glm::vec3(texel(out["absorbed"], 0, 0)), glm::vec3(0.96f * 0.4f));
  Bench leaving = from_inside(0.0);
  leaving.materials[0].transmitted = 0.6f;
  check_near(path_at(leaving.run()).flux, glm::vec3(0.96f));
}

TEST_CASE("walk: bent, a body within another is entered from that one's index, and counts until it is left") {
  // From 1.5 into 1.25: sin t = 1.5 / 1.25 sin 30 = 0.6.
  Bench bench;
  bench.materials = {{.ior = 1.5f}, {.ior = 1.25f}};
  bench.row = 1;
  bench.path.direction = falling(30.0);
  bench.path.media = {1.0f, 0.0f, 0.0f, 0.0f};
  const BenchPath on = path_at(bench.run());
  check_near(on.direction, {0.6f, -0.8f, 0.0f});
  CHECK(on.media == glm::vec4(2.0f, 1.0f, 0.0f, 0.0f));
  // And back: sin 30 = 1.25 / 1.5 * 0.6.
  Bench back = bench;
  back.path = {.direction = {0.6f, 0.8f, 0.0f}, .media = {2.0f, 1.0f, 0.0f, 0.0f}};
  const BenchPath out = path_at(back.run());
  check_near(out.direction, rising(30.0));
  CHECK(out.media == glm::vec4(1.0f, 0.0f, 0.0f, 0.0f));
}

TEST_CASE("walk: bent, where bodies overlap the one entered last counts, so the other is left straight on") {
  Bench bench;
  bench.materials = {{.ior = 1.5f}, {.ior = 1.25f}};
  bench.path = {.direction = rising(30.0), .media = {2.0f, 1.0f, 0.0f, 0.0f}};
  const PassImages out = bench.run();
  check_near(path_at(out).direction, rising(30.0));
  check_near(path_at(out).flux, glm::vec3(1.0f));
  CHECK(path_at(out).media == glm::vec4(2.0f, 0.0f, 0.0f, 0.0f));
  // One between two others, and the one of four that was entered first.
  bench.materials.assign(4, {});
  bench.path.media = {3.0f, 1.0f, 2.0f, 0.0f};
  CHECK(path_at(bench.run()).media == glm::vec4(3.0f, 2.0f, 0.0f, 0.0f));
  bench.path.media = {4.0f, 3.0f, 2.0f, 1.0f};
  CHECK(path_at(bench.run()).media == glm::vec4(4.0f, 3.0f, 2.0f, 0.0f));
}

TEST_CASE("walk: bent, an index below 1 is relative to what is around, as of a bubble") {
  // 2/3 in glass of 1.5 is air: sin t = 1.5 sin 20.
  Bench bench;
  bench.materials = {{.ior = 1.5f}, {.ior = 2.0f / 3.0f}};
  bench.row = 1;
  bench.path = {.direction = falling(20.0), .media = {1.0f, 0.0f, 0.0f, 0.0f}};
  check_near(path_at(bench.run()).direction, {0.5130302f, -0.8583669f, 0.0f});
}

TEST_CASE("walk: bent, light that meets a body from inside without having entered began there") {
  // So it has the body's colour from here on. R from inside is 0.041729 at 20 degrees.
  Bench bench;
  bench.path.direction = rising(20.0);
  bench.materials[0].color = {1.0f, 0.5f, 0.0f};
  const BenchPath on = path_at(bench.run());
  check_near(on.direction, {0.5130302f, 0.8583669f, 0.0f});
  CHECK(on.media == glm::vec4(0.0f));
  check_near(on.flux, 0.958271f * glm::vec3(1.0f, 0.5f, 0.0f));
}

TEST_CASE("walk: bent, a second skin of a body that light is in is counted, and bends nothing") {
  Bench bench;
  bench.path = {.direction = falling(50.0), .media = {2.0f, 1.0f, 0.0f, 0.0f}};
  bench.materials = {{.ior = 2.0f, .color = {0.0f, 0.0f, 0.0f}}, {.ior = 1.25f}};
  const PassImages out = bench.run();
  check_near(path_at(out).direction, falling(50.0));
  CHECK(path_at(out).flux == glm::vec3(1.0f));
  CHECK(path_at(out).media == glm::vec4(2.0f, 1.0f, 1.0f, 0.0f));
  CHECK(path_at(out).mark == 1.0f);
  CHECK(texel(out["booked"], 0, 0) == glm::vec4(0.0f));
  // Where there is no room it is not counted.
  bench.path.media = {4.0f, 3.0f, 2.0f, 1.0f};
  CHECK(path_at(bench.run()).media == glm::vec4(4.0f, 3.0f, 2.0f, 1.0f));
  CHECK(path_at(bench.run()).mark == 1.0f);
  // Out of one of two skins light is still in the other.
  bench.path.direction = rising(50.0);
  bench.path.media = {2.0f, 1.0f, 1.0f, 0.0f};
  CHECK(path_at(bench.run()).media == glm::vec4(2.0f, 1.0f, 0.0f, 0.0f));
  check_near(path_at(bench.run()).direction, rising(50.0));
  CHECK(path_at(bench.run()).flux == glm::vec3(1.0f));
}

TEST_CASE("walk: bent, light is in four bodies at most: one that enters a fifth is given up") {
  Bench bench;
  bench.materials.assign(5, {});
  bench.row = 4;
  bench.path.media = {3.0f, 2.0f, 1.0f, 0.0f};
  CHECK(path_at(bench.run()).mark == 1.0f);
  CHECK(path_at(bench.run()).media == glm::vec4(5.0f, 3.0f, 2.0f, 1.0f));
  bench.path.media = {4.0f, 3.0f, 2.0f, 1.0f};
  CHECK(path_at(bench.run()).mark == kEnded);
  check_near(path_at(bench.run()).flux, glm::vec3(1.0f));
  // What is mirrored off the fifth enters nothing.
  bench.materials[4].mirror = true;
  CHECK(path_at(bench.run()).mark == 1.0f);
}

TEST_CASE("walk: bent, the index is n_d and the branch's bend of n_F - n_C") {
  // 1.5 + 2 * 0.05 = 1.6: sin t = 0.5 / 1.6.
  Bench bench;
  bench.materials[0].dispersion = 0.05f;
  bench.bend = 2.0f;
  bench.path.direction = falling(30.0);
  CHECK(path_at(bench.run()).direction.x == Approx(0.3125).epsilon(1e-5));
}

TEST_CASE("walk: bent, unless it is said, light takes the stronger way, and the weaker is booked") {
  // At 85 degrees R = 0.612556: rs = (0.0871557 - 1.1214477) / 1.2086034, rp = (0.1307336 - 0.7476318) /
  // 0.8783654.
  Bench bench;
  bench.path.direction = falling(85.0);
  const PassImages out = bench.run();
  check_near(path_at(out).direction, rising(85.0));
  check_near(path_at(out).flux, glm::vec3(0.612801f), 1e-3);
  for (int c = 0; c < 3; ++c)
    CHECK(path_at(out).flux[c] + out["booked"].at(0, 0, c) == Approx(1.0).epsilon(1e-6));
  CHECK(path_at(out).media == glm::vec4(0.0f));
}

TEST_CASE(
    "walk: bent, where both ways are followed one branch goes through, the other has what is mirrored") {
  Bench bench;
  bench.both_ways = true;
  const PassImages through = bench.run();
  check_near(path_at(through).direction, falling(0.0));
  check_near(path_at(through).flux, glm::vec3(0.96f));
  CHECK(texel(through["booked"], 0, 0) == glm::vec4(0.0f));
  bench.follows_mirrored = true;
  const PassImages mirrored = bench.run();
  check_near(path_at(mirrored).direction, rising(0.0));
  check_near(path_at(mirrored).flux, glm::vec3(0.04f));
  CHECK(path_at(mirrored).media == glm::vec4(0.0f));
  CHECK(texel(mirrored["booked"], 0, 0) == glm::vec4(0.0f));
  // Even where it is the stronger way.
  bench.follows_mirrored = false;
  bench.path.direction = falling(85.0);
  CHECK(path_at(bench.run()).direction.y < 0.0f);
}

TEST_CASE("walk: bent, what is absorbed before the surface is booked by one of both branches") {
  Bench bench = from_inside(0.0);
  bench.materials[0].absorption = glm::vec3(1.0f);
  bench.both_ways = true;
  CHECK(bench.run()["absorbed"].at(0, 0, 0) == Approx(1.0 - std::exp(-1.0)).epsilon(1e-5));
  bench.follows_mirrored = true;
  const PassImages mirrored = bench.run();
  CHECK(mirrored["absorbed"].at(0, 0, 0) == Approx(0.0).margin(1e-7));
  CHECK(path_at(mirrored).flux.x == Approx(0.04 * std::exp(-1.0)).epsilon(1e-5));
}

TEST_CASE(
    "walk: bent, metal, total reflection and a second skin leave nothing for the branch that is mirrored") {
  Bench skin;
  skin.path.media = {1.0f, 0.0f, 0.0f, 0.0f};
  for (Bench bench : {onto_mirror(0.0), from_inside(50.0), skin}) {
    bench.both_ways = true;
    CHECK(path_at(bench.run()).mark == 1.0f);
    bench.follows_mirrored = true;
    CHECK(path_at(bench.run()).mark == 0.0f);
  }
}

TEST_CASE("walk: bent, what is mirrored too weakly is booked where it is, and has no branch") {
  // 0.04 of the light on the cell.
  Bench bench;
  bench.both_ways = true;
  bench.least_share = 0.05f;
  check_near(glm::vec3(texel(bench.run()["booked"], 0, 0)), glm::vec3(0.04f));
  bench.follows_mirrored = true;
  CHECK(path_at(bench.run()).mark == 0.0f);
  CHECK(texel(bench.run()["booked"], 0, 0) == glm::vec4(0.0f));
}

TEST_CASE("walk: bent, light that is weaker than a share of what fell on the cell ends") {
  // 0.96 of 0.9 and of 1.1 thousandths of 4.
  Bench bench;
  bench.path.whole = 4.0f;
  bench.path.flux = glm::vec3(0.0f, 0.0f, 4.4e-3f);
  CHECK(path_at(bench.run()).mark == 1.0f);
  bench.path.flux = glm::vec3(0.0f, 0.0f, 3.6e-3f);
  CHECK(path_at(bench.run()).mark == kEnded);
}

TEST_CASE("walk: bent, light ends where a smooth normal sends it to its own surface's wrong side") {
  // Straight down onto a mirror whose normal leans by 60 degrees: mirrored it would still fall by 30.
  Bench bench = onto_mirror(0.0);
  bench.normal = rising(60.0);
  CHECK(path_at(bench.run()).mark == kEnded);
  bench.normal = rising(40.0);
  CHECK(path_at(bench.run()).mark == 1.0f);
}

TEST_CASE("walk: bent, a path's number tells bodies and events apart") {
  // 251 times the number before, 4 times the body, and the event: 1 crosses, 2 is mirrored, 3 passes.
  Bench bench;
  CHECK(path_at(bench.run()).path == 5.0f);
  bench.path.path = 5.0f;
  CHECK(path_at(bench.run()).path == 5.0f * 251.0f + 5.0f);
  CHECK(path_at(onto_mirror(0.0).run()).path == 6.0f);
  CHECK(path_at(from_inside(50.0).run()).path == 6.0f);
  bench.path = {.media = {1.0f, 0.0f, 0.0f, 0.0f}};
  CHECK(path_at(bench.run()).path == 7.0f);
  bench.path = {.path = 65520.0f};
  CHECK(path_at(bench.run()).path == static_cast<float>((65520 * 251 + 5) % 65521));
}

TEST_CASE("walk: bent, parallel light stays parallel at a plane, and is as wide as its shadow on it") {
  // 2 mm across at 30 degrees are 2 / cos 30 on the surface, and times cos t = 0.942809 behind it; along z
  // nothing changes.
  Bench bench;
  bench.path.direction = falling(30.0);
  bench.path.width_x = 2e-3f * glm::vec3(0.8660254f, 0.5f, 0.0f);
  bench.path.width_y = {0.0f, 0.0f, 2e-3f};
  const BenchPath on = path_at(bench.run());
  check_near(on.width_x, 2e-3f * (0.9428090f / 0.8660254f) * glm::vec3(0.9428090f, 1.0f / 3.0f, 0.0f), 1e-8);
  check_near(on.width_y, {0.0f, 0.0f, 2e-3f}, 1e-8);
  CHECK(glm::length(on.spread_x) == Approx(0.0).margin(1e-9));
  CHECK(glm::length(on.spread_y) == Approx(0.0).margin(1e-9));
}

TEST_CASE("walk: bent, a spread widens light over the stretch to the surface") {
  // 1 mm and 0.5 mrad over 3 m: 2.5 mm. Light straight down onto a level mirror spreads on as it was.
  Bench bench = onto_mirror(0.0);
  bench.metres = 3.0f;
  bench.path.width_x = {1e-3f, 0.0f, 0.0f};
  bench.path.spread_x = {5e-4f, 0.0f, 0.0f};
  const BenchPath on = path_at(bench.run());
  check_near(on.width_x, {2.5e-3f, 0.0f, 0.0f}, 1e-8);
  check_near(on.spread_x, {5e-4f, 0.0f, 0.0f}, 1e-9);
}

TEST_CASE("walk: bent, a spherical surface gathers parallel light at n R / (n - 1)") {
  // R = 2 m and n = 1.5: 6 m behind the surface, so a step of 1 mm turns by -1/6 mrad.
  Bench bench;
  bench.curvature = 0.5f;
  bench.path.width_x = {1e-3f, 0.0f, 0.0f};
  bench.path.width_y = {0.0f, 0.0f, 1e-3f};
  const BenchPath on = path_at(bench.run());
  check_near(on.width_x, {1e-3f, 0.0f, 0.0f}, 1e-9);
  check_near(on.spread_x, {-1e-3f / 6.0f, 0.0f, 0.0f}, 1e-9);
  check_near(on.spread_y, {0.0f, 0.0f, -1e-3f / 6.0f}, 1e-9);
  // There it has no width left.
  Bench next = from_inside(0.0);
  next.path.direction = falling(0.0);
  next.path.width_x = on.width_x;
  next.path.spread_x = on.spread_x;
  next.metres = 6.0f;
  CHECK(glm::length(path_at(next.run()).width_x) == Approx(0.0).margin(1e-9));
}

TEST_CASE("walk: bent, light from inside meets the same sphere's other side") {
  // (1 - 1.5) / 2 per metre of width: it gathers in air, behind R / (n - 1) = 4 m.
  Bench bench = from_inside(0.0);
  bench.curvature = 0.5f;
  bench.path.width_x = {1e-3f, 0.0f, 0.0f};
  check_near(path_at(bench.run()).spread_x, {-1e-3f / 4.0f, 0.0f, 0.0f}, 1e-9);
}

TEST_CASE(
    "bend: a convex mirror scatters parallel light as if from half its radius, a hollow one gathers it") {
  Bench bench = onto_mirror(0.0);
  bench.curvature = 0.5f;
  bench.path.width_x = {1e-3f, 0.0f, 0.0f};
  check_near(path_at(bench.run()).spread_x, {1e-3f, 0.0f, 0.0f}, 1e-9);
  bench.curvature = -0.5f;
  check_near(path_at(bench.run()).spread_x, {-1e-3f, 0.0f, 0.0f}, 1e-9);
}

TEST_CASE("walk: bent, oblique light onto a sphere has two foci, by Coddington's equations") {
  // R = 2 m, 30 degrees: (1.5 cos t - cos 30) / R = (1.4142136 - 0.8660254) / 2 = 0.2740941 per metre. Across
  // the plane of incidence the focus is 1.5 / 0.2740941 = 5.472573 m behind the surface, in it 1.5 cos^2 t /
  // 0.2740941 = 4.864509 m.
  Bench bench;
  bench.curvature = 0.5f;
  bench.path.direction = falling(30.0);
  bench.path.width_x = 1e-3f * glm::vec3(0.8660254f, 0.5f, 0.0f);
  bench.path.width_y = {0.0f, 0.0f, 1e-3f};
  const BenchPath on = path_at(bench.run());
  check_near(on.spread_y, {0.0f, 0.0f, -1e-3f / 5.472573f}, 1e-9);
  check_near(on.spread_x, on.width_x * (-1.0f / 4.864509f), 1e-9);
}

TEST_CASE("walk: bent, a differential that grazing surfaces have widened stays finite") {
  // 9000 km across are 18,000 km on the surface at 60 degrees: what is stored is held at 1000 km an axis.
  Bench bench;
  bench.path.direction = falling(60.0);
  bench.path.width_x = 9e6f * glm::vec3(0.5f, 0.8660254f, 0.0f);
  const glm::vec4 width = glm::abs(texel(bench.run()["path_width"], 0, 0));
  CHECK(std::max(width.x, width.y) == Approx(1e6));
  CHECK(std::max(width.z, width.w) == 0.0f);
}
