#include "pipeline/effects/textured_casters.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

constexpr Effect Effects::*kEffects[3] = {&Effects::textured_casters, &Effects::normal_mapped_casters,
                                          &Effects::cut_out_casters};

// A glass square of 2 x 2 m whose texture coordinates run from 0 to 1, over a floor; images of 64 x 64
// texels.
Scene glass_square() {
  Scene scene;
  scene.materials = {diffuse(0.8f), glass(1.5f)};
  scene.meshes = {floor(2.0, 0.0, 0), floor(1.0, 1.0, 1)};
  const glm::vec2 uv[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (std::size_t i = 0; i < 4; ++i) scene.meshes[1].vertices[i].uv = uv[i];
  scene.images = {Image(Format::RGBA32F, 64, 64)};
  scene.lights = {sun({0.0, -1.0, 0.0}, 1.0f)};
  return scene;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("textured casters: factors alone, and textures of other surfaces, call for nothing") {
  Scene scene = glass_square();
  scene.materials[1].base_color = {0.2f, 0.4f, 0.6f, 0.1f};
  scene.materials[0].base_color_texture.image = scene.materials[0].normal_texture.image = 0;
  scene.materials[0].alpha_mode = AlphaMode::Mask;
  const Effects effects = effects_of(scene, {});
  for (Effect Effects::*effect : kEffects) CHECK_FALSE((effects.*effect).active);
  CHECK(caster_detail(effects) == CasterDetail::None);
  CHECK_FALSE(detailed_exits(effects));
}

TEST_CASE("textured casters: each kind of texture calls for its effect and names the material") {
  Scene scene = glass_square();
  Material& m = scene.materials[1];
  m.transmission_texture.image = 0;
  CHECK(effects_of(scene, {}).textured_casters.active);
  CHECK(contains(effects_of(scene, {}).textured_casters.reason, "counts as absorbed"));
  CHECK(caster_detail(effects_of(scene, {})) == CasterDetail::Colors);
  CHECK_FALSE(detailed_exits(effects_of(scene, {})));
  m.transmission_texture = {};
  m.normal_texture.image = 0;
  CHECK(effects_of(scene, {}).normal_mapped_casters.active);
  CHECK(contains(effects_of(scene, {}).normal_mapped_casters.reason, "material 'glass'"));
  CHECK(caster_detail(effects_of(scene, {})) == CasterDetail::Normals);
  CHECK(detailed_exits(effects_of(scene, {})));
  m.normal_scale = 0.0f;
  CHECK_FALSE(effects_of(scene, {}).normal_mapped_casters.active);
}

TEST_CASE("textured casters: a mask cuts holes where a texture varies it or the factor is below the cutoff") {
  Scene scene = glass_square();
  Material& m = scene.materials[1];
  m.alpha_mode = AlphaMode::Mask;
  CHECK_FALSE(effects_of(scene, {}).cut_out_casters.active);
  m.base_color.a = m.alpha_cutoff;
  CHECK_FALSE(effects_of(scene, {}).cut_out_casters.active);
  m.base_color.a = 0.4f;
  CHECK(effects_of(scene, {}).cut_out_casters.active);
  m.base_color.a = 1.0f;
  m.base_color_texture.image = 0;
  CHECK(effects_of(scene, {}).cut_out_casters.active);
}

TEST_CASE("textured casters: normals finer than the grid are told, with the ratio") {
  // 64 texels across, tiled 16 times each way: 1024 over a grid of 256 vertices.
  Scene scene = glass_square();
  scene.materials[1].normal_texture.image = 0;
  Settings settings;
  settings.grid = 256;
  CHECK_FALSE(contains(effects_of(scene, settings).normal_mapped_casters.reason, "finer"));
  scene.materials[1].normal_texture.uv_transform[0][0] = 16.0f;
  scene.materials[1].normal_texture.uv_transform[1][1] = -16.0f;
  CHECK(contains(effects_of(scene, settings).normal_mapped_casters.reason,
                 "finer than the grid, 4.0 or more to a grid vertex"));
}

TEST_CASE("textured casters: glass shows receivers' emissive textures and colours of vertices too") {
  Scene scene = glass_square();
  CHECK_FALSE(effects_of(scene, {}).textured_receivers.active);
  scene.materials[0].emissive_texture.image = 0;
  CHECK(effects_of(scene, {}).textured_receivers.active);
  scene.materials[0].emissive_texture = {};
  scene.meshes[0].colors.assign(scene.meshes[0].vertices.size(), glm::vec4(0.5f));
  CHECK(contains(effects_of(scene, {}).textured_receivers.reason, "its vertices' colours"));
}
