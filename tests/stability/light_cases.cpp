// Lights in, on, behind and far from casters; cones and views of all widths; intensities of all sizes.
#include <cmath>

#include "pipeline/scene/far_lights.hpp"
#include "tests/stability/hard_case.hpp"
#include "tests/support/catch.hpp"

namespace caustics::test {

namespace {

constexpr double kHalfTurn = 3.14159265358979323846;

Light lamp(const glm::dvec3& position) {
  Light light{.name = "lamp", .type = LightType::Point, .intensity = 1.0f};
  light.position = position;
  return light;
}

Light spot(const glm::dvec3& position, double inner, double outer) {
  Light light = lamp(position);
  light.type = LightType::Spot;
  light.direction = {0.0, -1.0, 0.0};
  light.inner_cone = static_cast<float>(inner);
  light.outer_cone = static_cast<float>(outer);
  return light;
}

HardCase lit_by(const std::string& name, const std::string& behaviour, const Light& light) {
  HardCase c{name, behaviour, sphere_scene(1.5f, 3)};
  c.scene.lights = {light};
  return c;
}

HardCase on_cube(HardCase c, Cube cube) {
  c.settings.cube = cube;
  if (cube != Cube::Off) c.settings.grid = c.settings.map = 96;  // room for six tiles
  return c;
}

HardCase hidden_case() {
  HardCase c = lit_by("no texel of the caster is lit", "nothing enters; no division by what is seen of it",
                      sun({0.0, -1.0, 0.0}, 1.0f));
  c.scene.meshes.push_back(box({-0.8, 1.6, -0.8}, {0.8, 1.7, 0.8}, 0));
  c.expect = [](const DrawnCase& drawn) {
    CHECK(drawn.ledger().entered[1] == 0.0);
    const Image& caustic = drawn.rendering["aov_caustic"];
    for (const float value : caustic.values) CHECK((value == 0.0f || value == 1.0f));  // 1: alpha
  };
  return c;
}

// The steradians that enter: all that the sphere is seen under from inside.
HardCase inside_case() {
  HardCase c = on_cube(lit_by("a lamp in the middle of a glass sphere",
                              "lights it from inside, all around: 4 pi enters", lamp({0.0, 0.8, 0.0})),
                       Cube::Auto);
  c.expect = [](const DrawnCase& drawn) {
    CHECK(drawn.ledger().entered[1] == Approx(4.0 * kHalfTurn).epsilon(0.01));
  };
  return c;
}

HardCase intensity_case(float intensity) {
  char text[64];
  std::snprintf(text, sizeof text, "a sun of %g lux", static_cast<double>(intensity));
  HardCase c = lit_by(
      text, "maps are relative to the light, so they are those of 1 lux to the bit; the picture stays finite",
      sun({0.0, -1.0, 0.0}, intensity));
  HardCase plain = lit_by("", "", sun({0.0, -1.0, 0.0}, 1.0f));
  c.expect = [plain, intensity](const DrawnCase& drawn) {
    const auto device = make_software_device();
    const DrawnCase one = draw_case(plain, *device, *device);
    CHECK(sha256(drawn.of_light(kCausticMap)) == sha256(one.of_light(kCausticMap)));
    const Image &bright = drawn.rendering["aov_caustic"], &dim = one.rendering["aov_caustic"];
    for (int y = 0; y < bright.height(); ++y)
      for (int x = 0; x < bright.width(); ++x)
        CHECK(double(bright.at(x, y, 0)) ==
              Approx(double(dim.at(x, y, 0)) * static_cast<double>(intensity)).epsilon(1e-5).margin(1e-37));
  };
  return c;
}

HardCase far_case() {
  Light light = lamp({0.0, 1e8, 0.0});
  light.intensity = 1e16f;  // 1 lux at the scene
  HardCase c = lit_by("a lamp a hundred million metres away",
                      "drawn as parallel light: the caustic of a sun of 1 lux", light);
  make_far_lights_parallel(c.scene);
  HardCase plain = lit_by("", "", sun({0.0, -1.0, 0.0}, 1.0f));
  c.expect = [plain](const DrawnCase& drawn) {
    const auto device = make_software_device();
    const DrawnCase one = draw_case(plain, *device, *device);
    CHECK(drawn.scene.notes.size() == 1);
    CHECK(drawn.share(&Ledger::in_map) == Approx(one.share(&Ledger::in_map)).epsilon(1e-3));
    CHECK(drawn.scene.lights[0].intensity == Approx(1.0).epsilon(1e-6));
  };
  return c;
}

HardCase view_case(const std::string& name, const std::string& behaviour,
                   const std::function<void(Camera&)>& change) {
  HardCase c = lit_by(name, behaviour, sun({0.2, -1.0, 0.1}, 1.0f));
  Camera& camera = c.scene.cameras[0];
  camera.orthographic = false;
  camera.position = {0.0, 2.5, 0.0};
  change(camera);
  return c;
}

// Of even brightness in its cone, 2 pi (1 - cos a) steradians, all of which falls on the sphere's top at
// nearly 0 degrees.
HardCase narrow_spot_case() {
  HardCase c =
      lit_by("a spot a milliradian wide", "the grid covers its cone, not the whole caster: pi 1e-6 sr enter",
             spot({0.0, 3.0, 0.0}, 0.000999, 0.001));
  c.expect = [](const DrawnCase& drawn) {
    CHECK(drawn.ledger().entered[1] == Approx(kHalfTurn * 1e-6).epsilon(0.02));
    CHECK(drawn.leaves() == Approx(0.96 * 0.96).margin(0.002));
  };
  return c;
}

HardCase out_of_range_case() {
  Light light = lamp({0.0, 2.0, 0.0});
  light.range = 0.1f;
  HardCase c = lit_by("a caster beyond a lamp's range", "gets no light", light);
  c.expect = [](const DrawnCase& drawn) {
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 24; ++x) CHECK(drawn.rendering["aov_caustic"].at(x, y, 0) == 0.0f);
  };
  return c;
}

HardCase dark_case() {
  HardCase c = lit_by("no light", "no caustic pass runs", lamp({0.0, 2.0, 0.0}));
  c.scene.lights.clear();
  c.expect = [](const DrawnCase& drawn) { CHECK(drawn.ledgers.empty()); };
  return c;
}

}  // namespace

std::vector<HardCase> light_cases() {
  std::vector<HardCase> cases;
  cases.push_back(hidden_case());
  cases.push_back(inside_case());
  cases.push_back(on_cube(
      lit_by("a lamp in a glass sphere, near its wall", "likewise", lamp({0.0, 1.2999, 0.0})), Cube::Auto));
  cases.push_back(on_cube(lit_by("a lamp in a sphere, seen through a window",
                                 "what the window does not see gets no light", lamp({0.0, 0.8, 0.0})),
                          Cube::Off));
  cases.push_back(on_cube(lit_by("a lamp on a vertex of the caster",
                                 "light past the near plane enters, books close", lamp({0.0, 1.3, 0.0})),
                          Cube::Auto));
  cases.push_back(on_cube(
      lit_by("a caster half behind a lamp's near plane", "its other half gets none", lamp({0.45, 1.05, 0.0})),
      Cube::Off));
  cases.push_back(lit_by("a lamp on the floor", "lights the caster from below: what it throws up is missed",
                         lamp({1.0, 0.0, 0.0})));
  cases.push_back(narrow_spot_case());
  cases.push_back(lit_by("a spot of 180 degrees", "a half space", spot({0.0, 1.5, 0.0}, 1.5, 1.5707963)));
  cases.push_back(lit_by("a spot with equal cones", "a sharp edge, no 0/0 between them",
                         spot({0.0, 3.0, 0.0}, 0.3, 0.3)));
  cases.push_back(far_case());
  cases.push_back(out_of_range_case());
  cases.push_back(dark_case());
  for (const float intensity : {1e-30f, 1e30f}) cases.push_back(intensity_case(intensity));
  cases.push_back(
      view_case("a view of 179.9 degrees", "finite texels", [](Camera& c) { c.vertical_fov = 3.1398; }));
  cases.push_back(view_case("a view of a thousandth of a degree", "finite texels",
                            [](Camera& c) { c.vertical_fov = 1.7e-5; }));
  cases.push_back(view_case("a camera inside glass", "looks out of it through its surface", [](Camera& c) {
    c.position = {0.0, 0.8, 0.0};
  }));
  cases.push_back(view_case("near and far a factor of 1e12 apart", "finite texels",
                            [](Camera& c) { c.near = 1e-6, c.far = 1e6; }));
  return cases;
}

}  // namespace caustics::test
