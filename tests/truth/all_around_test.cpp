// Lights that see all around: a closed room, in which nothing may be lost and no border may show.
#include <cmath>

#include "pipeline/gpu/error.hpp"
#include "pipeline/settings/check_settings.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

constexpr int kPixels = 64;

// A room of +-1 m around the origin.
Scene room_with(const glm::dvec3& lamp, const std::vector<Mesh>& casters, float ior) {
  Scene scene;
  scene.materials = {diffuse(0.8f), glass(ior)};
  scene.meshes = {box({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}, 0)};
  scene.meshes.insert(scene.meshes.end(), casters.begin(), casters.end());
  Light light{.name = "lamp", .type = LightType::Point, .intensity = 3.0f};
  light.position = lamp;
  scene.lights = {light};
  scene.cameras = {camera_down(0.2, 1.0)};
  return scene;
}

// Looks straight at one wall from 2 mm before it, on +-0.98 m of it. Walls: +x, -x, +y, -y, +z, -z.
Camera camera_at_wall(int wall) {
  const int axis = wall / 2;
  Camera camera{.name = "wall", .orthographic = true};
  glm::dvec3 forward{0.0}, up{0.0};
  forward[axis] = wall % 2 ? -1.0 : 1.0;
  up[(axis + 1) % 3] = 1.0;
  camera.position = 0.998 * forward;
  camera.forward = forward;
  camera.up = up;
  camera.right = glm::cross(forward, up);
  camera.half_width = camera.half_height = 0.98;
  camera.near = 1e-4;
  camera.far = 1.0;
  return camera;
}

Settings room_settings(int grid, int map) {
  Settings settings = through_two_surfaces(small_settings(grid, map, kPixels));
  settings.shadow = 512;
  return settings;
}

struct Wall {
  Image direct, caustic, position;
};

Wall wall_of(Scene scene, const Settings& settings, int wall) {
  scene.cameras = {camera_at_wall(wall)};
  const Rendering r = render(scene, settings, {"aov_direct", "aov_caustic", "aov_position"});
  return {r["aov_direct"], r["aov_caustic"], r["aov_position"]};
}

// Within 0.12 m of the room's own edges.
bool near_edge(int x, int y) {
  return std::max(std::fabs(x + 0.5 - kPixels / 2), std::fabs(y + 0.5 - kPixels / 2)) > kPixels / 2 * 0.9;
}

// Within two grid vertices of a corner of the cube around the lamp.
bool in_corner(const glm::dvec3& lamp, const Image& position, int x, int y) {
  const glm::dvec3 way =
      glm::abs(glm::dvec3(position.at(x, y, 0), position.at(x, y, 1), position.at(x, y, 2)) - lamp);
  return std::min({way.x, way.y, way.z}) > 0.9 * std::max({way.x, way.y, way.z});
}

// I cos / r^2 from a lamp of 3 cd at a point of a wall.
double from_lamp(const glm::dvec3& lamp, int wall, const Image& position, int x, int y) {
  const glm::dvec3 p{position.at(x, y, 0), position.at(x, y, 1), position.at(x, y, 2)};
  const glm::dvec3 way = p - lamp;
  const double squared = glm::dot(way, way);
  return 3.0 * std::fabs(way[wall / 2]) / (squared * std::sqrt(squared));
}

Ledger ledger_in(const Scene& scene, const Settings& settings) {
  return ledger_of(render(scene, settings, {kCausticMap}), settings);
}

std::vector<Mesh> spheres_around(double distance, double radius) {
  std::vector<Mesh> spheres;
  for (int side = 0; side < 6; ++side) {
    glm::dvec3 centre{0.0};
    centre[side / 2] = side % 2 ? -distance : distance;
    spheres.push_back(sphere(centre, radius, 3, 1));
  }
  return spheres;
}

bool sees_all_around(const Scene& scene, const Settings& settings) {
  return effects_of(scene, settings).all_around.active;
}

}  // namespace

TEST_CASE("all around: through glass of index 1 a lamp lights all six walls as it would without") {
  // The glass is a sphere around the lamp, so that all of its light takes the caustics' way. The lamp stands
  // off the middle: the cube's edges cross the walls. A face of the grid has 74 vertices a side here. A cell
  // across an edge of the cube has the flux of its own face's last vertex, whose density is 1.5 / 74 above
  // the edge's: 2 %, measured 3 % with the maps' own texels. At the cube's corners three vertices meet
  // instead of four. Near the room's own edges cells would have to bend, and points are laid instead.
  const glm::dvec3 lamp{0.2, -0.1, 0.15};
  const Scene scene = room_with(lamp, {sphere(lamp, 0.4, 3, 1)}, 1.0f);
  const Settings settings = room_settings(240, 240);
  for (int wall = 0; wall < 6; ++wall) {
    const Wall seen = wall_of(scene, settings, wall);
    double worst = 0.0, corner = 0.0, sum = 0.0, shadowed = 0.0;
    int count = 0;
    for (int y = 0; y < kPixels; ++y)
      for (int x = 0; x < kPixels; ++x) {
        const double expected = from_lamp(lamp, wall, seen.position, x, y);
        const double error = std::fabs(double(seen.caustic.at(x, y, 0)) / expected - 1.0);
        double& kind = in_corner(lamp, seen.position, x, y) ? corner : worst;
        if (near_edge(x, y)) continue;
        kind = std::max(kind, error);
        sum += error;
        ++count;
        shadowed = std::max(shadowed, double(seen.direct.at(x, y, 0)));
      }
    INFO("wall " << wall << ": largest relative error " << worst << ", in corners " << corner << ", mean "
                 << sum / count);
    CHECK(worst < 0.035);
    CHECK(corner < 0.3);
    CHECK(sum / count < 0.004);
    CHECK(shadowed == 0.0);
  }
}

TEST_CASE("all around: from the centre of a glass sphere every wall gets all but R0") {
  // Rays leave along the normal: undeviated, R0 = ((1.5 - 1) / (1.5 + 1))^2 = 0.04.
  const glm::dvec3 lamp{0.1, 0.05, -0.15};
  const Scene scene = room_with(lamp, {sphere(lamp, 0.3, 5, 1)}, 1.5f);
  const Settings settings = room_settings(240, 240);
  for (int wall = 0; wall < 6; ++wall) {
    const Wall seen = wall_of(scene, settings, wall);
    double got = 0.0, expected = 0.0;
    for (int y = 0; y < kPixels; ++y)
      for (int x = 0; x < kPixels; ++x) {
        got += double(seen.caustic.at(x, y, 0));
        expected += 0.96 * from_lamp(lamp, wall, seen.position, x, y);
      }
    CHECK(got == Approx(expected).epsilon(0.005));
  }
}

TEST_CASE("all around: in a closed room no light is outside, and the ledger closes") {
  for (const Splat splat : {Splat::Point, Splat::Gaussian, Splat::Cell}) {
    Settings settings = room_settings(192, 192);
    settings.splat = splat;
    const Ledger l = ledger_in(room_with({0.0, 0.0, 0.0}, spheres_around(0.6, 0.2), 1.5f), settings);
    CHECK(l.outside[0] == 0.0);
    CHECK(l.kernel_edge[0] == 0.0);
    CHECK(l.missed[0] == 0.0);
    CHECK(l.residual() < 1e-5);
    // A sphere of sine 1/3 subtends 2 pi (1 - sqrt(8) / 3) steradians; the mesh lies a little inside it.
    CHECK(l.entered[0] == Approx(6.0 * 2.0 * 3.14159265 * (1.0 - std::sqrt(8.0) / 3.0)).epsilon(0.02));
    CHECK(l.in_map[0] > 0.8 * l.entered[0]);
  }
}

TEST_CASE("all around: a whole sphere of light is 4 pi") {
  const Ledger l = ledger_in(room_with({0.0, 0.0, 0.0}, {sphere({0.0, 0.0, 0.0}, 0.4, 3, 1)}, 1.0f),
                             room_settings(192, 192));
  // The midpoint form's error is 6e-5 at 64 vertices a face and falls with their square.
  CHECK(l.entered[0] == Approx(4.0 * 3.14159265358979).epsilon(2e-4));
  CHECK(l.in_map[0] == Approx(l.entered[0]).epsilon(1e-5));
}

TEST_CASE("all around: a caustic over an edge or a corner of the cube keeps its flux on the walls") {
  // The same sphere in three directions; the lamp and the sphere turn, the room stays. What lands is what
  // entered, and what the walls show of it is what landed: the sum of irradiance times area.
  for (const glm::dvec3& towards :
       {glm::dvec3(1.0, 0.02, 0.03), glm::dvec3(1.0, 0.0, 1.0), glm::dvec3(1.0, -1.0, 1.0)}) {
    const glm::dvec3 centre = 0.5 * glm::normalize(towards);
    Settings settings = room_settings(288, 288);
    settings.cube = Cube::On;
    Scene scene = room_with({0.0, 0.0, 0.0}, {sphere(centre, 0.12, 4, 1)}, 1.1f);
    const Ledger l = ledger_in(scene, settings);
    double shown = 0.0;
    for (int wall = 0; wall < 6; ++wall) {
      const Wall seen = wall_of(scene, settings, wall);
      const double area = 1.96 * 1.96 / (kPixels * kPixels);
      for (int y = 0; y < kPixels; ++y)
        for (int x = 0; x < kPixels; ++x) shown += double(seen.caustic.at(x, y, 0)) * area / 3.0;
    }
    INFO("towards " << towards.x << ", " << towards.y << ", " << towards.z << ": shown " << shown << " of "
                    << l.in_map[0]);
    CHECK(l.residual() < 1e-5);
    // The walls' outermost 2 cm are not in the pictures: of the caustic in the corner that is a part.
    CHECK(shown <= l.in_map[0] * 1.02);
    if (towards.y > 0.0) CHECK(shown == Approx(l.in_map[0]).epsilon(0.02));
  }
}

TEST_CASE("all around: a symmetric room is lit alike on opposite walls") {
  const Scene scene = room_with({0.0, 0.0, 0.0}, {sphere({0.0, 0.0, 0.0}, 0.4, 3, 1)}, 1.0f);
  const Settings settings = room_settings(192, 192);
  const Wall first = wall_of(scene, settings, 0);
  for (int wall = 1; wall < 6; ++wall) {
    const Wall other = wall_of(scene, settings, wall);
    double worst = 0.0;
    for (int y = 0; y < kPixels; ++y)
      for (int x = 0; x < kPixels; ++x)
        if (!near_edge(x, y))
          worst = std::max(
              worst, std::fabs(double(other.caustic.at(x, y, 0)) / double(first.caustic.at(x, y, 0)) - 1.0));
    INFO("wall " << wall << ": " << worst);
    CHECK(worst < 0.005);
  }
}

TEST_CASE("all around: a light outside its casters looks one way unless asked") {
  const Settings settings = room_settings(64, 64);
  const Scene one = room_with({0.0, 0.8, 0.0}, {sphere({0.0, -0.2, 0.0}, 0.3, 2, 1)}, 1.5f);
  const Scene among = room_with({0.0, 0.0, 0.0}, spheres_around(0.6, 0.2), 1.5f);
  CHECK_FALSE(sees_all_around(one, settings));
  CHECK(sees_all_around(among, settings));
  Settings asked = settings;
  asked.cube = Cube::On;
  CHECK(sees_all_around(one, asked));
  asked.cube = Cube::Off;
  CHECK_FALSE(sees_all_around(among, asked));
}

TEST_CASE("all around: a mirror in a closed room calls for it, a spot light and a sun do not") {
  Scene scene = room_with({0.0, 0.8, 0.0}, {sphere({0.0, -0.2, 0.0}, 0.3, 2, 1)}, 1.5f);
  scene.materials[1] = metal({1.0f, 1.0f, 1.0f});
  CHECK(sees_all_around(scene, room_settings(64, 64)));
  scene.lights[0].type = LightType::Spot;
  scene.lights[0].direction = {0.0, -1.0, 0.0};
  scene.lights[0].outer_cone = 0.5f;
  CHECK_FALSE(sees_all_around(scene, room_settings(64, 64)));
  scene.lights[0] = sun({0.0, -1.0, 0.0}, 1.0f);
  Settings asked = room_settings(64, 64);
  asked.cube = Cube::On;
  CHECK_FALSE(sees_all_around(scene, asked));
}

TEST_CASE("all around: maps too small for six tiles are refused where asked for, else said") {
  Settings settings = room_settings(24, 64);
  CHECK_FALSE(sees_all_around(room_with({0.0, 0.0, 0.0}, spheres_around(0.6, 0.2), 1.5f), settings));
  settings.cube = Cube::On;
  CHECK_THROWS_AS(check(settings), Error);
  CHECK(too_small_for_cubes(settings) == "grid is 24, must be at least 48");
}
