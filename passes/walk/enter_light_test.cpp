#include <cmath>
#include <optional>

#include "pipeline/measure/drawn_points.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/light_path_bench.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A light straight down from 10 m sees a level square of glass at height 1 as a grid of 2 x 2 vertices, all
// of them at one point of it. Parallel light comes through a window of 8 x 8 m, so that a cell is 4 m wide.
struct Bench {
  View view = down(4.0, 10.0, 20.0);
  int side = 2;
  Corners triangle = level_triangle(1.0f, -1.0f, -1.0f);
  glm::vec3 point{0.0f, 1.0f, 0.0f};
  glm::vec3 normal{0.0f, 1.0f, 0.0f};
  float facing = 1.0f;
  float number = 1.0f;  // of the triangle, plus 1
  BenchMaterial material{};
  Light light{};
  bool both_ways = false, follows_mirrored = false;
  std::optional<Light> source;  // whose size is drawn
  std::optional<Corners> lamp;  // that is its mesh

  HierarchyBench hierarchy() const {
    HierarchyBench bench;
    bench.scene.materials.resize(1);
    bench.caster(mesh_of({level_triangle(9.0f), triangle}));
    if (!lamp) return bench;
    bench.receiver(mesh_of({*lamp}));
    bench.meshes.lamps = {1};
    return bench;
  }

  PassImages run() const {
    const HierarchyBench bench = hierarchy();
    const HierarchyTables tables = bench.tables();
    std140::Walk u{};
    u.caster = shader_view(view);
    u.cone = shader_cone(light);
    u.light = glm::vec3(view.perspective ? view.origin : view.forward);
    u.cell_area = static_cast<float>(view.window_area() / (side * side));
    u.grid_side = side;
    const CubeAtlas tiles = view.cube.value_or(CubeAtlas{});
    u.tile_width = static_cast<float>(tiles.tile_width());
    u.tile_height = static_cast<float>(tiles.tile_height());
    u.tile_guard = static_cast<float>(tiles.guard);
    u.least_share = 1e-3f;
    u.splits = both_ways ? 1 : 0;
    u.mirrored_at = follows_mirrored ? 1 : 0;
    if (source) {
      u.light_shape = source->shape == LightShape::Sphere      ? 1
                      : source->shape == LightShape::Rectangle ? 2
                      : source->shape == LightShape::Disk      ? 3
                      : lamp                                   ? 5
                                                               : 4;
      if (lamp) u.light_points = first_point(bench.scene, bench.meshes, 0);
      const bool far_away = source->shape == LightShape::Disk;
      u.light_middle = glm::vec3(far_away ? source->direction : source->position);
      u.light_radius = far_away ? std::tan(static_cast<float>(source->angular_radius))
                                : static_cast<float>(source->radius);
      u.light_width = glm::vec3(source->width);
      u.light_height = glm::vec3(source->height);
    }
    return run_pass(part_of_walk(walk_enter_shader,
                                 {"caster_position", "caster_normal", "caster_materials",
                                  "hierarchy_triangles", "hierarchy_normals", "reaching"},
                                 kPathOutputs),
                    {.width = side,
                     .height = side,
                     .uniforms = uniform_bytes(u),
                     .textures = {filled(side, side, {point, facing * (number + 1.0f)}),
                                  filled(side, side, {normal, 0.0f}), caster_materials({material}),
                                  tables.triangles, tables.normals}});
  }
};

// The same from a point, through a window of 0.5 x 0.5 tangents: a cell is 0.25 wide. Index 1 bends nothing.
Bench from_point() {
  Bench bench;
  bench.view = down(0.25, 10.0, 20.0);
  bench.view.perspective = true;
  bench.view.near = 0.1;
  bench.material.ior = 1.0f;
  return bench;
}

// Light from a point all around: x to the right, y up, forward along -z. Six tiles of 8 x 8 vertices, of
// which one on each side is beyond the tile's face: 2 tangents are 6 vertices.
Bench all_around(const glm::dvec3& lamp) {
  Bench bench = from_point();
  bench.view = View{};
  bench.view.origin = lamp;
  bench.view.perspective = true;
  bench.view.near = 0.1;
  bench.view.cube = CubeAtlas{.side = 24, .guard = 1, .square = true};
  bench.side = 24;
  return bench;
}

void check_near(const glm::vec3& found, const glm::vec3& expected, double margin = 1e-6) {
  for (int c = 0; c < 3; ++c)
    CHECK(static_cast<double>(found[c]) == Approx(static_cast<double>(expected[c])).margin(margin));
}

}  // namespace

TEST_CASE("walk: entered, a cell's light goes in, but for its Fresnel share, and is in the body then") {
  // 16 square metres, R = 0.04.
  Bench bench;
  bench.number = 2.0f;
  const PassImages out = bench.run();
  for (int x = 0; x < 2; ++x) {
    const BenchPath on = path_at(out, x, 1);
    CHECK(on.start == glm::vec3(0.0f, 1.0f, 0.0f));
    CHECK(on.mark == 2.0f);
    CHECK(on.direction == glm::vec3(0.0f, -1.0f, 0.0f));
    CHECK(on.whole == 16.0f);
    check_near(on.flux, glm::vec3(16.0f * 0.96f), 1e-5);
    CHECK(on.media == glm::vec4(1.0f, 0.0f, 0.0f, 0.0f));
    CHECK(on.path == 5.0f);  // crosses body 1
  }
  check_near(glm::vec3(texel(out["booked"], 0, 0)), glm::vec3(16.0f * 0.04f));
}

TEST_CASE("walk: entered, a smooth normal bends by Snell's law") {
  // Leaning by 30 degrees: sin t = 1/3, t = 19.4712 degrees; light leans by 10.5288 degrees, against the
  // tilt.
  Bench bench;
  bench.normal = {0.5f, 0.8660254f, 0.0f};
  CHECK(path_at(bench.run()).direction.x == Approx(-std::sin(0.183762)).epsilon(1e-4));
}

TEST_CASE("walk: entered, where there is no caster, or no triangle of one, nothing goes on") {
  Bench bench;
  bench.facing = 0.0f;
  CHECK(texel(bench.run()["path_start"], 0, 0) == glm::vec4(0.0f));
  CHECK(texel(bench.run()["booked"], 0, 0) == glm::vec4(0.0f));
  bench.facing = 1.0f;
  bench.number = 0.0f;
  CHECK(texel(bench.run()["path_start"], 1, 1) == glm::vec4(0.0f));
}

TEST_CASE("walk: entered, a surface that is seen from inside is left, and light is in no body then") {
  // Leaning by 20 degrees from inside: asin(1.5 sin 20) = 30.866, so 10.866 degrees off the vertical.
  Bench bench;
  bench.facing = -1.0f;
  bench.normal = {0.3420201f, -0.9396926f, 0.0f};
  const BenchPath on = path_at(bench.run());
  CHECK(std::fabs(on.direction.x) == Approx(std::sin(10.866 * 3.14159265 / 180.0)).epsilon(1e-4));
  CHECK(on.media == glm::vec4(0.0f));
}

TEST_CASE("walk: entered, a mirror sends light back in its colour, and into no body") {
  Bench bench;
  bench.material = {.mirror = true, .color = {0.5f, 0.25f, 1.0f}};
  const BenchPath on = path_at(bench.run());
  CHECK(on.direction == glm::vec3(0.0f, 1.0f, 0.0f));
  CHECK(on.flux == glm::vec3(8.0f, 4.0f, 16.0f));
  CHECK(on.media == glm::vec4(0.0f));
}

TEST_CASE("walk: entered, the branch that is mirrored at once has what the other leaves, and books nothing") {
  Bench bench;
  bench.both_ways = true;
  const PassImages through = bench.run();
  CHECK(texel(through["booked"], 0, 0) == glm::vec4(0.0f));
  bench.follows_mirrored = true;
  const PassImages mirrored = bench.run();
  CHECK(texel(mirrored["booked"], 0, 0) == glm::vec4(0.0f));
  check_near(path_at(mirrored).flux, glm::vec3(16.0f * 0.04f));
  CHECK(path_at(mirrored).direction == glm::vec3(0.0f, 1.0f, 0.0f));
  CHECK(path_at(mirrored).whole == 16.0f);
}

TEST_CASE("walk: entered, parallel light moves by a cell from vertex to vertex, and does not turn") {
  // The view's right is +x, its up -z.
  const BenchPath on = path_at(Bench{}.run());
  check_near(on.width_x, {4.0f, 0.0f, 0.0f});
  check_near(on.width_y, {0.0f, 0.0f, -4.0f});
  CHECK(on.spread_x == glm::vec3(0.0f));
  CHECK(on.spread_y == glm::vec3(0.0f));
}

TEST_CASE("walk: entered, light from a point turns by a cell's angle, and moves by that times its way") {
  // 0.25 at 9 m on the axis.
  const BenchPath on = path_at(from_point().run());
  check_near(on.width_x, {2.25f, 0.0f, 0.0f});
  check_near(on.width_y, {0.0f, 0.0f, -2.25f});
  check_near(on.spread_x, {0.25f, 0.0f, 0.0f});
  check_near(on.spread_y, {0.0f, 0.0f, -0.25f});
  CHECK(on.whole == Approx(0.0625));  // steradians, by the midpoint form
}

TEST_CASE("walk: entered, off the axis a point's light turns by the derivative of its direction") {
  // At 45 degrees the angle is atan(t), so 0.25 of t turn it by 0.125; on the level surface it still moves by
  // 0.25 * 9 m along x, of which cos 45 is across the light. Along y: 0.25 cos 45, and 2.25 m.
  Bench bench = from_point();
  bench.view.origin.x = -9.0;
  const BenchPath on = path_at(bench.run());
  const float half = 0.70710678f;
  check_near(on.direction, {half, -half, 0.0f});
  check_near(on.spread_x, 0.125f * glm::vec3(half, half, 0.0f));
  check_near(on.width_x, 2.25f * half * glm::vec3(half, half, 0.0f), 1e-5);
  check_near(on.spread_y, {0.0f, 0.0f, -0.25f * half});
  check_near(on.width_y, {0.0f, 0.0f, -2.25f}, 1e-5);
  // Its solid angle is by the cube of the cosine smaller.
  CHECK(on.whole == Approx(0.0625 * std::pow(0.5, 1.5)));
}

TEST_CASE("walk: entered, behind the surface a point's light turns by the derivative of Snell's law") {
  // At 45 degrees and n = 1.5: sin t = 0.4714045, cos t = 0.8819171, and dt = cos 45 / (1.5 cos t) di, so
  // 0.125 becomes 0.0668154.
  Bench bench = from_point();
  bench.material.ior = 1.5f;
  bench.view.origin.x = -9.0;
  const BenchPath on = path_at(bench.run());
  check_near(on.direction, {0.4714045f, -0.8819171f, 0.0f});
  check_near(on.spread_x, 0.0668154f * glm::vec3(0.8819171f, 0.4714045f, 0.0f));
  check_near(on.width_x, 2.25f * 0.8819171f * glm::vec3(0.8819171f, 0.4714045f, 0.0f), 1e-5);
}

TEST_CASE("walk: entered, a spot's cone takes its part of a cell's light") {
  // Cones of 30 and 60 degrees, at 45: ((cos 45 - cos 60) / (cos 30 - cos 60))^2.
  Bench bench = from_point();
  bench.view.origin.x = -9.0;
  bench.light.type = LightType::Spot;
  bench.light.direction = {0.0, -1.0, 0.0};
  bench.light.inner_cone = 0.52359878f;
  bench.light.outer_cone = 1.04719755f;
  const double ramp = (std::sqrt(0.5) - 0.5) / (std::sqrt(0.75) - 0.5);
  CHECK(path_at(bench.run()).whole == Approx(0.0625 * std::pow(0.5, 1.5) * ramp * ramp).epsilon(1e-5));
}

TEST_CASE("walk: entered, a lamp's light goes down by the lower face of its cube, in that face's axes") {
  // That face is the fourth, in the second row's first tile: its x is the view's x, its y the view's forward.
  // A cell is a third of a tangent wide, so 3 m at 9 m, and 1 / 9 sr.
  Bench bench = all_around({0.0, 10.0, 0.0});
  bench.number = 2.0f;
  const PassImages out = bench.run();
  for (const int x : {1, 6}) {
    const BenchPath on = path_at(out, x, 9);
    check_near(on.direction, {0.0f, -1.0f, 0.0f});
    CHECK(on.whole == Approx(1.0 / 9.0));
    check_near(on.width_x, {3.0f, 0.0f, 0.0f}, 1e-5);
    check_near(on.width_y, {0.0f, 0.0f, -3.0f}, 1e-5);
    check_near(on.spread_x, {1.0f / 3.0f, 0.0f, 0.0f});
    check_near(on.spread_y, {0.0f, 0.0f, -1.0f / 3.0f});
  }
}

TEST_CASE(
    "walk: entered, a lamp's light goes to the right by the first face of its cube, in that face's axes") {
  // Its x is the view's -forward, its y the view's up. An upright triangle 9 m away, at 45 degrees above the
  // axis: the direction's y is turned by a third times cos^2 45, and 3 m up are cos 45 of that across it.
  Bench bench = all_around({-9.0, 0.0, 0.0});
  bench.number = 2.0f;
  bench.triangle = {{{0.0f, 8.0f, -1.0f}, {0.0f, 8.0f, 3.0f}, {0.0f, 12.0f, -1.0f}}};
  bench.normal = {-1.0f, 0.0f, 0.0f};
  bench.point = {0.0f, 9.0f, 0.0f};
  const BenchPath on = path_at(bench.run(), 4, 6);
  const float half = 0.70710678f;
  check_near(on.direction, {half, half, 0.0f});
  CHECK(on.whole == Approx(std::pow(0.5, 1.5) / 9.0));
  check_near(on.spread_x, {0.0f, 0.0f, half / 3.0f});
  check_near(on.width_x, {0.0f, 0.0f, 3.0f}, 1e-5);
  check_near(on.spread_y, 1.0f / 6.0f * glm::vec3(-half, half, 0.0f));
  check_near(on.width_y, 3.0f * half * glm::vec3(-half, half, 0.0f), 1e-5);
}

TEST_CASE(
    "walk: entered, beyond a cube's faces a vertex has no light of its own, and beyond its tiles there is "
    "none") {
  Bench bench = all_around({0.0, 10.0, 0.0});
  bench.number = 2.0f;
  const PassImages out = bench.run();
  for (const auto& [x, y] : {std::pair{0, 9}, {7, 9}, {8, 9}, {3, 8}, {3, 15}}) {
    CHECK(path_at(out, x, y).whole == 0.0f);
    CHECK(path_at(out, x, y).mark == 2.0f);
  }
  // Tiles are as high as wide: the rows from 16 on are left over.
  CHECK(path_at(out, 3, 16).mark == 0.0f);
  CHECK(path_at(out, 23, 23).mark == 0.0f);
}

namespace {

Light sized(LightShape shape) {
  Light light;
  light.shape = shape;
  light.type = shape == LightShape::Disk ? LightType::Directional : LightType::Point;
  light.position = {0.0, 10.0, 0.0};
  light.direction = {0.0, -1.0, 0.0};
  light.radius = shape == LightShape::Sphere ? 1.0 : 0.0;
  if (shape == LightShape::Rectangle) {
    light.width = {2.0, 0.0, 0.0};
    light.height = {0.0, 0.0, 1.0};
  }
  light.angular_radius = 0.1;
  return light;
}

}  // namespace

TEST_CASE("walk: entered, each vertex takes its own point of a light with a size, as rays that judge it do") {
  for (const LightShape shape : {LightShape::Sphere, LightShape::Rectangle, LightShape::Disk}) {
    Bench bench = from_point();
    if (shape == LightShape::Disk) bench.view = down(4.0, 10.0, 20.0);
    bench.source = sized(shape);
    const PassImages out = bench.run();
    std::vector<glm::vec3> directions;
    for (int y = 0; y < 2; ++y)
      for (int x = 0; x < 2; ++x) {
        const LightRay middle{.origin = {0.0, 10.0, 0.0}, .direction = {0.0, -1.0, 0.0}};
        const LightRay ray = DrawnPoints({}, *bench.source).ray(middle, glm::dvec3(bench.point), x, y);
        directions.push_back(path_at(out, x, y).direction);
        check_near(directions.back(), glm::vec3(ray.direction), 1e-5);
      }
    CHECK(directions[0] != directions[1]);
    CHECK(directions[0] != directions[2]);
  }
}

TEST_CASE("walk: entered, light from aside falls flatter and from farther onto the same surface") {
  // From 10 m up, over a level square, of a rectangle: a cell has .0625 steradians from its middle.
  Bench bench = from_point();
  bench.source = sized(LightShape::Rectangle);
  const PassImages out = bench.run();
  const glm::vec3 d = path_at(out, 0, 0).direction;
  // 9 m below: 81 / (9 / cos)^2 times the cosine.
  CHECK(path_at(out, 0, 0).whole == Approx(0.0625 * std::pow(static_cast<double>(-d.y), 3.0)).epsilon(1e-4));
  CHECK(d.y > -0.9999f);
}

TEST_CASE("walk: entered, any other mesh that shines sends light from all over its outer side") {
  // A level triangle at 10 m that looks down. Less falls on the surface from aside: by the cosines at both
  // ends, and by the square of the distance.
  Bench bench = from_point();
  bench.source = sized(LightShape::Mesh);
  bench.source->radius = 0.0;
  bench.source->emitter = 1;
  bench.lamp = level_triangle(10.0f);
  std::swap((*bench.lamp)[1], (*bench.lamp)[2]);
  const auto directions = [&] {
    std::vector<glm::vec3> found;
    const PassImages out = bench.run();
    const HierarchyBench hierarchy = bench.hierarchy();
    const DrawnPoints points(hierarchy.scene, *bench.source);
    for (int y = 0; y < 2; ++y)
      for (int x = 0; x < 2; ++x) {
        const LightRay middle{.origin = {0.0, 10.0, 0.0}, .direction = {0.0, -1.0, 0.0}};
        const glm::vec3 d = path_at(out, x, y).direction;
        check_near(d, glm::vec3(points.ray(middle, glm::dvec3(bench.point), x, y).direction), 1e-5);
        CHECK(path_at(out, x, y).whole ==
              Approx(0.0625 * std::pow(static_cast<double>(-d.y), 4.0)).epsilon(1e-4));
        found.push_back(d);
      }
    return found;
  };
  const std::vector<glm::vec3> found = directions();
  CHECK(found[0] != found[1]);
  CHECK(found[0] != found[2]);
  // Its back is dark, and no vertex is followed from there.
  std::swap((*bench.lamp)[1], (*bench.lamp)[2]);
  const PassImages dark = bench.run();
  for (int x = 0; x < 2; ++x) CHECK(path_at(dark, x, 0).mark == 0.0f);
}

TEST_CASE("walk: entered, a ball that shines has the outline of a sphere, and is as bright all over it") {
  // On the axis of its middle: the sine, not the tangent, is even over a disk, and each ray brings as much.
  Bench bench = from_point();
  bench.source = sized(LightShape::Sphere);
  const glm::vec3 flat = path_at(bench.run(), 1, 1).direction;
  bench.source->shape = LightShape::Mesh;
  const PassImages out = bench.run();
  const glm::vec3 round = path_at(out, 1, 1).direction;
  const auto across = [](const glm::vec3& d) { return std::hypot(double(d.x), double(d.z)); };
  CHECK(across(round) == Approx(across(flat) / -double(flat.y)).epsilon(1e-5));
  CHECK(across(flat) > 0.01);
  CHECK(double(path_at(out, 1, 1).whole) == Approx(0.0625).epsilon(1e-5));
}

TEST_CASE("walk: entered, light from behind the surface does not reach it") {
  Bench bench = from_point();
  bench.source = sized(LightShape::Sphere);
  bench.source->position = {0.0, 0.0, 0.0};
  CHECK(path_at(bench.run()).whole == 0.0f);
}
