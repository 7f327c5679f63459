// A white furnace: in light of 1 from all around, what takes no light is as bright as what is around it.
#include <cmath>
#include <vector>

#include "tests/support/catch.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

constexpr int kPicture = 48;

// A ball that fills nearly all of the picture.
struct Furnace {
  Material material;
  Mesh mesh = sphere({0.0, 0.0, 0.0}, 1.0, 5, 0);
  Settings settings = small_settings(16, 16, kPicture);
  std::vector<Image> images{};

  // Straight on, and within the outer tenth of the ball: the least and the most.
  struct Seen {
    double middle, least, most;
  };
  Seen seen() const {
    Scene scene;
    scene.materials = {material};
    scene.meshes = {mesh};
    scene.images = images;
    scene.cameras = {camera_down(4.0, 1.05)};
    scene.environment.zenith = scene.environment.horizon = scene.environment.ground = glm::vec3(1.0f);
    const Rendering drawn = render(scene, settings, {"beauty"});
    const Image& beauty = drawn["beauty"];
    Seen seen{beauty.at(kPicture / 2, kPicture / 2, 1), 1e30, 0.0};
    for (int y = 0; y < kPicture; ++y)
      for (int x = 0; x < kPicture; ++x) {
        const double u = 1.05 * (2.0 * (x + 0.5) / kPicture - 1.0),
                     v = 1.05 * (2.0 * (y + 0.5) / kPicture - 1.0);
        if (u * u + v * v > 0.96 * 0.96) continue;
        const double value = beauty.at(x, y, 1);
        seen.least = std::min(seen.least, value);
        seen.most = std::max(seen.most, value);
      }
    return seen;
  }
  void check() const {
    const Seen found = seen();
    CHECK(found.middle == Approx(1.0).margin(0.005));
    CHECK(found.least > 0.99);
    CHECK(found.most < 1.01);
  }
};

Material white(float roughness) {
  Material m = diffuse(1.0f);
  m.roughness = roughness;
  return m;
}

Material metal(float roughness) {
  Material m = white(roughness);
  m.metallic = m.metallic_factor = 1.0f;
  return m;
}

// What white microfacets send back of light straight onto them, once: the rest, which meets further ones, is
// lost to them (Walter, Marschner, Li, Torrance 2007: GGX with Smith's masking). Over the facets' angle t.
double sent_once(double roughness) {
  const double a2 = std::pow(roughness, 4.0);
  constexpr int kSteps = 100000;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    // Light that a facet leaning by t mirrors leaves at 2 t; flatter than t = 45 degrees it does not leave.
    const double t = 0.25 * 3.14159265358979 * (i + 0.5) / kSteps;
    const double c = std::cos(t), d = a2 / (3.14159265358979 * std::pow(c * c * (a2 - 1.0) + 1.0, 2.0));
    const double out = std::cos(2.0 * t), tangent2 = std::pow(std::tan(2.0 * t), 2.0);
    const double unmasked = 2.0 / (1.0 + std::sqrt(1.0 + a2 * tangent2));
    // f cos(o) do with f = D G / (4 cos(o)) and do = 4 cos(t) dh: D G cos(t) dh.
    if (out > 0.0) sum += d * unmasked * c * 2.0 * 3.14159265358979 * std::sin(t);
  }
  return sum * 0.25 * 3.14159265358979 / kSteps;
}

}  // namespace

TEST_CASE("furnace: rough glass is as bright as what is around it, solid and as walls") {
  for (const float roughness : {0.3f, 0.7f}) {
    INFO("roughness " << roughness);
    Furnace furnace{.material = glass(1.5f)};
    furnace.material.roughness = roughness;
    furnace.check();
    furnace.material.thickness = 0.0f;
    furnace.check();
  }
}

TEST_CASE("furnace: a white mirror is invisible, and rough white metal lacks what meets two microfacets") {
  Furnace{.material = metal(0.0f)}.check();
  for (const float roughness : {0.5f, 1.0f}) {
    INFO("roughness " << roughness);
    const Furnace::Seen seen = Furnace{.material = metal(roughness)}.seen();
    CHECK(seen.middle == Approx(sent_once(static_cast<double>(roughness))).margin(0.03));
    CHECK(seen.most < 1.01);
  }
}

TEST_CASE("furnace: white textures leave white glass invisible, whatever share they let through") {
  Furnace furnace{.material = glass(1.5f)};
  furnace.mesh.has_uv = true;
  furnace.images = {Image(Format::RGBA32F, 2, 2), Image(Format::RGBA32F, 2, 2)};
  for (float& value : furnace.images[0].values) value = 1.0f;
  for (std::size_t i = 0; i < furnace.images[1].values.size(); ++i)
    furnace.images[1].values[i] = i / 4 % 2 == 0 ? 1.0f : 0.5f;
  furnace.material.base_color_texture.image = 0;
  furnace.check();
  furnace.material.transmission_texture.image = 1;
  furnace.material.transmission = 0.75f;  // the mean
  furnace.material.transmission_factor = 1.0f;
  furnace.check();
}

TEST_CASE("furnace: a white surface under its coat is white, whatever its roughness") {
  for (const float roughness : {0.0f, 0.25f, 0.5f, 1.0f}) {
    INFO("roughness " << roughness);
    Furnace{.material = white(roughness)}.check();
  }
}

TEST_CASE("furnace: clear glass is invisible, followed or through two surfaces") {
  for (const float ior : {1.33f, 1.5f, 2.417f})
    for (const bool followed : {true, false}) {
      INFO("index " << ior << (followed ? ", followed" : ", through two surfaces"));
      Furnace furnace{.material = glass(ior)};
      if (!followed) furnace.settings = through_two_surfaces(furnace.settings);
      furnace.check();
    }
}

TEST_CASE("furnace: a clear thin pane is invisible") {
  Furnace furnace{.material = glass(1.5f), .mesh = floor(1.05, 0.0, 0)};
  furnace.material.thickness = 0.0f;
  furnace.check();
}

TEST_CASE("furnace: white glass that lets a share through scatters the rest: none is lost, none made") {
  for (const float transmission : {0.25f, 0.6f}) {
    INFO("transmission " << transmission);
    Furnace solid{.material = glass(1.5f)};
    solid.material.transmission = transmission;
    solid.check();
    Furnace pane{.material = solid.material, .mesh = floor(1.05, 0.0, 0)};
    pane.material.thickness = 0.0f;
    pane.check();
    pane.material.alpha_mode = AlphaMode::Blend;
    pane.material.base_color.a = 0.5f;
    pane.check();
  }
}

TEST_CASE("furnace: without KHR_materials_specular's share nothing is mirrored, and white stays white") {
  for (const float factor : {0.0f, 0.5f}) {
    INFO("specular " << factor);
    Furnace furnace{.material = white(0.3f)};
    furnace.material.fresnel_factor = factor;
    furnace.check();
    furnace.material = glass(1.5f);
    furnace.material.fresnel_factor = factor;
    furnace.check();
  }
}
