// What a scene is completed with: ground, sun, camera, sky.
#include "pipeline/renderer/stage.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/scene/defaults.hpp"
#include "pipeline/settings/settings.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/pilot.hpp"
#include "tests/support/shapes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A glass ball of radius 1 around the origin; what else there is comes before it.
Scene ball(std::vector<Mesh> others = {}) {
  Scene scene;
  scene.materials = {diffuse(0.8f), glass(1.5f)};
  scene.meshes = std::move(others);
  scene.meshes.push_back(sphere(glm::dvec3(0.0), 1.0, 2, 1));
  return scene;
}

const Mesh* ground_of(const Scene& scene) {
  for (const Mesh& mesh : scene.meshes)
    if (mesh.name == kGroundName) return &mesh;
  return nullptr;
}

// Where the camera shows p: in its picture's half widths and heights; the picture is as wide as 16:9.
glm::dvec2 shown_at(const Camera& camera, const glm::dvec3& p) {
  const glm::dvec3 seen = p - camera.position;
  const double height = glm::dot(seen, camera.forward) * std::tan(0.5 * camera.vertical_fov);
  return {glm::dot(seen, camera.right) / height * 9.0 / 16.0, glm::dot(seen, camera.up) / height};
}

}  // namespace

TEST_CASE("stage: a bare glass object gets a ground, a sun, a camera and a sky, and says so") {
  Scene scene = ball();
  scene.notes = {"loaded"};
  const Completed completed = complete_scene(scene, {}, pilot());
  CHECK(completed.lights);
  CHECK(completed.cameras);
  const Mesh* ground = ground_of(scene);
  REQUIRE(ground);
  // It lies a thousandth of the ball's extent, 2 m, below.
  CHECK(ground->upper.y < -1.0f);
  CHECK(ground->upper.y > -1.0021f);
  CHECK(ground->upper.x - ground->lower.x == Approx(24));
  const Material& grey = scene.materials.at(static_cast<std::size_t>(ground->material));
  CHECK(is_receiver(grey));
  CHECK(grey.fade.to == Approx(12));
  CHECK(ground->object != scene.meshes[0].object);
  const auto corner = [&](std::size_t i) { return ground->vertices[ground->indices[i]].position; };
  for (const std::size_t t : {0u, 3u})
    CHECK(glm::cross(corner(t + 1) - corner(t), corner(t + 2) - corner(t)).y > 0);
  REQUIRE(scene.lights.size() == 1);
  CHECK(glm::length(scene.lights[0].direction) == Approx(1));
  CHECK(scene.lights[0].intensity == 10.0f);
  REQUIRE(scene.cameras.size() == 1);
  CHECK(scene.environment.zenith.x > 0.0f);
  CHECK(scene.notes.size() == 5);
  CHECK(scene.notes.back() == "loaded");
}

TEST_CASE("stage: the added camera shows the object and the focus of its light, and nothing much larger") {
  Scene scene = ball();
  complete_scene(scene, {}, pilot());
  const Camera& camera = scene.cameras.at(0);
  glm::dvec2 most(0.0);
  for (const Vertex& vertex : scene.meshes[0].vertices)
    most = glm::max(most, glm::abs(shown_at(camera, glm::dvec3(vertex.position))));
  CHECK(most.x < 1.0);
  CHECK(most.y < 1.0);
  CHECK(most.y > 0.6);
  // A ball's light crosses its axis behind it: where the axis meets the ground.
  const glm::dvec3 d = scene.lights[0].direction;
  const glm::dvec2 focus = glm::abs(shown_at(camera, d * (-1.0 / d.y)));
  CHECK(focus.x < 1.0);
  CHECK(focus.y < 1.0);
}

TEST_CASE("stage: the added camera shows all of every scene but its floor, at any shape of picture") {
  struct Shape {
    const char* name;
    std::vector<Mesh> meshes;  // 0: opaque, 1: glass
  };
  std::vector<Shape> shapes = {
      {"one ball", {sphere(glm::dvec3(0.0), 1.0, 1, 1)}},
      {"a long rod", {box({-20, 0, -0.1}, {20, 0.2, 0.1}, 1)}},
      {"a mast", {box({-0.1, 0, -0.1}, {0.1, 30, 0.1}, 1)}},
      {"a rod away from the camera", {box({-0.1, 0, -25}, {0.1, 0.2, 25}, 1)}},
      {"a tiny ball", {sphere(glm::dvec3(0.0), 1e-4, 1, 1)}},
      {"a huge ball", {sphere(glm::dvec3(0.0), 1e5, 1, 1)}},
      {"glass beside a large opaque thing", {sphere({-9, 1, 0}, 1.0, 1, 1), box({-5, 0, -5}, {5, 10, 5}, 0)}},
      {"glass on a plinth", {sphere({0, 2, 0}, 1.0, 1, 1), box({-1.3, 0, -1.3}, {1.3, 1, 1.3}, 0)}},
      {"hanging above a floor", {sphere({0, 9, 0}, 1.0, 1, 1), floor(30.0, 0.0, 0)}},
      {"opaque, far off", {sphere({900, 0, 700}, 2.0, 1, 0), sphere({905, 0, 700}, 1.0, 1, 0)}},
  };
  std::vector<Mesh> parts;
  for (int i = 0; i < 40; ++i)
    parts.push_back(sphere({i % 8 * 3.0, i / 8 * 0.7, i % 5 * 4.0}, 0.3 + 0.02 * i, 0, i % 3 == 0 ? 1 : 0));
  shapes.push_back({"many parts", std::move(parts)});
  for (const Shape& shape : shapes)
    for (const auto& [width, height] : {std::pair{640, 360}, {1600, 200}, {200, 900}}) {
      INFO(shape.name << " at " << width << " x " << height);
      Scene scene;
      scene.materials = {diffuse(0.8f), glass(1.5f)};
      scene.meshes = shape.meshes;
      Settings settings;
      settings.width = width;
      settings.height = height;
      complete_scene(scene, settings, pilot());
      const Camera& camera = scene.cameras.at(0);
      glm::dvec2 most(0.0);
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t m = 0; m < shape.meshes.size(); ++m)
        for (const Vertex& vertex : scene.meshes[m].vertices) {
          const glm::dvec3 p(vertex.position);
          nearest = std::min(nearest, glm::dot(p - camera.position, camera.forward));
          if (scene.meshes[m].name == "floor") continue;
          const glm::dvec2 shown =
              glm::abs(shown_at(camera, p)) * glm::dvec2(16.0 / 9.0 * height / width, 1.0);
          most = glm::max(most, shown);
        }
      CHECK(most.x < 1.0);
      CHECK(most.y < 1.0);
      CHECK(std::max(most.x, most.y) > 0.3);  // and not from afar
      if (scene.meshes.back().name == kGroundName) CHECK(nearest > camera.near);
    }
}

TEST_CASE("stage: the added camera stands inside a room whose walls would hide the scene") {
  struct Walls {
    const char* name;
    bool double_sided, inside_out, doubled, outward;
    bool hide;
  };
  // A closed body that winds inward is drawn from both sides; of two coincident walls the outer one hides.
  for (const Walls& walls : {Walls{"one-sided, inward", false, false, false, false, false},
                             {"double-sided", true, false, false, false, true},
                             {"a closed body inside out", false, true, false, false, true},
                             {"one-sided, inward, twice", false, false, true, false, false},
                             {"one-sided, inward and outward", false, false, true, true, true}}) {
    INFO(walls.name);
    Mesh room = box({-2.5, -1, -2.5}, {2.5, 3, 2.5}, 0);
    const std::vector<std::uint32_t> outward = room.indices;
    std::reverse(room.indices.begin(), room.indices.end());
    const std::vector<std::uint32_t> more = walls.outward ? outward : room.indices;
    if (walls.doubled) room.indices.insert(room.indices.end(), more.begin(), more.end());
    room.inside_out = walls.inside_out;
    Scene scene = ball({room});
    scene.materials[0].double_sided = walls.double_sided;
    complete_scene(scene, {}, pilot());
    const Camera& camera = scene.cameras.at(0);
    const glm::dvec3 from_middle = glm::abs(camera.position);
    const bool inside = std::max(from_middle.x, from_middle.z) < 2.5 && camera.position.y < 3.0;
    CHECK(inside == walls.hide);
    CHECK(std::any_of(scene.notes.begin(), scene.notes.end(), [](const std::string& note) {
            return note.find("before the wall") != std::string::npos;
          }) == walls.hide);
    for (const Vertex& vertex : scene.meshes[1].vertices) {
      const glm::dvec2 shown = glm::abs(shown_at(camera, glm::dvec3(vertex.position)));
      REQUIRE(std::max(shown.x, shown.y) < 1.0);
    }
  }
}

TEST_CASE("stage: the added camera shows the shadow on an added ground") {
  Scene scene = ball();
  Settings settings;
  set_option(settings, "sun", "217,35");  // behind the ball: its shadow comes towards the camera
  complete_scene(scene, settings, pilot());
  const glm::dvec3 d = scene.lights[0].direction;
  for (const Vertex& vertex : scene.meshes[0].vertices) {
    const glm::dvec3 p(vertex.position);
    const glm::dvec2 shown = glm::abs(shown_at(scene.cameras.at(0), p - d * ((p.y + 1.0) / d.y)));
    CHECK(shown.x < 1.0);
    CHECK(shown.y < 1.0);
  }
}

TEST_CASE("stage: sun and camera stand where they do whatever the grid is") {
  Scene fine = ball(), coarse = ball();
  Settings settings;
  complete_scene(fine, settings, pilot());
  settings.grid = 64;
  complete_scene(coarse, settings, pilot());
  CHECK(fine.lights[0].direction == coarse.lights[0].direction);
  CHECK(fine.cameras.at(0).position == coarse.cameras.at(0).position);
}

TEST_CASE("stage: a ground is added where the light lands beside what is there") {
  // A floor beneath catches all of it; a shelf of the same size beside the ball nothing.
  Scene caught = ball({floor(4.0, -1.5, 0)}), missed = ball({box({5.0, -1.0, -1.0}, {5.5, 1.0, 1.0}, 0)});
  complete_scene(caught, {}, pilot());
  complete_scene(missed, {}, pilot());
  CHECK_FALSE(ground_of(caught));
  CHECK(caught.materials.size() == 2);
  CHECK(ground_of(missed));
}

TEST_CASE("stage: a ground is laid where it is asked for, at a height of the file's world, or left out") {
  Settings settings;
  Scene scene = ball({floor(4.0, -1.5, 0)});
  scene.origin = {0.0, 2.0, 0.0};
  set_option(settings, "ground", "-1");
  complete_scene(scene, settings, pilot());
  REQUIRE(ground_of(scene));
  CHECK(ground_of(scene)->upper.y == Approx(-3.0));
  set_option(settings, "ground", "off");
  Scene bare = ball();
  complete_scene(bare, settings, pilot());
  CHECK_FALSE(ground_of(bare));
}

TEST_CASE("stage: opaque things that stand on nothing get a ground, those on a floor none") {
  Scene flying = ball(), standing = ball({floor(2.5, -1.0, 0)});
  for (Scene* scene : {&flying, &standing}) {
    scene->meshes.back().material = 0;
    complete_scene(*scene, {}, pilot());
  }
  CHECK(ground_of(flying));
  CHECK_FALSE(ground_of(standing));
}

TEST_CASE("stage: a base, a plinth or a tray that catches all the light is no floor, its own camera or not") {
  for (const double half : {1.0, 1.3, 1.9}) {
    Scene scene = ball({box({-half, -1.4, -half}, {half, -1.0, half}, 0)});
    scene.lights = {sun({0.0, -1.0, 0.0}, 1.0f)};
    Scene shown = scene;
    shown.cameras = {camera_down(4.0, 2.0)};
    complete_scene(scene, {}, pilot());
    complete_scene(shown, {}, pilot());
    REQUIRE(ground_of(scene));
    REQUIRE(ground_of(shown));
    // It lies a thousandth of the extent, at most 3.8 m, below.
    CHECK(ground_of(shown)->upper.y == Approx(-1.4).epsilon(3e-3));
  }
}

TEST_CASE("stage: no ground comes between the scene and its own camera below, nor beside a rolled one") {
  Scene below = ball({box({5.0, -1.0, -1.0}, {5.5, 1.0, 1.0}, 0)}), above = below, rolled = below;
  below.cameras = above.cameras = rolled.cameras = {camera_down(4.0, 1.0)};
  below.cameras[0].position.y = -4.0;
  rolled.cameras[0].right = {0.0, 1.0, 0.0};
  rolled.cameras[0].forward = {0.0, 0.0, -1.0};
  rolled.cameras[0].up = {-1.0, 0.0, 0.0};
  for (Scene* scene : {&below, &above, &rolled}) complete_scene(*scene, {}, pilot());
  CHECK_FALSE(ground_of(below));
  CHECK_FALSE(ground_of(rolled));
  CHECK(ground_of(above));
}

TEST_CASE("stage: a sun that stands level or below is noted, one that lights a floor is not") {
  const auto notes_of = [](const char* stands) {
    Scene scene = ball({floor(4.0, -1.5, 0)});
    Settings settings;
    set_option(settings, "sun", stands);
    complete_scene(scene, settings, pilot());
    std::string notes;
    for (const std::string& note : scene.notes) notes += note;
    return notes;
  };
  CHECK(notes_of("0,0").find("The sun stands on the horizon") != std::string::npos);
  CHECK(notes_of("30,-20").find("The sun shines from below") != std::string::npos);
  CHECK(notes_of("0,3").find("The sun") == std::string::npos);
}

TEST_CASE("stage: a sun and a view that are asked for take the place of the scene's") {
  Settings settings;
  set_option(settings, "sun", "90,30,5");
  set_option(settings, "view", "0,0");
  Scene scene = ball({floor(4.0, -1.5, 0)});
  scene.lights = {sun({0.0, -1.0, 0.0}, 1.0f), sun({0.0, -1.0, 0.0}, 1.0f)};
  scene.cameras = {camera_down(0.2, 1.0)};
  const Completed completed = complete_scene(scene, settings, pilot());
  CHECK(completed.lights);
  CHECK(completed.cameras);
  REQUIRE(scene.lights.size() == 1);
  CHECK(scene.lights[0].intensity == 5.0f);
  // It stands at +x, 30 degrees high.
  CHECK(glm::length(scene.lights[0].direction - glm::dvec3(-std::sqrt(0.75), -0.5, 0.0)) < 1e-7);
  REQUIRE(scene.cameras.size() == 1);
  CHECK(scene.cameras[0].forward.z == Approx(-1.0));
  CHECK(scene.cameras[0].position.z > 1.0);
}

TEST_CASE("stage: a sun that is added gives as much more than an environment image as than a studio") {
  Scene scene = ball();
  scene.environment.image = Image(Format::RGBA32F, 64, 32);
  for (float& value : scene.environment.image->values) value = 10.0f;
  const Completed completed = complete_scene(scene, {}, pilot());
  // 10 nit from everywhere are 10 pi lux, of a studio 30 % of the sun.
  CHECK(scene.lights.at(0).intensity == Approx(10.0 * 3.14159265 / 0.3).epsilon(0.02));
  CHECK(completed.added.at(0).starts_with("a sun of 10"));
  Settings settings;
  set_option(settings, "sun", "90,30,5");
  complete_scene(scene, settings, pilot());
  CHECK(scene.lights.at(0).intensity == 5.0f);
}

TEST_CASE("stage: what the scene has is kept") {
  Scene scene = ball({floor(4.0, -1.5, 0)});
  scene.lights = {sun({0.0, -1.0, 0.0}, 1.0f)};
  scene.cameras = {camera_down(0.2, 1.0)};
  scene.environment.zenith = glm::vec3(1);
  const Completed completed = complete_scene(scene, {}, pilot());
  CHECK_FALSE(completed.lights);
  CHECK_FALSE(completed.cameras);
  CHECK(scene.meshes.size() == 2);
  CHECK(scene.lights.size() == 1);
  CHECK(scene.cameras.size() == 1);
  CHECK(scene.environment.horizon == glm::vec3(0));
  CHECK(scene.notes.empty());
}

TEST_CASE("Smooth metal is a mirror, rough metal receives") {
  Material material;
  material.roughness = 0.2f;
  CHECK(is_mirror(material));
  CHECK_FALSE(is_receiver(material));
  material.roughness = 0.3f;
  CHECK(is_receiver(material));
}

TEST_CASE("The sky follows the light's level: candela fall off with the square of the distance") {
  Scene scene = ball();
  Light lamp;
  lamp.type = LightType::Point;
  lamp.intensity = 100.0f;
  lamp.position = {0, 5, 0};
  scene.lights.push_back(lamp);
  CHECK(light_level(scene) == Approx(4.0));
}

TEST_CASE("stage: what moves is framed by where it comes to, not by its bounds' corners") {
  // A small ball that goes out along x and y, never to both at once.
  Scene by_corners = ball();
  Mesh& mesh = by_corners.meshes.back();
  mesh.upper = glm::vec3(3.0f, 3.0f, 1.0f);
  Scene by_outline = by_corners;
  by_outline.meshes.back().outline = {{3.0f, 0.0f, 0.0f}, {0.0f, 3.0f, 0.0f}};
  complete_scene(by_corners, {}, pilot());
  complete_scene(by_outline, {}, pilot());
  const Camera& camera = by_outline.cameras.at(0);
  CHECK(glm::length(camera.position) < 0.95 * glm::length(by_corners.cameras.at(0).position));
  for (const glm::dvec3 p : {glm::dvec3(3, 0, 0), glm::dvec3(0, 3, 0)}) {
    CHECK(std::abs(shown_at(camera, p).x) < 0.89);
    CHECK(std::abs(shown_at(camera, p).y) < 0.89);
  }
}

TEST_CASE("stage: a scene without anything still gets a light and a camera") {
  Scene scene;
  complete_scene(scene, {}, pilot());
  CHECK(scene.meshes.empty());
  CHECK(scene.lights.size() == 1);
  CHECK(scene.cameras.size() == 1);
}
