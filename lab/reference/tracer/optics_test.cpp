#include "lab/reference/tracer/optics.hpp"

#include "tests/support/catch.hpp"

using namespace caustics;
using namespace caustics::tracer;

namespace {

// Two texels side by side: 0.2 and 0.6, opaque and not.
Scene with_two_texels() {
  Scene scene;
  Image image(Format::RGBA32F, 2, 1);
  image.values = {0.2f, 0.2f, 0.2f, 1.0f, 0.6f, 0.6f, 0.6f, 0.0f};
  scene.images = {image};
  return scene;
}

Material textured(Wrap wrap = Wrap::Repeat) {
  Material material;
  material.transmission = material.transmission_factor = 1.0f;
  material.metallic = 0.0f;
  material.base_color_texture.image = 0;
  material.base_color_texture.wrap_u = wrap;
  return material;
}

double red_at(const Material& material, double u) {
  const Optics plain{.role = Role::Refractor, .ior = 1.5};
  return dressed(with_two_texels(), material, plain, {u, 0.5}).color.x;
}

}  // namespace

TEST_CASE("tracer optics: between two texels' middles glass has the mixture of their colours") {
  CHECK(red_at(textured(), 0.25) == Approx(0.2));
  CHECK(red_at(textured(), 0.5) == Approx(0.4));
  CHECK(red_at(textured(), 0.625) == Approx(0.5));
}

TEST_CASE("tracer optics: beyond its sides a picture is repeated, mirrored, or goes on as its border") {
  CHECK(red_at(textured(), 1.25) == Approx(0.2));
  CHECK(red_at(textured(), 0.0) == Approx(0.4));
  CHECK(red_at(textured(Wrap::Mirror), 1.25) == Approx(0.6));
  CHECK(red_at(textured(Wrap::Mirror), 0.0) == Approx(0.2));
  CHECK(red_at(textured(Wrap::Clamp), -3.0) == Approx(0.2));
  CHECK(red_at(textured(Wrap::Clamp), 7.0) == Approx(0.6));
}

TEST_CASE("tracer optics: a metal mirrors its base colour, and the dielectric share as it is") {
  Material material = textured();
  material.metallic = 0.5f;
  const Optics plain{.role = Role::Mirror, .ior = 1.5};
  CHECK(dressed(with_two_texels(), material, plain, {0.25, 0.5}).color.x == Approx(0.04 * 0.5 + 0.2 * 0.5));
}

TEST_CASE("tracer optics: a transmission texture's red is the share that passes") {
  Material material = textured();
  material.transmission_texture = material.base_color_texture;
  CHECK(red_at(material, 0.25) == Approx(0.2 * 0.2));
}

TEST_CASE("tracer optics: the nearest texel's opacity tells whether there is a hole") {
  Material material = textured();
  const Scene scene = with_two_texels();
  CHECK_FALSE(is_cut_out(scene, material, {0.7, 0.5}));
  material.alpha_mode = AlphaMode::Mask;
  CHECK(is_cut_out(scene, material, {0.55, 0.5}));
  CHECK_FALSE(is_cut_out(scene, material, {0.45, 0.5}));
  // A blended surface has a hole where it is not opaque.
  material.alpha_mode = AlphaMode::Blend;
  CHECK(is_cut_out(scene, material, {0.55, 0.5}));
  CHECK_FALSE(is_cut_out(scene, material, {0.45, 0.5}));
  material.base_color.a = 0.9f;
  CHECK(is_cut_out(scene, material, {0.45, 0.5}));
}

TEST_CASE("tracer optics: a normal texture leans the normal along the tangent, by its scale") {
  Scene scene;
  Image image(Format::RGBA32F, 1, 1);
  image.values = {0.8f, 0.5f, 0.9f, 1.0f};
  scene.images = {image};
  Material material;
  material.normal_texture.image = 0;
  const glm::dvec3 n(0.0, 1.0, 0.0);
  const glm::dvec3 leans = leaned(scene, material, n, {0.0, 0.0, 1.0, 1.0}, {0.5, 0.5});
  CHECK(leans.z == Approx(0.6).epsilon(1e-5));
  CHECK(leans.y == Approx(0.8).epsilon(1e-5));
  material.normal_scale = 0.0f;
  CHECK(leaned(scene, material, n, {0.0, 0.0, 1.0, 1.0}, {0.5, 0.5}).y == Approx(1.0));
}
