// Light that is followed from surface to surface: where surfaces touch, graze, cross, nest, are not closed,
// or have no area.
#include <cmath>

#include "lab/reference/closed_forms.hpp"
#include "tests/stability/hard_case.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/revolved.hpp"

namespace caustics::test {

namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;

glm::dvec3 off_vertical(double degrees) {
  return {std::sin(degrees * kDegree), -std::cos(degrees * kDegree), 0.0};
}

// Bodies of glass over a floor of 4 x 4 m; every light is followed, and nothing is drawn, so that shares can
// be compared without grain.
HardCase followed(const std::string& name, const std::string& behaviour, std::vector<Mesh> bodies,
                  const Light& light = sun({0.0, -1.0, 0.0}, 1.0f)) {
  HardCase c{name, behaviour, {}};
  c.scene.materials = {diffuse(0.8f), glass(1.5f), glass(1.33f), metal(glm::vec3(0.9f)), glass(1.5f)};
  c.scene.meshes = {floor(2.0, 0.0, 0)};
  for (Mesh& body : bodies) {
    body.object = static_cast<int>(c.scene.meshes.size());
    c.scene.meshes.push_back(std::move(body));
  }
  c.scene.lights = {light};
  c.scene.cameras = {camera_down(2.0, 1.0)};
  c.settings = small_settings(32, 32, 16);
  c.settings.further_share = 0.0f;
  c.settings.drawn = false;
  return c;
}

using Expectation = std::function<void(const DrawnCase&)>;

// That light is followed at all; that no more than this share is given up; and what else is expected.
HardCase expecting(HardCase c, double given_up, const Expectation& more = {}) {
  c.expect = [given_up, more](const DrawnCase& drawn) {
    CHECK(drawn.rendering.effects.further_surfaces.active);
    CHECK(drawn.share(&Ledger::given_up) <= given_up);
    if (more) more(drawn);
  };
  return c;
}

// The same shares of the light as another case has, within `margin`, over so many times its area.
Expectation as_in(const HardCase& other, double margin, double area = 1.0) {
  return [other, margin, area](const DrawnCase& drawn) {
    const auto device = make_software_device();
    const DrawnCase one = draw_case(other, *device, *device);
    CHECK(drawn.ledger().entered[1] == Approx(one.ledger().entered[1] * area).epsilon(1e-3));
    for (FluxRgb Ledger::*account : {&Ledger::in_map, &Ledger::absorbed, &Ledger::given_up})
      CHECK(drawn.share(account) == Approx(one.share(account)).margin(margin));
  };
}

Mesh joined(Mesh mesh, const Mesh& other) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const std::uint32_t i : other.indices) mesh.indices.push_back(first + i);
  finish(mesh, 1.0f);
  return mesh;
}

Mesh inside_out(Mesh mesh) {
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
    std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
  for (Vertex& v : mesh.vertices) v.normal = -v.normal;
  return mesh;
}

Mesh without(Mesh mesh, const std::function<bool(const glm::vec3&)>& leaves_out) {
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    glm::vec3 middle(0.0f);
    for (std::size_t k = 0; k < 3; ++k) middle += mesh.vertices[mesh.indices[i + k]].position / 3.0f;
    if (!leaves_out(middle))
      for (std::size_t k = 0; k < 3; ++k) kept.push_back(mesh.indices[i + k]);
  }
  mesh.indices = kept;
  mesh.closedness = 0.5f;
  return mesh;
}

Mesh moved(Mesh mesh, const glm::dvec3& by) {
  for (Vertex& v : mesh.vertices) v.position = glm::vec3(glm::dvec3(v.position) + by);
  finish(mesh, mesh.closedness);
  return mesh;
}

// About the z axis, so that no coordinate of a wall is a round number.
Mesh turned(Mesh mesh, double degrees) {
  const double c = std::cos(degrees * kDegree), s = std::sin(degrees * kDegree);
  for (Vertex& v : mesh.vertices)
    for (glm::vec3* p : {&v.position, &v.normal}) {
      const glm::dvec3 q(*p);
      *p = glm::vec3(glm::dvec3(c * q.x - s * q.y, s * q.x + c * q.y, q.z));
    }
  finish(mesh, mesh.closedness);
  return mesh;
}

// A cup whose walls and base are 4 cm thick, and what is poured into it: `overlap` is how far it reaches into
// the glass, metres. Materials 1 and 2.
Mesh cup() {
  Mesh mesh;
  mesh.name = "cup";
  mesh.material = 1;
  const auto band = [&](const ProfilePoint& a, const ProfilePoint& b) { revolve(mesh, {a, b}, 24); };
  band({0.0, 0.1, 0.0, -1.0}, {0.4, 0.1, 0.0, -1.0});
  band({0.4, 0.1, 1.0, 0.0}, {0.4, 0.6, 1.0, 0.0});
  band({0.4, 0.6, 0.0, 1.0}, {0.36, 0.6, 0.0, 1.0});
  band({0.36, 0.6, -1.0, 0.0}, {0.36, 0.14, -1.0, 0.0});
  band({0.36, 0.14, 0.0, 1.0}, {0.0, 0.14, 0.0, 1.0});
  finish(mesh, 1.0f);
  return mesh;
}
Mesh liquid(double overlap) {
  return moved(ring(0.0, 0.36 + overlap, 0.3 + overlap, 24, 2), {0.0, 0.14 - overlap, 0.0});
}

Mesh plate(double lower, double upper, int material = 1) {
  return box({-0.5, lower, -0.5}, {0.5, upper, 0.5}, material);
}
Mesh ball(double radius, int material = 1) { return sphere({0.0, 0.8, 0.0}, radius, 3, material); }

// At normal incidence a surface of glass lets 0.96 through: 0.9216 pass two. What the second mirrors leaves
// by the first.
void passes_plate(const DrawnCase& drawn) {
  CHECK(drawn.share(&Ledger::in_map) == Approx(0.9216).margin(1e-5));
}

// A tube of 0.1 m along a lying eight.
Mesh figure_of_eight() {
  constexpr int kAlong = 48, kAround = 10;
  Mesh mesh;
  mesh.name = "eight";
  mesh.material = 1;
  for (int i = 0; i < kAlong; ++i) {
    const double t = 360.0 * i / kAlong * kDegree;
    const glm::dvec3 middle(0.5 * std::sin(t), 0.6, 0.3 * std::sin(2.0 * t)), up(0.0, 1.0, 0.0);
    const glm::dvec3 way = glm::normalize(glm::dvec3(0.5 * std::cos(t), 0.0, 0.6 * std::cos(2.0 * t)));
    for (int j = 0; j < kAround; ++j) {
      const double angle = 360.0 * j / kAround * kDegree;
      const glm::dvec3 out = std::cos(angle) * up + std::sin(angle) * glm::cross(way, up);
      mesh.vertices.push_back({.position = glm::vec3(middle + 0.1 * out), .normal = glm::vec3(out)});
    }
  }
  for (int i = 0; i < kAlong; ++i)
    for (int j = 0; j < kAround; ++j) {
      const auto at = [&](int along, int around) {
        return static_cast<std::uint32_t>((i + along) % kAlong * kAround + (j + around) % kAround);
      };
      for (const std::uint32_t v : {at(0, 0), at(1, 1), at(1, 0), at(0, 0), at(0, 1), at(1, 1)})
        mesh.indices.push_back(v);
    }
  finish(mesh, 1.0f);
  return mesh;
}

HardCase grazing(double degrees) {
  char text[64];
  std::snprintf(text, sizeof text, "light %g degrees off a glass plate's normal", degrees);
  HardCase c = followed(text, "what is let through and what is mirrored are followed", {plate(0.3, 0.4)},
                        sun(off_vertical(degrees), 1.0f));
  c.scene.meshes[0] = floor(60.0, 0.0, 0);
  // Light that has entered a plate by a side at a grazing angle is totally reflected from wall to wall.
  return expecting(c, 5e-3);
}

// Bodies that touch, and what they are as.
HardCase touching(const std::string& name, const std::string& behaviour, std::vector<Mesh> bodies,
                  const Light& light, std::vector<Mesh> as, double margin) {
  return expecting(followed(name, behaviour, std::move(bodies), light), margin,
                   as_in(followed("", "", std::move(as), light), margin));
}

void add_touching(std::vector<HardCase>& cases) {
  const Light upright = sun({0.0, -1.0, 0.0}, 1.0f), slanted = sun(off_vertical(30.0), 1.0f);
  cases.push_back(touching("a plate upon a plate, light along their normals", "as one plate of both",
                           {plate(0.3, 0.4), plate(0.4, 0.5)}, upright, {plate(0.3, 0.5)}, 1e-5));
  cases.push_back(touching("a plate upon a plate, slanted light", "likewise",
                           {plate(0.3, 0.4), plate(0.4, 0.5)}, slanted, {plate(0.3, 0.5)}, 1e-5));
  cases.push_back(touching("both turned by 20 degrees", "likewise: rounding puts no air between them",
                           {turned(plate(0.5, 0.7), 20.0), turned(plate(0.7, 0.9), 20.0)}, slanted,
                           {turned(plate(0.5, 0.9), 20.0)}, 1e-5));
  cases.push_back(
      touching("two cubes side by side", "as one block",
               {box({-0.5, 0.2, -0.5}, {0.0, 0.7, 0.5}, 1), box({0.0, 0.2, -0.5}, {0.5, 0.7, 0.5}, 4)},
               slanted, {box({-0.5, 0.2, -0.5}, {0.5, 0.7, 0.5}, 1)}, 1e-5));
  cases.push_back(touching("every triangle twice in one mesh", "as once", {joined(ball(0.5), ball(0.5))},
                           slanted, {ball(0.5)}, 1e-4));
  cases.push_back(touching("liquid whose surface is the glass's own",
                           "as liquid that reaches a tenth of a millimetre into it", {cup(), liquid(0.0)},
                           slanted, {cup(), liquid(1e-4)}, 3e-3));
  cases.push_back(touching("glass exactly on the floor", "as a tenth of a millimetre above it",
                           {plate(0.0, 0.3)}, slanted, {plate(1e-4, 0.3001)}, 1e-5));
}

void add_meshes(std::vector<HardCase>& cases) {
  const Light slanted = sun(off_vertical(30.0), 1.0f);
  const auto as_ball = [&](const std::string& name, const std::string& behaviour, Mesh mesh, double margin) {
    return touching(name, behaviour, {std::move(mesh)}, slanted, {ball(0.5)}, margin);
  };
  Mesh degenerate = ball(0.5), cracked = ball(0.5);
  const auto last = static_cast<std::uint32_t>(degenerate.vertices.size());
  for (const glm::vec3& p :
       {glm::vec3(0.0f), {1e-20f, 0.0f, 0.0f}, {0.0f, 1e-20f, 1e-20f}, {1e-7f, 0.0f, 1e-7f}})
    degenerate.vertices.push_back(
        {.position = p + glm::vec3(0.0f, 0.8f, 0.0f), .normal = {0.0f, 1.0f, 0.0f}});
  for (const std::uint32_t v :
       {0u, 0u, 1u, 0u, 1u, 1u, last, last + 1, last + 2, last, last + 1, last + 3, 0u, 1u, last})
    degenerate.indices.push_back(v);
  finish(degenerate, 1.0f);
  cases.push_back(
      as_ball("corners twice, and 1e-20 m apart, inside a ball", "as without them", degenerate, 5e-2));
  // Each triangle by itself, drawn together by a millionth.
  std::vector<Vertex> apart;
  for (const std::uint32_t i : cracked.indices) apart.push_back(cracked.vertices[i]);
  for (std::size_t i = 0; i < apart.size(); ++i) {
    const glm::vec3 middle =
        (apart[i / 3 * 3].position + apart[i / 3 * 3 + 1].position + apart[i / 3 * 3 + 2].position) / 3.0f;
    cracked.indices[i] = static_cast<std::uint32_t>(i);
    cracked.vertices.resize(apart.size());
    cracked.vertices[i] = apart[i];
    cracked.vertices[i].position += (middle - apart[i].position) * 2e-5f;
  }
  finish(cracked, 1.0f);
  cases.push_back(as_ball("cracks of a micrometre along all edges", "as none", cracked, 2e-3));
  const auto alone = [&](const std::string& name, const std::string& behaviour, Mesh mesh, double given_up) {
    cases.push_back(expecting(followed(name, behaviour, {std::move(mesh)}, slanted), given_up));
  };
  alone("inside out", "light begins inside it", inside_out(ball(0.5)), 0.0);
  cases.push_back(followed("a ball without its lower half", "light that has entered stays in the body",
                           {without(ball(0.5), [](const glm::vec3& p) { return p.y < 0.8f; })}, slanted));
  alone("a ball without its upper half", "light comes from inside",
        without(ball(0.5), [](const glm::vec3& p) { return p.y > 0.8f; }), 0.0);
  alone("a cup without its base", "likewise", without(cup(), [](const glm::vec3& p) { return p.y < 0.15f; }),
        0.0);
  // Light that enters where they cut is totally reflected from wall to wall.
  alone("a tube that runs through itself", "light is in it until it has left both its parts",
        figure_of_eight(), 0.1);
  Mesh left = moved(ball(0.4), {-0.2, 0.0, 0.0}), right = moved(ball(0.4, 4), {0.2, 0.05, 0.0});
  cases.push_back(expecting(
      followed("two balls of one mesh that cut each other", "as two bodies", {joined(left, right)}, slanted),
      0.1, as_in(followed("", "", {left, right}, slanted), 1e-5)));
}

// Light in the plane of the diagonals that cut a box's faces in two: each ray of some runs along one.
HardCase along_edges() {
  const Light light = sun({1.0, -2.0, 1.0}, 1.0f);
  Mesh cut_otherwise = plate(0.3, 0.6);
  for (Vertex& v : cut_otherwise.vertices)
    for (glm::vec3* p : {&v.position, &v.normal}) *p = {p->z, p->y, -p->x};
  return touching("light along the edges that triangles share", "as with the faces cut the other way",
                  {plate(0.3, 0.6)}, light, {cut_otherwise}, 1e-5);
}

// Slanted, so that what it throws back lands.
HardCase silvered() {
  const auto slanted = [](Mesh mesh) { return moved(turned(std::move(mesh), 60.0), {0.0, 0.6, 0.0}); };
  return touching("a glass plate upon metal", "is met by the metal from within the glass",
                  {slanted(plate(0.2, 0.3, 3)), slanted(plate(0.3, 0.4))}, sun({0.0, -1.0, 0.0}, 1.0f),
                  {slanted(plate(0.2, 0.3, 3)), slanted(plate(0.2999, 0.4))}, 1e-3);
}

// All of it, and the light.
HardCase sized(double factor) {
  char text[64];
  std::snprintf(text, sizeof text, "a cup of liquid %g times as large", factor);
  const Light slanted = sun(off_vertical(30.0), 1.0f);
  const HardCase plain = followed("", "", {cup(), liquid(0.0)}, slanted);
  HardCase c = plain;
  c.name = text;
  c.behaviour = "the same shares of the light";
  for (Mesh& mesh : c.scene.meshes) {
    for (Vertex& v : mesh.vertices) v.position = glm::vec3(glm::dvec3(v.position) * factor);
    finish(mesh, mesh.closedness);
  }
  Camera& camera = c.scene.cameras[0];
  camera.position *= factor;
  for (double* length : {&camera.half_width, &camera.half_height, &camera.near, &camera.far})
    *length *= factor;
  return expecting(c, 1e-3, as_in(plain, 3e-3, factor * factor));
}

HardCase on_a_table() {
  HardCase c = followed("a cup over a table over a floor", "light lands on both",
                        {moved(cup(), {0.0, 0.3, 0.0}), box({-0.2, 0.2, -0.2}, {0.2, 0.3, 0.2}, 0)},
                        sun(off_vertical(30.0), 1.0f));
  return expecting(c, 1e-3);
}

HardCase dispersing() {
  HardCase c = followed("a cup of liquid, both dispersing", "each line goes its own way",
                        {cup(), liquid(0.0)}, sun(off_vertical(30.0), 1.0f));
  for (const std::size_t m : {std::size_t{1}, std::size_t{2}}) c.scene.materials[m].dispersion = 1.0f;
  return expecting(c, 2e-2);
}

HardCase nested(int bodies, double given_up, const Expectation& more) {
  std::vector<Mesh> balls;
  for (int i = 0; i < bodies; ++i) balls.push_back(ball(0.5 - 0.06 * i));
  HardCase c = expecting(followed(std::to_string(bodies) + " balls, one in the other", "", std::move(balls)),
                         given_up, more);
  c.scene.materials[1].ior = 1.0f;
  return c;
}

HardCase lamp_in(const std::string& name, const std::string& behaviour, std::vector<Mesh> bodies,
                 const glm::dvec3& position) {
  Light lamp{.name = "lamp", .type = LightType::Point, .intensity = 1.0f};
  lamp.position = position;
  HardCase c = followed(name, behaviour, std::move(bodies), lamp);
  c.settings.grid = c.settings.map = 96;  // room for six tiles
  return c;
}

HardCase camera_in(const std::string& name, const glm::dvec3& position) {
  HardCase c = followed(name, "looks out of it", {cup(), liquid(1e-3)}, sun(off_vertical(30.0), 1.0f));
  c.scene.cameras[0].orthographic = false;
  c.scene.cameras[0].position = position;
  c.scene.cameras[0].vertical_fov = 1.5;
  return c;
}

}  // namespace

std::vector<HardCase> followed_cases() {
  std::vector<HardCase> cases;
  for (const double degrees : {80.0, 89.0}) cases.push_back(grazing(degrees));
  cases.push_back(
      expecting(followed("walls along the light", "take none of it", {plate(0.3, 0.4)}), 0.0, passes_plate));
  cases.push_back(expecting(
      followed("a plate a micrometre thick", "is entered and left, once each", {plate(0.4, 0.4 + 1e-6)}), 0.0,
      passes_plate));
  add_touching(cases);
  add_meshes(cases);
  cases.push_back(along_edges());
  cases.push_back(silvered());
  for (const double factor : {1e-4, 1e5}) cases.push_back(sized(factor));
  cases.push_back(on_a_table());
  cases.push_back(dispersing());
  cases.push_back(nested(4, 1e-5, {}));
  // The fifth has 0.26 m of 0.5 m.
  cases.push_back(nested(6, 1.0, [](const DrawnCase& drawn) {
    CHECK(drawn.share(&Ledger::given_up) == Approx(0.26 * 0.26 / 0.25).margin(0.015));
  }));
  cases.push_back(expecting(lamp_in("a lamp in a ball of glass", "", {ball(0.5)}, {0.1, 0.9, 0.0}), 0.0));
  cases.push_back(
      expecting(lamp_in("a lamp in the liquid of a cup", "", {cup(), liquid(1e-3)}, {0.1, 0.3, 0.0}), 1e-3));
  cases.push_back(expecting(camera_in("a camera in a cup's glass", {0.38, 0.4, 0.0}), 0.0));
  cases.push_back(expecting(camera_in("a camera in a cup's liquid", {0.1, 0.3, 0.0}), 0.0));
  return cases;
}

}  // namespace caustics::test
