#include "passes/glass/glass.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "pipeline/settings/settings.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

const glm::vec4 kNothing{0.0f};

// A camera 10 m up looks down on +-4 m in 8 x 8 pixels: a floor at height 0, glass at height 5 in every
// pixel, the back of it at height 4 where it is solid.
struct Bench {
  View view = down(4.0, 10.0, 20.0);
  Scene scene;
  float ior = 1.5f;
  bool mirror = false;  // then `tint` is its colour
  bool solid = true;
  glm::vec3 absorption{0.0f}, tint{1.0f}, normal{0.0f, 1.0f, 0.0f}, exit_normal{0.0f, -1.0f, 0.0f};
  std::optional<glm::vec3> exit_normal_left;  // of the left half, if it is another
  std::optional<glm::vec3> pixel_tint;        // the pixels' own colour, in place of `tint`
  float facing = 1.0f, glass_height = 5.0f;
  Image scene_color = filled(8, 8, glm::vec4(1.0f));
  Image floor = level(view, 0.0, 1.0f);
  Image wide_color = filled(8, 8, kNothing), wide_floor = filled(8, 8, kNothing);

  // Positions of the plane at this height, seen through the pixels' centres.
  static Image level(const View& view, double height, float w) {
    Image image(Format::RGBA32F, 8, 8);
    const glm::dvec2 size = view.window_upper - view.window_lower;
    const double away = view.perspective ? view.origin.y - height : 1.0;
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x) {
        image.at(x, y, 0) = static_cast<float>((view.window_lower.x + size.x * (x + 0.5) / 8) * away);
        image.at(x, y, 1) = static_cast<float>(height);
        image.at(x, y, 2) = static_cast<float>(-(view.window_lower.y + size.y * (y + 0.5) / 8) * away);
        image.at(x, y, 3) = w;
      }
    return image;
  }

  Image exit_normals() const {
    Image image = filled(8, 8, {exit_normal, 1.0f});
    for (int y = 0; exit_normal_left && y < 8; ++y)
      for (int x = 0; x < 4; ++x)
        for (int c = 0; c < 3; ++c) image.at(x, y, c) = (*exit_normal_left)[c];
    return image;
  }

  Image highlight{};  // what the lights add
  float roughness = 0.0f;
  bool thin = false;  // a rough wall

  Image run() const {
    Image materials(Format::RGBA32F, 4, 2);
    for (int c = 0; c < 3; ++c) {
      materials.at(1, 1, c) = absorption[c];
      materials.at(2, 1, c) = tint[c];
    }
    materials.at(0, 1, 0) = ior;
    materials.at(3, 1, 0) = 1.0f;
    materials.at(0, 1, 3) = mirror ? 1.0f : thin ? -1.0f : 0.0f;
    materials.at(1, 1, 3) = solid ? 1.0f : 0.0f;
    materials.at(2, 1, 3) = roughness;
    const View wide = widened(view, 3.0);
    const Pass pass = glass_pass();
    // The box around all receivers, which no ray can miss that goes down.
    Scene all = scene;
    all.meshes.resize(1);
    all.meshes[0].vertices.resize(1);
    all.meshes[0].lower = {-1e4f, -1.0f, -1e4f};
    all.meshes[0].upper = {1e4f, 1.0f, 1e4f};
    Effects effects;
    effects.surfaces.resize(1);
    effects.textured_casters.active = pixel_tint.has_value();
    effects.rough_glass.active = roughness > 0.2f;
    const Settings settings;
    return run_pass(
        definition_of(pass),
        {.width = 8,
         .height = 8,
         .uniforms = pass.uniforms({.scene = &all,
                                    .settings = &settings,
                                    .effects = &effects,
                                    .camera = &view,
                                    .surroundings = &wide}),
         .textures = {scene_color, floor, wide_color, wide_floor, level(view, glass_height, facing),
                      filled(8, 8, {normal, 1.0f}), solid ? level(view, 4.0, 1.0f) : Image{},
                      solid ? exit_normals() : Image{}, materials, scene.environment.image.value_or(Image{}),
                      pixel_tint ? filled(8, 8, {*pixel_tint, 1.0f}) : Image{}, highlight}})["beauty"];
  }
};

// A different colour in each pixel.
Image pattern() {
  Image image(Format::RGBA32F, 8, 8);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      image.at(x, y, 0) = static_cast<float>(x);
      image.at(x, y, 1) = static_cast<float>(y);
      image.at(x, y, 2) = static_cast<float>((3 * x + 5 * y) % 7);
      image.at(x, y, 3) = 1.0f;
    }
  return image;
}

void check_same(const Image& found, const Image& expected) {
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x)
      for (int c = 0; c < 4; ++c)
        CHECK(found.at(x, y, c) == Approx(expected.at(x, y, c)).epsilon(1e-4).margin(1e-4));
}

}  // namespace

TEST_CASE("glass: a slab of index 1 shows exactly what is behind it") {
  Bench bench;
  bench.ior = 1.0f;
  bench.scene_color = pattern();
  check_same(bench.run(), bench.scene_color);
  bench.solid = false;
  check_same(bench.run(), bench.scene_color);
}

TEST_CASE("glass: a highlight is added in its pixel") {
  Bench bench;
  bench.ior = 1.0f;
  bench.highlight = pattern();
  Image expected = pattern();
  for (float& value : expected.values) value += 1.0f;
  bench.scene_color = filled(8, 8, glm::vec4(1.0f));
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) expected.at(x, y, 3) = 1.0f;
  check_same(bench.run(), expected);
}

TEST_CASE("glass: a slab of index 1 vanishes for a perspective camera too") {
  Bench bench;
  bench.view = down(0.5, 10.0, 20.0);
  bench.view.perspective = true;
  bench.view.near = 0.1;
  bench.floor = Bench::level(bench.view, 0.0, 1.0f);
  bench.ior = 1.0f;
  bench.scene_color = pattern();
  check_same(bench.run(), bench.scene_color);
}

TEST_CASE("glass: pixels without glass, or with glass behind a surface, stay bit for bit") {
  Bench none, hidden;
  none.scene_color = hidden.scene_color = pattern();
  none.facing = 0.0f;
  hidden.glass_height = -1.0f;
  CHECK(none.run().values == none.scene_color.values);
  CHECK(hidden.run().values == hidden.scene_color.values);
}

TEST_CASE("glass: straight through a solid, 1 - R of the first surface is left") {
  // R = (0.5 / 2.5)^2 = 0.04; what the second sends back inside leaves in the end.
  Bench bench;
  CHECK(bench.run().at(3, 3, 0) == Approx(0.96));
  // What the first surface mirrors comes from the sky's zenith: 0.04 * 10 more.
  bench.scene.environment.zenith = glm::vec3(10.0f);
  CHECK(bench.run().at(3, 3, 0) == Approx(1.36));
}

TEST_CASE("glass: straight through an open surface, 1 - R is left") {
  Bench bench;
  bench.solid = false;
  CHECK(bench.run().at(3, 3, 0) == Approx(0.96));
}

TEST_CASE("glass: the path inside absorbs, the base colour tints") {
  // 1 m from height 5 to 4: exp(-2) on red.
  Bench bench;
  bench.absorption = {2.0f, 0.0f, 0.0f};
  bench.tint = {1.0f, 0.5f, 0.0f};
  const glm::vec4 color = texel(bench.run(), 4, 2);
  CHECK(color.x == Approx(0.96 * std::exp(-2.0)).epsilon(1e-5));
  CHECK(color.y == Approx(0.48));
  CHECK(color.z == 0.0f);
  CHECK(color.w == 1.0f);
}

TEST_CASE("glass: a leaning surface shifts the view by Snell's law") {
  // Normal 45 degrees towards +x: the refracted ray leans by 45 - asin(sin 45 / 1.5) = 16.874 degrees towards
  // -x and lands 5 tan = 1.51669 m, as many pixels, further left. Red counts pixels, so 7 becomes 5.48331. R
  // at 45 degrees is 0.050240. What is mirrored flies level to the right, into a black sky.
  Bench bench;
  bench.solid = false;
  bench.normal = {std::sqrt(0.5f), std::sqrt(0.5f), 0.0f};
  bench.scene_color = pattern();
  CHECK(bench.run().at(7, 3, 0) == Approx((1.0 - 0.050240) * (7.0 - 1.51669)).epsilon(1e-4));
  CHECK(bench.run().at(3, 3, 0) == Approx((1.0 - 0.050240) * (3.0 - 1.51669)).epsilon(1e-4));
}

TEST_CASE("glass: what leaves the picture is found in the wide view, and beyond that is sky") {
  // As above from pixel 0, at x = -3.5: lands at -5.02, outside of -4 but inside the wide view's -12.
  Bench bench;
  bench.solid = false;
  bench.normal = {std::sqrt(0.5f), std::sqrt(0.5f), 0.0f};
  bench.wide_floor = Bench::level(widened(bench.view, 3.0), 0.0, 1.0f);
  bench.wide_color = filled(8, 8, {0.0f, 2.0f, 0.0f, 1.0f});
  const glm::vec4 found = texel(bench.run(), 0, 4);
  CHECK(found.x == Approx(0.0).margin(1e-6));
  CHECK(found.y == Approx(2.0 * (1.0 - 0.050240)).epsilon(1e-4));
  // Without it the ray looks down into the ground's radiance, the mirrored one level into the horizon's.
  bench.wide_floor = filled(8, 8, kNothing);
  bench.scene.environment.ground = glm::vec3(3.0f);
  const glm::vec4 sky = texel(bench.run(), 0, 4);
  CHECK(sky.x == Approx(3.0 * (1.0 - 0.050240)).epsilon(1e-4));
}

TEST_CASE(
    "glass: clear glass over nothing is as bright as the backdrop beside it, metal mirrors the ground") {
  Bench bench;
  bench.ior = 1.0f;
  bench.floor = filled(8, 8, kNothing);
  bench.scene.environment.ground = glm::vec3(1.0f);
  bench.scene.environment.backdrop = glm::vec3(3.0f);
  CHECK(bench.run().at(4, 4, 0) == Approx(3.0f));
  // Leans by 70 degrees: what it mirrors comes from 50 degrees below the horizon.
  bench.mirror = true;
  bench.normal = {0.9396926f, 0.3420201f, 0.0f};
  CHECK(bench.run().at(4, 4, 0) == Approx(1.0f));
}

TEST_CASE("glass: from inside at a flat angle all is mirrored") {
  // A back face leaning by 60 degrees, beyond the critical angle of 41.8. Mirrored, the view leaves 30
  // degrees below level, passes the floor's edge (5 m down take 8.66 m) and sees the ground; nothing is lost.
  Bench bench;
  bench.facing = -1.0f;
  bench.normal = {std::sqrt(0.75f), -0.5f, 0.0f};
  bench.scene.environment.ground = glm::vec3(8.0f);
  CHECK(bench.run().at(3, 3, 0) == Approx(8.0).epsilon(1e-5));
}

TEST_CASE("glass: what cannot leave by the second surface is mirrored there and goes straight on") {
  // An exit that leans by 45 degrees: the view turns level and sees the horizon; 1 - R of the first surface
  // is left.
  Bench bench;
  bench.exit_normal = {-std::sqrt(0.5f), -std::sqrt(0.5f), 0.0f};
  bench.scene.environment.horizon = glm::vec3(3.0f);
  CHECK(bench.run().at(3, 3, 0) == Approx(3.0 * 0.96).epsilon(1e-4));
}

TEST_CASE("glass: what touches the back of a solid is seen through it") {
  // A floor 0.1 m inside the glass, whose texels measure 1 m. 0.9408 as above; the sky is black.
  Bench bench;
  bench.floor = Bench::level(bench.view, 4.1, 1.0f);
  CHECK(bench.run().at(3, 3, 0) == Approx(0.96));
}

TEST_CASE("glass: beside a crease of the back the view leaves by its own side") {
  // As below a leaning surface the ray is 1 tan 16.874 = 0.303 m further left at the back: from pixel 4,
  // whose middle is at 0.5, it leaves right of the crease at 0, where the mean of normals would have three
  // tenths of the left one.
  Bench bench;
  bench.normal = {std::sqrt(0.5f), std::sqrt(0.5f), 0.0f};
  bench.scene_color = pattern();
  const glm::vec4 flat = texel(bench.run(), 4, 3);
  bench.exit_normal_left = glm::vec3(0.8f, -0.6f, 0.0f);
  CHECK(texel(bench.run(), 4, 3) == flat);
}

TEST_CASE("glass: from inside at a lower angle the view leaves by Snell's law") {
  // A back face leaning by 20 degrees towards +x: asin(1.5 sin 20) = 30.866 degrees outside, so the view
  // leans by 10.866 towards -x and lands 5 tan = 0.95967 m, as many pixels, further left. R from inside is
  // 0.041729.
  Bench bench;
  bench.facing = -1.0f;
  bench.normal = {std::sin(0.34906585f), -std::cos(0.34906585f), 0.0f};
  bench.scene_color = pattern();
  CHECK(bench.run().at(3, 3, 0) == Approx((1.0 - 0.041729) * (3.0 - 0.95967)).epsilon(1e-4));
}

TEST_CASE("glass: a pixel's own colour takes the place of its material's, in glass and in metal") {
  // 0.9408 of the radiance behind, as without a colour, times the colour.
  Bench bench;
  bench.tint = {0.1f, 0.1f, 0.1f};
  bench.pixel_tint = glm::vec3(1.0f, 0.5f, 0.0f);
  CHECK(bench.run().at(3, 3, 0) == Approx(0.96));
  CHECK(bench.run().at(3, 3, 1) == Approx(0.48));
  CHECK(bench.run().at(3, 3, 2) == 0.0f);
  bench.mirror = true;
  bench.solid = false;
  bench.scene.environment.zenith = glm::vec3(10.0f);
  CHECK(bench.run().at(3, 3, 1) == Approx(5.0));
}

TEST_CASE("glass: metal shows what it mirrors, in its own colour") {
  // Seen from above at normal incidence it mirrors the zenith.
  Bench bench;
  bench.mirror = true;
  bench.solid = false;
  bench.tint = {0.9f, 0.5f, 0.25f};
  bench.scene.environment.zenith = {10.0f, 10.0f, 10.0f};
  const Image image = bench.run();
  CHECK(image.at(4, 4, 0) == Approx(9.0));
  CHECK(image.at(4, 4, 1) == Approx(5.0));
  CHECK(image.at(4, 4, 2) == Approx(2.5));
}

TEST_CASE("glass: a rough slab shows the mean of what lies behind it") {
  // Black at the left, white at the right.
  Bench bench;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x)
      for (int c = 0; c < 3; ++c) bench.scene_color.at(x, y, c) = x < 4 ? 0.0f : 1.0f;
  const Image sharp = bench.run();
  bench.roughness = 0.5f;
  const Image blurred = bench.run();
  const auto step = [](const Image& image) { return image.at(4, 4, 0) - image.at(3, 4, 0); };
  CHECK(step(sharp) > 0.8f);
  CHECK(step(blurred) < 0.7f * step(sharp));
  CHECK(blurred.at(3, 4, 0) > sharp.at(3, 4, 0) + 0.05f);
}

TEST_CASE("glass: a rough wall tints the view and bends nothing, a closed body of them tints twice") {
  // All that lies below is 1. At 20 degrees each face mirrors r = 0.040266, both 2 r / (1 + r) = 0.077415, of
  // a black sky.
  Bench bench;
  bench.thin = true;
  bench.roughness = 0.25f;
  bench.solid = false;
  bench.tint = {1.0f, 0.5f, 1.0f};
  bench.normal = {std::sin(0.34906585f), std::cos(0.34906585f), 0.0f};
  CHECK(bench.run().at(3, 3, 0) == Approx(1.0 - 0.077415).epsilon(1e-4));
  CHECK(bench.run().at(3, 3, 1) == Approx(0.5 * (1.0 - 0.077415)).epsilon(1e-4));
  bench.solid = true;
  CHECK(bench.run().at(3, 3, 1) == Approx(0.25 * (1.0 - 0.077415)).epsilon(1e-4));
}
