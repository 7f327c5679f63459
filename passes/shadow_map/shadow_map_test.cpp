#include "passes/shadow_map/shadow_map.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// From 10 m above, a window of 2 m in 4 x 4 texels.
Image depths(const MeshData& mesh, const View& view = down(1.0, 10.0, 20.0), const Material& material = {},
             const Image& base_color = {}) {
  LightViews views;
  views.shadow = view;
  const Pass pass = shadow_map_pass();
  return run_pass(definition_of(pass), {.width = 4,
                                        .height = 4,
                                        .uniforms = pass.uniforms({.views = &views, .material = &material}),
                                        .textures = {base_color},
                                        .mesh = mesh})["shadow_depth"];
}

}  // namespace

TEST_CASE("shadow_map: a texel holds metres along the light") {
  // The light starts at height 10: height 2.5 is 7.5 m away.
  const Image map = depths(level(2.5f));
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) CHECK(map.at(x, y, 0) == Approx(7.5));
}

TEST_CASE("shadow_map: the nearest surface wins in either order of drawing") {
  CHECK(depths(both(level(2.0f), level(5.0f))).at(1, 1, 0) == Approx(5.0));
  CHECK(depths(both(level(5.0f), level(2.0f))).at(1, 1, 0) == Approx(5.0));
}

TEST_CASE("shadow_map: where the light meets nothing stands 1e30") {
  // A square over x > 0 only: columns 0 and 1, centres at -0.75 and -0.25, stay empty.
  const Image map = depths(level(2.0f, 4.0f, 4.0f));
  CHECK(map.at(0, 2, 0) == 1e30f);
  CHECK(map.at(1, 2, 0) == 1e30f);
  CHECK(map.at(2, 2, 0) == Approx(8.0));
}

TEST_CASE("shadow_map: a face that is turned away from the light shadows too") {
  MeshData flipped = level(2.0f);
  std::swap(flipped.indices[1], flipped.indices[2]);
  std::swap(flipped.indices[4], flipped.indices[5]);
  CHECK(depths(flipped).at(0, 0, 0) == Approx(8.0));
  CHECK(depths(flipped).at(3, 3, 0) == Approx(8.0));
}

TEST_CASE("shadow_map: a point light's depth is along its axis, not along the ray") {
  // A window of tangent 1: the corner texel's centre lies at tangents (0.75, 0.75), 8 m along the axis.
  View view = down(1.0, 10.0, 20.0);
  view.perspective = true;
  view.near = 0.1;
  CHECK(depths(level(2.0f, 20.0f), view).at(3, 3, 0) == Approx(8.0));
}

TEST_CASE("shadow_map: an alpha mask cuts holes, and an opaque material ignores alpha") {
  // The texture's left half is transparent; the square spans 8 m, the window its middle 2 m.
  Image base_color(Format::RGBA16F, 2, 1);
  base_color.at(1, 0, 3) = 1.0f;
  Material material;
  material.base_color_texture.image = 0;
  material.alpha_mode = AlphaMode::Mask;
  const View view = down(1.0, 10.0, 20.0);
  CHECK(depths(level(2.0f), view, material, base_color).at(1, 2, 0) == 1e30f);
  CHECK(depths(level(2.0f), view, material, base_color).at(2, 2, 0) == Approx(8.0));
  material.base_color_texture.uv_transform[2][0] = 0.5f;  // the texture's halves change places
  CHECK(depths(level(2.0f), view, material, base_color).at(1, 2, 0) == Approx(8.0));
  CHECK(depths(level(2.0f), view, material, base_color).at(2, 2, 0) == 1e30f);
  material.base_color_texture.wrap_u = Wrap::Clamp;  // the right half goes on
  CHECK(depths(level(2.0f), view, material, base_color).at(2, 2, 0) == Approx(8.0));
  material.base_color_texture.wrap_u = Wrap::Repeat;
  material.base_color_texture.uv_transform[2][0] = 0.0f;
  base_color.at(0, 0, 3) = material.alpha_cutoff;  // as opaque as the cutoff stays
  CHECK(depths(level(2.0f), view, material, base_color).at(1, 2, 0) == Approx(8.0));
  base_color.at(0, 0, 3) = 0.0f;
  material.alpha_mode = AlphaMode::Opaque;
  CHECK(depths(level(2.0f), view, material, base_color).at(1, 2, 0) == Approx(8.0));
}
