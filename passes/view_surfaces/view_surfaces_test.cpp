#include "passes/view_surfaces/view_surfaces.hpp"

#include <cmath>
#include <utility>

#include "pipeline/scene/mip_levels.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// Seen from above, the first order winds counter-clockwise: the front. Both squares are level.
const glm::vec3 kFront[4] = {{-2, 2, 2}, {2, 2, 2}, {2, 2, -2}, {-2, 2, -2}};
const glm::vec3 kBack[4] = {{-2, 2, -2}, {2, 2, -2}, {2, 2, 2}, {-2, 2, 2}};
const float kHalf = std::sqrt(0.5f);

Material plain() {
  Material material;
  material.base_color = {0.8f, 0.6f, 0.4f, 1.0f};
  material.double_sided = true;
  return material;
}

// A camera 10 m up that looks down on +-half metres, 8 x 8 pixels.
PassImages see(const MeshData& mesh, const Material& material, const std::vector<Image>& textures = {},
               double half = 2.0, bool highlights = false, const Mesh* of = nullptr) {
  Effects effects;
  effects.smooth_shading.active = true;
  effects.highlights.active = highlights;
  const View view = down(half, 10.0, 20.0);
  const Pass pass = view_surfaces_pass();
  std::vector<Image> bound = textures;
  bound.resize(10);
  return run_pass(definition_of(pass), {.width = 8,
                                        .height = 8,
                                        .uniforms = pass.uniforms({.effects = &effects,
                                                                   .camera = &view,
                                                                   .mesh = of,
                                                                   .material = &material,
                                                                   .width = 8,
                                                                   .height = 8}),
                                        .textures = bound,
                                        .mesh = mesh});
}

void check_direction(const glm::vec4& found, const glm::vec3& expected) {
  CHECK(found.x == Approx(expected.x).margin(1e-6));
  CHECK(found.y == Approx(expected.y).margin(1e-6));
  CHECK(found.z == Approx(expected.z).margin(1e-6));
}

}  // namespace

TEST_CASE("view_surfaces: a pixel holds the surface's position and depth") {
  const PassImages out = see(quad(kFront, {0.0f, 1.0f, 0.0f}), plain());
  // Pixels of 0.5 m: the centre of (6, 1) is x = -2 + 3.25 and, with up = -z, z = 2 - 0.75.
  const glm::vec4 position = texel(out["view_position"], 6, 1);
  CHECK(position.x == Approx(1.25));
  CHECK(position.y == Approx(2.0));
  CHECK(position.z == Approx(1.25));
  CHECK(position.w == 1.0f);
  CHECK(texel(out["view_normal"], 6, 1).w == Approx(8.0));
}

TEST_CASE("view_surfaces: the nearer surface is seen, and beside all of them w is 0") {
  // A square at height 2 over x < 0 hides the one at height 1 below it.
  const MeshData upper = quad({{-2, 2, 2}, {0, 2, 2}, {0, 2, -2}, {-2, 2, -2}}, {0.0f, 1.0f, 0.0f});
  const MeshData lower = quad({{-2, 1, 2}, {1, 1, 2}, {1, 1, -2}, {-2, 1, -2}}, {0.0f, 1.0f, 0.0f});
  const PassImages out = see(both(upper, lower), plain());
  CHECK(out["view_normal"].at(3, 4, 3) == Approx(8.0));
  CHECK(out["view_normal"].at(4, 4, 3) == Approx(9.0));
  CHECK(texel(out["view_position"], 6, 4) == glm::vec4(0.0f));
}

TEST_CASE("view_surfaces: a back face shows its normal turned to the viewer") {
  check_direction(texel(see(quad(kFront, {0, 1, 0}), plain())["view_normal"], 2, 2), {0, 1, 0});
  check_direction(texel(see(quad(kBack, {0, -1, 0}), plain())["view_normal"], 2, 2), {0, 1, 0});
}

TEST_CASE("view_surfaces: the back of a surface is seen only where its material is double-sided") {
  Material material = plain();
  CHECK(texel(see(quad(kBack, {0, -1, 0}), material)["view_position"], 2, 2).w == 1.0f);
  material.double_sided = false;
  CHECK(texel(see(quad(kBack, {0, -1, 0}), material)["view_position"], 2, 2).w == 0.0f);
  CHECK(texel(see(quad(kFront, {0, 1, 0}), material)["view_position"], 2, 2).w == 1.0f);
}

TEST_CASE("view_surfaces: the lift reaches from a triangle out to its vertices' tangent planes") {
  // A triangle within the unit sphere, with the sphere's normals, seen from above. The centre of pixel (4, 3)
  // shows p = (1/4, 1/2, 1/4); the tangent planes, x = 1 and so on, weighted like the vertices, lie
  // 1 - p . p = 5/8 away along the normal p / |p|.
  const glm::vec3 corners[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  MeshData mesh = quad(kFront, {0.0f, 1.0f, 0.0f});
  const auto stride = static_cast<std::size_t>(mesh.floats_per_vertex());
  for (std::size_t i = 0; i < 3; ++i)
    for (int c = 0; c < 3; ++c) {
      mesh.vertices[i * stride + static_cast<std::size_t>(c)] = corners[i][c];
      mesh.vertices[i * stride + 3 + static_cast<std::size_t>(c)] = corners[i][c];
    }
  mesh.indices = {0, 1, 2};
  const glm::vec3 normal = glm::vec3(1, 2, 1) / std::sqrt(6.0f);
  check_direction(texel(see(mesh, plain())["view_lift"], 4, 3), 0.625f * normal);
  // From within it is hollow; and a flat square has none.
  mesh.indices = {0, 2, 1};
  check_direction(texel(see(mesh, plain())["view_lift"], 4, 3), {0, 0, 0});
  check_direction(texel(see(quad(kFront, {0, 1, 0}), plain())["view_lift"], 2, 2), {0, 0, 0});
}

TEST_CASE("view_surfaces: normals come out with length 1") {
  check_direction(texel(see(quad(kFront, {3, 3, 0}), plain())["view_normal"], 2, 2), {kHalf, kHalf, 0});
}

TEST_CASE("view_surfaces: albedo is the factor times the texture, emission likewise") {
  Material material = plain();
  material.emissive = {100.0f, 200.0f, 0.0f};
  const MeshData mesh = quad(kFront, {0.0f, 1.0f, 0.0f});
  CHECK(texel(see(mesh, material)["view_albedo"], 2, 2) == glm::vec4(0.8f, 0.6f, 0.4f, 1.0f));
  CHECK(texel(see(mesh, material)["view_emission"], 2, 2) == glm::vec4(100.0f, 200.0f, 0.0f, 1.0f));
  material.base_color_texture.image = 0;
  material.emissive_texture.image = 1;
  const PassImages out =
      see(mesh, material,
          {filled(1, 1, {0.5f, 0.25f, 1.0f, 1.0f}), Image{}, filled(1, 1, {0.5f, 0.125f, 1.0f, 1.0f})});
  CHECK(out["view_albedo"].at(2, 2, 0) == Approx(0.4));
  CHECK(out["view_albedo"].at(2, 2, 1) == Approx(0.15));
  CHECK(out["view_albedo"].at(2, 2, 2) == Approx(0.4));
  CHECK(out["view_emission"].at(2, 2, 0) == Approx(50.0));
  CHECK(out["view_emission"].at(2, 2, 1) == Approx(25.0));
}

TEST_CASE("view_surfaces: textures repeat, and their texels are interpolated across the seam") {
  // Texels 0 and 1, twice across the 4 m square: u = 2 (i + 0.5) / 8, so pixel centres lie a quarter of a
  // texel from a texel's centre, on either side of it in turn. Each gets a quarter of its other neighbour.
  Image stripes(Format::RGBA16F, 2, 1);
  for (int c = 0; c < 4; ++c) stripes.at(1, 0, c) = 1.0f;
  Material material = plain();
  material.base_color = glm::vec4(1.0f);
  material.base_color_texture.image = 0;
  material.base_color_texture.uv_transform[0][0] = 2.0f;
  const Image albedo = see(quad(kFront, {0.0f, 1.0f, 0.0f}), material, {stripes})["view_albedo"];
  const float expected[8] = {0.25f, 0.25f, 0.75f, 0.75f, 0.25f, 0.25f, 0.75f, 0.75f};
  for (int x = 0; x < 8; ++x) CHECK(albedo.at(x, 3, 0) == Approx(expected[x]));
}

TEST_CASE("view_surfaces: colours of the vertices, between them interpolated, multiply the base colour") {
  // Red falls from 1 at the left edge to 0 at the right one: 1/16 less 1/8 a pixel in the middles of eight.
  MeshData mesh = quad(kFront, {0.0f, 1.0f, 0.0f});
  for (std::size_t i = 0; i < 4; ++i) {
    const float color[4] = {mesh.vertices[14 * i] < 0.0f ? 1.0f : 0.0f, 0.5f, 0.25f, 1.0f};
    std::copy(std::begin(color), std::end(color),
              mesh.vertices.begin() + static_cast<std::ptrdiff_t>(14 * i + 6));
  }
  Mesh colored;
  colored.colors.resize(1);
  const Image albedo = see(mesh, plain(), {}, 2.0, false, &colored)["view_albedo"];
  for (int x = 0; x < 8; ++x) {
    CHECK(albedo.at(x, 3, 0) == Approx(0.8 * (1.0 - (x + 0.5) / 8.0)).margin(1e-6));
    CHECK(albedo.at(x, 3, 1) == Approx(0.6 * 0.5));
    CHECK(albedo.at(x, 3, 2) == Approx(0.4 * 0.25));
  }
  CHECK(see(mesh, plain())["view_albedo"].at(0, 3, 0) == Approx(0.8));
}

TEST_CASE(
    "view_surfaces: beyond the picture a clamped texture keeps its border and a mirrored one turns back") {
  // Texels 0 and 1, their middles at 0.25 and 0.75; pixel i looks at 0.25 i - 0.375.
  const auto seen_along = [](Wrap wrap, bool upwards, bool nearest = false) {
    Image texels(Format::RGBA16F, upwards ? 1 : 2, upwards ? 2 : 1);
    for (int c = 0; c < 4; ++c) texels.at(upwards ? 0 : 1, upwards ? 1 : 0, c) = 1.0f;
    const int axis = upwards ? 1 : 0;
    Material material = plain();
    material.base_color = glm::vec4(1.0f);
    TextureUse& use = material.base_color_texture;
    use.image = 0;
    use.uv_transform[axis][axis] = 2.0f;
    use.uv_transform[2][axis] = -0.5f;
    (upwards ? use.wrap_v : use.wrap_u) = wrap;
    use.nearest = nearest;
    const Image albedo = see(quad(kFront, {0.0f, 1.0f, 0.0f}), material, {texels})["view_albedo"];
    std::vector<float> values;
    for (int i = 0; i < 8; ++i) values.push_back(albedo.at(upwards ? 3 : i, upwards ? i : 3, 0));
    return values;
  };
  using Values = std::vector<float>;
  for (const bool upwards : {false, true}) {
    CHECK(seen_along(Wrap::Repeat, upwards) ==
          Values{0.75f, 0.75f, 0.25f, 0.25f, 0.75f, 0.75f, 0.25f, 0.25f});
    CHECK(seen_along(Wrap::Clamp, upwards) == Values{0.0f, 0.0f, 0.0f, 0.25f, 0.75f, 1.0f, 1.0f, 1.0f});
    CHECK(seen_along(Wrap::Mirror, upwards) == Values{0.25f, 0.0f, 0.0f, 0.25f, 0.75f, 1.0f, 1.0f, 0.75f});
    CHECK(seen_along(Wrap::Repeat, upwards, true) == Values{1.0f, 1.0f, 0.0f, 0.0f, 1.0f, 1.0f, 0.0f, 0.0f});
  }
}

TEST_CASE("view_surfaces: a normal texture leans the normal in tangent space") {
  // The square's tangent is +x, its normal +y, so the bitangent n x t is -z. Red 1 and blue 1 stand for
  // (1, 0, 1): halfway between tangent and normal. Green likewise along the bitangent.
  Material material = plain();
  material.normal_texture.image = 0;
  MeshData mesh = quad(kFront, {0.0f, 1.0f, 0.0f});
  const auto with = [&](const glm::vec4& value) {
    return texel(see(mesh, material, {Image{}, filled(1, 1, value)})["view_normal"], 2, 2);
  };
  check_direction(with({0.5f, 0.5f, 1.0f, 1.0f}), {0, 1, 0});
  check_direction(with({1.0f, 0.5f, 1.0f, 1.0f}), {kHalf, kHalf, 0});
  check_direction(with({0.5f, 1.0f, 1.0f, 1.0f}), {0, kHalf, -kHalf});
  // Scaled by a half: (0.5, 0, 1) / sqrt(1.25).
  material.normal_scale = 0.5f;
  check_direction(with({1.0f, 0.5f, 1.0f, 1.0f}), {0.5f / std::sqrt(1.25f), 1.0f / std::sqrt(1.25f), 0});
  // A mirrored picture's bitangent is the other way about.
  material.normal_scale = 1.0f;
  for (std::size_t i = 0; i < 4; ++i) mesh.vertices[14 * i + 9] = -1.0f;
  check_direction(with({0.5f, 1.0f, 1.0f, 1.0f}), {0, kHalf, kHalf});
}

TEST_CASE("view_surfaces: on a back face the textured normal as a whole is reversed") {
  // glTF 2.0, 3.9.5: back faces have their normals reversed. The front's would be (1, -1, 0) / sqrt(2).
  Material material = plain();
  material.normal_texture.image = 0;
  check_direction(texel(see(quad(kBack, {0, -1, 0}), material,
                            {Image{}, filled(1, 1, {1.0f, 0.5f, 1.0f, 1.0f})})["view_normal"],
                        2, 2),
                  {-kHalf, kHalf, 0});
}

TEST_CASE("view_surfaces: an alpha mask cuts holes where the interpolated alpha is below the cutoff") {
  // Left half transparent. The window shows the square's middle 2 m, u from 0.25 to 0.75, where alpha rises
  // from 0 to 1: 0.4375 at pixel 3, 0.5625 at pixel 4; the cutoff is 0.5.
  Image base_color(Format::RGBA16F, 2, 1);
  base_color.at(1, 0, 3) = 1.0f;
  Material material = plain();
  material.alpha_mode = AlphaMode::Mask;
  material.base_color_texture.image = 0;
  const MeshData mesh = quad(kFront, {0.0f, 1.0f, 0.0f});
  const PassImages out = see(mesh, material, {base_color}, 1.0);
  CHECK(out["view_position"].at(3, 2, 3) == 0.0f);
  CHECK(out["view_position"].at(4, 2, 3) == 1.0f);
  material.alpha_mode = AlphaMode::Opaque;
  CHECK(see(mesh, material, {base_color}, 1.0)["view_position"].at(0, 2, 3) == 1.0f);
  material.alpha_mode = AlphaMode::Mask;  // as opaque as the cutoff stays
  base_color = filled(1, 1, glm::vec4(material.alpha_cutoff));
  CHECK(see(mesh, material, {base_color}, 1.0)["view_position"].at(0, 2, 3) == 1.0f);
}

TEST_CASE("view_surfaces: a fade shows all of the surface near its middle, none beyond its end") {
  Material material = plain();
  // From the middle of pixel (0, 4), at x = -1.75, z = -0.25: the pixels of its row are 0.5 m apart.
  material.fade = {{-1.75f, 2.0f, -0.25f}, 1.0f, 3.0f};
  const PassImages out = see(quad(kFront, {0.0f, 1.0f, 0.0f}), material);
  const auto shown = [&](int x) { return texel(out["view_albedo"], x, 4).w; };
  CHECK(shown(0) == 1.0f);
  CHECK(shown(2) == 1.0f);
  CHECK(shown(4) == Approx(0.5));
  // A quarter of the way is left: 3 / 16 - 2 / 64.
  CHECK(shown(5) == Approx(0.15625));
  CHECK(shown(7) == 0.0f);
  CHECK(texel(see(quad(kFront, {0.0f, 1.0f, 0.0f}), plain())["view_albedo"], 7, 4).w == 1.0f);
}

TEST_CASE("view_surfaces: what is not metal mirrors 0.04 at index 1.5, metal its colour instead of albedo") {
  Material material = plain();
  material.base_color = {0.8f, 0.4f, 0.2f, 1.0f};
  material.roughness = 0.25f;
  const auto seen = [&](const char* name, bool highlights = true) {
    return texel(see(quad(kFront, {0.0f, 1.0f, 0.0f}), material, {}, 2.0, highlights)[name], 2, 2);
  };
  material.metallic = 0.0f;
  CHECK(seen("view_specular").x == Approx(0.04));
  CHECK(seen("view_specular").w == 0.25f);
  material.metallic = 1.0f;
  CHECK(seen("view_specular").y == Approx(0.4));
  CHECK(seen("view_albedo").y == 0.0f);
  material.metallic = 0.5f;
  CHECK(seen("view_specular").y == Approx(0.22));
  // Half of 0.4; less what the coat of reflectance 0.04 mirrors, seen straight on, 0.043650.
  CHECK(seen("view_albedo").y == Approx(0.2 * 0.956350).epsilon(1e-5));
  // Nothing shows what it mirrors: it is drawn as diffuse.
  CHECK(seen("view_albedo", false).y == 0.4f);
}

TEST_CASE("view_surfaces: roughness is green, metal is blue, texel by texel, times their factors") {
  // Left texel: roughness 1, no metal. Right: a half each. The means are not asked.
  Image texels(Format::RGBA16F, 2, 1);
  texels.at(0, 0, 1) = 1.0f;
  texels.at(1, 0, 1) = texels.at(1, 0, 2) = 0.5f;
  Material material = plain();
  material.base_color = {0.8f, 0.4f, 0.2f, 1.0f};
  material.metallic = material.roughness = 0.9f;
  material.metallic_factor = 0.5f;
  material.roughness_factor = 0.75f;
  material.metallic_roughness_texture.image = 3;
  // Seen within a quarter of a texel around each texel's middle, at u = 0.25 and 0.75.
  const auto seen = [&](const char* name, int x, bool highlights = true) {
    const MeshData mesh = quad({{-4, 2, 4}, {4, 2, 4}, {4, 2, -4}, {-4, 2, -4}}, {0.0f, 1.0f, 0.0f});
    return texel(
        see(mesh, material, {Image{}, Image{}, Image{}, texels, Image{}}, 2.285714285, highlights)[name], x,
        4);
  };
  CHECK(seen("view_specular", 0).w == Approx(0.75));
  CHECK(seen("view_specular", 0).x == Approx(0.04));
  // The coat mirrors 0.0242 at roughness 0.75, 0.04187 at 0.375.
  CHECK(seen("view_albedo", 0).x == Approx(0.8 * 0.9758).epsilon(1e-3));
  // A quarter of metal: 0.25 x 0.4 + 0.75 x 0.04.
  CHECK(seen("view_specular", 7).w == Approx(0.375));
  CHECK(seen("view_specular", 7).y == Approx(0.13));
  CHECK(seen("view_albedo", 7).y == Approx(0.3 * 0.95813).epsilon(1e-3));
  // Nothing shows what it mirrors: it is drawn as diffuse.
  CHECK(seen("view_albedo", 7, false).y == 0.4f);
}

TEST_CASE("view_surfaces: of the environment's light arrives what the occlusion texture's red leaves") {
  Material material = plain();
  const auto share = [&] {
    return see(quad(kFront, {0.0f, 1.0f, 0.0f}), material,
               {Image{}, Image{}, Image{}, Image{}, filled(1, 1, {0.25f, 1.0f, 1.0f, 1.0f})})["view_ambient"]
        .at(2, 2, 0);
  };
  CHECK(share() == 1.0f);
  material.occlusion_texture.image = 4;
  CHECK(share() == 0.25f);
  // glTF 2.0, 3.9.2: 1 + strength (texel - 1).
  material.occlusion_strength = 0.5f;
  CHECK(share() == 0.625f);
  material.unlit = true;
  CHECK(share() == 1.0f);
}

TEST_CASE("view_surfaces: opaque parts of a blended surface are seen with all else that is opaque") {
  Material material = plain();
  material.alpha_mode = AlphaMode::Blend;
  CHECK(see(quad(kFront, {0.0f, 1.0f, 0.0f}), material)["view_position"].at(2, 2, 3) == 1.0f);
  material.base_color.a = 0.99f;
  CHECK(see(quad(kFront, {0.0f, 1.0f, 0.0f}), material)["view_position"].at(2, 2, 3) == 0.0f);
}

namespace {

// Columns of 0 and 1 in turn, 4 x 4 texels: every coarser level is 0.5 all over. Drawn `scale` times over the
// square's 4 m, as albedo.
glm::vec4 stripes_seen(float scale, const MeshData& mesh, const View& view, bool mip_map = true) {
  Image stripes(Format::RGBA16F, 4, 4);
  for (int y = 0; y < 4; ++y)
    for (int x = 1; x < 4; x += 2)
      for (int c = 0; c < 4; ++c) stripes.at(x, y, c) = 1.0f;
  Material material = plain();
  material.base_color = glm::vec4(1.0f);
  material.base_color_texture.image = 0;
  material.base_color_texture.levels = mip_map ? 3 : 1;
  material.base_color_texture.uv_transform[0][0] = material.base_color_texture.uv_transform[1][1] = scale;
  std::vector<Image> bound(10);
  bound[0] = stripes;
  if (mip_map) bound[5] = coarser_levels(stripes);
  const Effects effects;
  const Pass pass = view_surfaces_pass();
  return texel(
      run_pass(definition_of(pass),
               {.width = 8,
                .height = 8,
                .uniforms = pass.uniforms(
                    {.effects = &effects, .camera = &view, .material = &material, .width = 8, .height = 8}),
                .textures = bound,
                .mesh = mesh})["view_albedo"],
      2, 4);
}

const MeshData kSquare = quad(kFront, {0.0f, 1.0f, 0.0f});

}  // namespace

TEST_CASE("view_surfaces: a texture far away is its mean, a near one as if it had no mip map") {
  // Pixels of 0.5 m, their middle at x = -0.75: u = 0.3125 of the square.
  const View view = down(2.0, 10.0, 20.0);
  // 64 texels a pixel and more: the coarsest level.
  CHECK(stripes_seen(128.0f, kSquare, view).x == 0.5f);
  CHECK(stripes_seen(1e6f, kSquare, view).y == 0.5f);
  // A texel a pixel at most: at texel 0.75, three quarters of the way from 0 to 1.
  CHECK(stripes_seen(1.0f, kSquare, view).x == 0.75f);
  CHECK(stripes_seen(2.0f, kSquare, view) == stripes_seen(2.0f, kSquare, view, false));
}

TEST_CASE("view_surfaces: between two levels of a mip map they mix as the pixel's side lies between theirs") {
  // 1.5 texels a pixel: half of each level. The pixel's middle is at 3.25 texels from the first's: 0.75.
  const View view = down(2.0, 10.0, 20.0);
  CHECK(stripes_seen(3.0f, kSquare, view).x == Approx(0.5 * 0.75 + 0.5 * 0.5));
  // In perspective the side grows with the depth: 8 m down to the square.
  View far = down(0.25, 10.0, 20.0);
  far.perspective = true;
  far.near = 0.1;
  CHECK(stripes_seen(3.0f, kSquare, far).x == Approx(0.625));
}

TEST_CASE("view_surfaces: a pixel sees more of a texture where the surface leans away") {
  // By 60 degrees twice as much: 1.5 texels instead of 0.75, whose mix at texel 1.375 is 0.625.
  const float s = std::sqrt(3.0f);
  const MeshData leaning =
      quad({{-2, 2 - s, 1}, {2, 2 - s, 1}, {2, 2 + s, -1}, {-2, 2 + s, -1}}, {0.0f, 0.5f, 0.5f * s});
  const View view = down(2.0, 10.0, 20.0);
  CHECK(stripes_seen(1.5f, kSquare, view).x == Approx(0.625));
  CHECK(stripes_seen(1.5f, leaning, view).x == Approx(0.5 * 0.625 + 0.5 * 0.5));
}

TEST_CASE("view_surfaces: an oblong texture's coarser levels are found along its longer side") {
  // Along the longer side texels 0, 1, 2, ... 7: level 2 has their halves' means, 1.5 and 5.5, level 3 that
  // of all, 3.5. Four and eight texels a pixel; the pixel (2, 4) looks at a quarter of the picture across,
  // and up.
  for (const bool is_wide : {true, false}) {
    Image ramp(Format::RGBA16F, is_wide ? 8 : 2, is_wide ? 2 : 8);
    for (int y = 0; y < ramp.height(); ++y)
      for (int x = 0; x < ramp.width(); ++x)
        for (int c = 0; c < 4; ++c) ramp.at(x, y, c) = static_cast<float>(is_wide ? x : y);
    std::vector<Image> bound(10);
    bound[0] = ramp;
    bound[5] = coarser_levels(ramp);
    Material material = plain();
    material.base_color = glm::vec4(1.0f);
    TextureUse& use = material.base_color_texture;
    use.image = 0;
    use.levels = mip_level_count(ramp.width(), ramp.height());
    const auto seen = [&](float scale) {
      use.uv_transform[0][0] = use.uv_transform[1][1] = scale;
      return see(kSquare, material, bound)["view_albedo"].at(2, 4, 0);
    };
    INFO((is_wide ? "wide" : "high"));
    CHECK(seen(4.0f) == 1.5f);
    CHECK(seen(8.0f) == 3.5f);
    CHECK(seen(1000.0f) == 3.5f);
  }
}

TEST_CASE("view_surfaces: a clamped texture's coarser levels keep their borders too") {
  // Columns 0, 0, 1, 1, of which the next level has 0, 1. Two texels a pixel: that level, at 0.125 of it,
  // where it repeats a quarter of the way from the border to the other one.
  Image halves(Format::RGBA16F, 4, 4);
  for (int y = 0; y < 4; ++y)
    for (int x = 2; x < 4; ++x)
      for (int c = 0; c < 4; ++c) halves.at(x, y, c) = 1.0f;
  std::vector<Image> bound(10);
  bound[0] = halves;
  bound[5] = coarser_levels(halves);
  Material material = plain();
  material.base_color = glm::vec4(1.0f);
  TextureUse& use = material.base_color_texture;
  use.image = 0;
  use.levels = 3;
  use.uv_transform[0][0] = use.uv_transform[1][1] = 4.0f;
  use.uv_transform[2][0] = 0.125f - 4.0f * 2.5f / 8.0f;
  const auto seen = [&](Wrap wrap) {
    use.wrap_u = wrap;
    return see(kSquare, material, bound)["view_albedo"].at(2, 4, 0);
  };
  CHECK(seen(Wrap::Repeat) == 0.25f);
  CHECK(seen(Wrap::Clamp) == 0.0f);
  CHECK(seen(Wrap::Mirror) == 0.0f);
}

TEST_CASE("view_surfaces: a mask's holes are those of the finest level") {
  // 64 texels a pixel: on the mean no pixel would be a hole.
  Image holes(Format::RGBA16F, 64, 1);
  for (int x = 0; x < 64; x += 2)
    for (int c = 0; c < 4; ++c) holes.at(x, 0, c) = 1.0f;
  Material material = plain();
  material.alpha_mode = AlphaMode::Mask;
  material.alpha_cutoff = 0.25f;
  material.base_color_texture.image = 0;
  material.base_color_texture.levels = 7;
  material.base_color_texture.uv_transform[0][0] = 8.0f;
  // The pixels' middles are between two columns, at alpha 0.5; an eighth of a texel on they are at 0.125.
  std::vector<Image> bound(10);
  bound[0] = holes;
  bound[5] = coarser_levels(holes);
  const auto shown = [&](float texels) {
    material.base_color_texture.uv_transform[2][0] = texels / 64.0f;
    return see(kSquare, material, bound)["view_position"].at(2, 2, 3);
  };
  CHECK(shown(0.0f) == 1.0f);
  CHECK(shown(1.375f) == 0.0f);
}
