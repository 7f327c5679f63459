// Scenes of all sizes and far from the origin.
#include <cmath>

#include "tests/stability/hard_case.hpp"
#include "tests/support/catch.hpp"

namespace caustics::test {

namespace {

void scale(Mesh& mesh, double factor) {
  for (Vertex& v : mesh.vertices) v.position = glm::vec3(glm::dvec3(v.position) * factor);
  finish(mesh, mesh.closedness);
}

void scale(Scene& scene, double factor) {
  for (Mesh& mesh : scene.meshes) scale(mesh, factor);
  for (Camera& camera : scene.cameras) {
    camera.position *= factor;
    for (double* length : {&camera.half_width, &camera.half_height, &camera.near, &camera.far})
      *length *= factor;
  }
  for (Light& light : scene.lights) light.position *= factor;
}

Scene base_scene() {
  Scene scene = sphere_scene(1.5f, 4);
  scene.lights = {sun({0.2, -1.0, 0.1}, 1.0f)};
  return scene;
}

HardCase sized_case(double factor) {
  char text[64];
  std::snprintf(text, sizeof text, "everything %g times as large", factor);
  HardCase c{text, "the same shares of the flux and the same caustic", base_scene()};
  scale(c.scene, factor);
  HardCase plain{"", "", base_scene()};
  c.expect = [plain, factor](const DrawnCase& drawn) {
    const auto device = make_software_device();
    const DrawnCase one = draw_case(plain, *device, *device);
    CHECK(drawn.ledger().entered[1] == Approx(one.ledger().entered[1] * factor * factor).epsilon(1e-3));
    CHECK(drawn.share(&Ledger::in_map) == Approx(one.share(&Ledger::in_map)).epsilon(2e-3));
    // Rounded coordinates move edges of cells: single pixels differ, the caustic does not.
    const Image &a = drawn.rendering["aov_caustic"], &b = one.rendering["aov_caustic"];
    double difference = 0.0, total = 0.0;
    for (int y = 0; y < a.height(); ++y)
      for (int x = 0; x < a.width(); ++x) {
        difference += std::fabs(double(a.at(x, y, 0)) - double(b.at(x, y, 0)));
        total += double(b.at(x, y, 0));
      }
    CHECK(difference < 0.02 * total);
  };
  return c;
}

// Single precision has steps of a sixteenth of a metre there; the loader moves scenes to the origin before it
// rounds (tests/scene), so that this does not happen to files.
HardCase shifted_case() {
  HardCase c{"a scene left at 1e4 m from its origin",
             "coarser by the coordinates' steps of a millimetre, never broken", base_scene()};
  const glm::dvec3 shift(1e4, 0.0, -1e4);
  for (Mesh& mesh : c.scene.meshes) {
    for (Vertex& v : mesh.vertices) v.position = glm::vec3(glm::dvec3(v.position) + shift);
    finish(mesh, mesh.closedness);
  }
  c.scene.cameras[0].position += shift;
  c.expect = [](const DrawnCase& drawn) { CHECK(drawn.leaves() == Approx(0.8355).margin(0.05)); };
  return c;
}

HardCase tiny_in_vast_case(double half, const std::string& name, const std::string& behaviour,
                           bool resolved) {
  HardCase c{name, behaviour, base_scene()};
  scale(c.scene.meshes[1], 1e-3);
  scale(c.scene.meshes[0], half / 3.0);
  if (resolved)
    c.expect = [](const DrawnCase& drawn) {
      CHECK(drawn.share(&Ledger::in_map) == Approx(0.8355).margin(0.02));
    };
  return c;
}

HardCase vast_over_tiny_case() {
  HardCase c{"a caster of a kilometre over a floor of a metre", "what passes the floor is booked",
             base_scene()};
  scale(c.scene.meshes[1], 1e3);
  return c;
}

HardCase flat_case() {
  HardCase c{"a caster flattened to a millionth", "a lens that bends nothing", base_scene()};
  for (Vertex& v : c.scene.meshes[1].vertices) {
    v.position.y = 0.8f + 1e-6f * (v.position.y - 0.8f);
    v.normal = {0.0f, v.normal.y < 0.0f ? -1.0f : 1.0f, 0.0f};
  }
  finish(c.scene.meshes[1], 1.0f);
  return c;
}

}  // namespace

std::vector<HardCase> scale_cases() {
  std::vector<HardCase> cases;
  for (const double factor : {1e-4, 1e-2, 1e2, 1e5}) cases.push_back(sized_case(factor));
  cases.push_back(shifted_case());
  cases.push_back(tiny_in_vast_case(15.0, "a caster of a millimetre over a floor of thirty metres",
                                    "maps are framed on the caster and on its light, not on the floor",
                                    true));
  cases.push_back(tiny_in_vast_case(
      9e3, "a caster of a millimetre over a floor of eighteen kilometres",
      "beyond single precision (a part in 2^24): landings scatter, and what is off is booked", false));
  cases.push_back(vast_over_tiny_case());
  cases.push_back(flat_case());
  return cases;
}

}  // namespace caustics::test
