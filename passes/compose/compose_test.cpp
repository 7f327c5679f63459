#include "passes/compose/compose.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "pipeline/scene/environment.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

constexpr float kPi = 3.14159265f;

// One colour for every pixel of a picture of diffuse surfaces.
struct Bench {
  Scene scene;
  View view = down(1.0, 10.0, 20.0);
  int width = 1, height = 1;
  float covered = 1.0f, shown = 1.0f;
  glm::vec3 normal{0.0f, 1.0f, 0.0f}, albedo{0.5f}, emission{0.0f};
  glm::vec3 direct{0.0f}, caustic{0.0f};
  glm::vec3 highlight{0.0f}, reflectance{0.0f};
  float roughness = 1.0f;
  bool lights = true, highlights = false, glass_before = false;
  std::optional<float> ambient, left;  // the shares of textures and of other surfaces

  Image image() const {
    const auto all = [&](const glm::vec3& rgb, float w) { return filled(width, height, {rgb, w}); };
    const Pass pass = compose_pass();
    Effects effects;
    effects.highlights.active = highlights;
    effects.seen_casters.active = glass_before;
    effects.occlusion.active = ambient.has_value();
    effects.ambient_occlusion.active = left.has_value();
    return run_pass(
        definition_of(pass),
        {.width = width,
         .height = height,
         .uniforms = pass.uniforms(
             {.scene = &scene, .effects = &effects, .camera = &view, .width = width, .height = height}),
         .textures = {all(glm::vec3(0.0f), covered), all(normal, 10.0f), all(albedo, shown),
                      all(emission, 1.0f), lights ? all(direct, 0.0f) : Image{},
                      lights ? all(caustic, 0.0f) : Image{}, scene.environment.image.value_or(Image{}),
                      all(highlight, 0.0f), all(reflectance, roughness),
                      all(glm::vec3(ambient.value_or(0.0f)), 1.0f), Image{}, Image{},
                      all(glm::vec3(0.0f), left ? 1.0f + *left : 0.0f)}})["scene_color"];
  }
  glm::vec3 color(int x = 0, int y = 0) const { return glm::vec3(texel(image(), x, y)); }
};

void check_color(const glm::vec3& found, const glm::vec3& expected) {
  for (int c = 0; c < 3; ++c) CHECK(found[c] == Approx(expected[c]).epsilon(1e-5).margin(1e-7));
}

// Looks along -z with up = +y, in perspective.
View level_view() {
  View view = view_along({0.0, 0.0, 0.0}, {0.0, 0.0, -1.0});
  view.perspective = true;
  view.near = 0.1;
  return view;
}

}  // namespace

TEST_CASE("compose: a diffuse surface sends albedo / pi of its irradiance, and its own light") {
  Bench bench;
  bench.albedo = {0.5f, 0.25f, 1.0f};
  bench.direct = {kPi, 2.0f * kPi, 0.0f};
  bench.caustic = {3.0f * kPi, 0.0f, kPi};
  bench.emission = {0.0f, 10.0f, 0.5f};
  // (1 + 3) * 0.5; 10 + 2 * 0.25; 0.5 + 1.
  check_color(bench.color(), {2.0f, 10.5f, 1.5f});
}

TEST_CASE("compose: other surfaces keep of the environment's light alone") {
  Bench bench;
  bench.scene.environment.zenith = bench.scene.environment.horizon = glm::vec3(4.0f);
  bench.direct = glm::vec3(2.0f * kPi);
  check_color(bench.color(), glm::vec3(3.0f));
  bench.left = 0.25f;
  check_color(bench.color(), glm::vec3(0.5f * (2.0f + 1.0f)));
  bench.left = 0.0f;
  check_color(bench.color(), glm::vec3(1.0f));
}

TEST_CASE("compose: a surface's highlight is added, for glass to show too") {
  Bench bench;
  bench.highlight = {1.0f, 2.0f, 3.0f};
  bench.scene.environment = {};
  check_color(bench.color(), glm::vec3(0.0f));
  bench.highlights = true;
  check_color(bench.color(), {1.0f, 2.0f, 3.0f});
  bench.glass_before = true;
  check_color(bench.color(), {1.0f, 2.0f, 3.0f});
}

TEST_CASE("compose: metal and coats mirror the environment, sharply as far as they are smooth") {
  // Seen straight down the level surface mirrors the zenith, 6; the mean is (3 + 2 * 6) / 3 = 5. Karis'
  // (2014) fit adds 1.04 a - 0.04 + 0.022 r: roughness 0, a = 2^-9.28 + 0.0425 = 0.044110, 0.99413 f0 +
  // 0.00587; roughness 0.5, a = 2^-9.28 / 2 + 0.02875 = 0.029555, (1 / (1 + 0.25 * 0.399) - 0.00174) f0 +
  // 0.00174. Roughness 1: the integral is (1 - ln 2) f0 = 0.3069 f0, the fit f0 / (1 + 2.264).
  Bench bench;
  bench.scene.environment.zenith = glm::vec3(6.0f);
  bench.scene.environment.horizon = glm::vec3(3.0f);
  bench.albedo = glm::vec3(0.0f);
  bench.highlights = true;
  bench.reflectance = {1.0f, 0.5f, 0.04f};
  bench.roughness = 0.0f;
  const auto check_mirrored = [&](float radiance, float scale, float bias) {
    const glm::vec3 color = bench.color();
    for (int c = 0; c < 3; ++c)
      CHECK(color[c] == Approx(radiance * (bench.reflectance[c] * scale + bias)).epsilon(1e-3));
  };
  check_mirrored(6.0f, 0.99413f, 0.00587f);
  bench.roughness = 1.0f;
  check_mirrored(5.0f, 0.30637f, 0.0f);
  bench.roughness = 0.5f;
  check_mirrored(5.5f, 0.90752f, 0.00174f);
  bench.highlights = false;
  CHECK(bench.color() == glm::vec3(0.0f));
}

TEST_CASE("compose: a picture without lights shows what shines by itself in every pixel") {
  Bench bench;
  bench.width = bench.height = 8;
  bench.lights = false;
  bench.emission = {1.0f, 2.0f, 3.0f};
  const Image image = bench.image();
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) CHECK(texel(image, x, y) == glm::vec4(1.0f, 2.0f, 3.0f, 1.0f));
}

TEST_CASE("compose: the gradient's ambient light depends on which way a surface faces") {
  // Facing up: a third of the horizon and two thirds of the zenith, (3 + 2 * 6) / 3 = 5. Down: the ground, 1.
  // Sideways: their mean, 3. The irradiance is pi times that, so the surface shows albedo times it.
  Bench bench;
  bench.scene.environment.zenith = glm::vec3(6.0f);
  bench.scene.environment.horizon = glm::vec3(3.0f);
  bench.scene.environment.ground = glm::vec3(1.0f);
  check_color(bench.color(), glm::vec3(2.5f));
  bench.normal = {0.0f, -1.0f, 0.0f};
  check_color(bench.color(), glm::vec3(0.5f));
  bench.normal = {1.0f, 0.0f, 0.0f};
  check_color(bench.color(), glm::vec3(1.5f));
}

TEST_CASE("compose: where nothing is covered the sky is seen along the pixel's ray") {
  Bench bench;
  bench.covered = 0.0f;
  bench.scene.environment.zenith = {0.0f, 0.0f, 4.0f};
  bench.scene.environment.horizon = {2.0f, 2.0f, 2.0f};
  bench.scene.environment.ground = {1.0f, 0.0f, 0.0f};
  check_color(bench.color(), {1.0f, 0.0f, 0.0f});  // straight down
  bench.view = level_view();
  check_color(bench.color(), {2.0f, 2.0f, 2.0f});  // level
  // Two pixels above one another look up and down by 0.5 in 1: sine 0.44721 of the way to the zenith, and
  // five times that, more than all the way, to the ground.
  bench.height = 2;
  check_color(bench.color(0, 0), {1.0f, 0.0f, 0.0f});
  const float up = 0.5f / std::sqrt(1.25f);
  check_color(bench.color(0, 1), {2.0f - 2.0f * up, 2.0f - 2.0f * up, 2.0f + 2.0f * up});
}

TEST_CASE("compose: soft boxes light surfaces, and are not seen directly") {
  Bench bench;
  bench.scene.environment.boxes_mean = 2.0f;
  bench.scene.environment.boxes[0] = {
      .middle = {0.0, 0.0, -1.0}, .upward = {0.0, 1.0, 0.0}, .radiance = 50.0f};
  bench.scene.environment.backdrop = glm::vec3(7.0f);
  check_color(bench.color(), glm::vec3(1.0f));
  bench.covered = 0.0f;
  bench.view = level_view();
  check_color(bench.color(), glm::vec3(0.0f));
  // Straight down the backdrop takes the ground's place.
  bench.view = down(1.0, 10.0, 20.0);
  check_color(bench.color(), glm::vec3(7.0f));
}

TEST_CASE("compose: an environment image is the sky, its middle straight ahead along -z") {
  // Four columns: 0 and 1 left of -z, 2 and 3 right. Straight ahead lies between columns 1 and 2.
  Bench bench;
  bench.covered = 0.0f;
  bench.view = level_view();
  Image image(Format::RGBA32F, 4, 1);
  for (int x = 0; x < 4; ++x) image.at(x, 0, 0) = static_cast<float>(x);
  bench.scene.environment.image = image;
  CHECK(bench.color().x == Approx(1.5));
  // A window from 0 to 2 has its middle at tangent 1, 45 degrees to the right: the centre of column 2.
  bench.view.window_lower = {0.0, -1.0};
  bench.view.window_upper = {2.0, 1.0};
  CHECK(bench.color().x == Approx(2.0).epsilon(1e-5));
}

TEST_CASE("compose: a turned environment is seen, and lights, where its picture is turned to") {
  // Red 1 straight ahead along -z, 2 to the right along +x, 3 behind, 4 to the left: in columns 1 (its middle
  // at -45 degrees) to 0 they would lie between, so eight columns have them at 4, 6, 0 and 2, shifted by
  // half.
  Image image(Format::RGBA32F, 256, 128);
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 256; ++x) image.at(x, y, 0) = static_cast<float>(((x + 32) / 64 + 2) % 4 + 1);
  Bench bench;
  bench.scene.environment.image = image;
  Bench turned = bench;
  adjust(bench.scene.environment, 1.0, 0.0);
  // Anticlockwise from above by 90 degrees: what lay to the right comes straight ahead.
  adjust(turned.scene.environment, 1.0, 90.0);
  for (const auto& [way, from] : {std::pair(glm::vec3(0, 0, -1), glm::vec3(1, 0, 0)),
                                  {{1, 0, 0}, {0, 0, 1}},
                                  {{0, 0, 1}, {-1, 0, 0}},
                                  {{-0.6f, 0.8f, 0}, {0, 0.8f, -0.6f}}}) {
    turned.normal = way;
    bench.normal = from;
    turned.covered = bench.covered = 1.0f;
    check_color(turned.color(), bench.color());
    turned.covered = bench.covered = 0.0f;
    turned.view = view_along({0.0, 0.0, 0.0}, glm::dvec3(way));
    bench.view = view_along({0.0, 0.0, 0.0}, glm::dvec3(from));
    check_color(turned.color(), bench.color());
  }
  turned.view = level_view();
  CHECK(turned.color().x == Approx(2.0));
}

TEST_CASE("compose: an environment image of one colour gives pi times its radiance to every normal") {
  Bench bench;
  bench.scene.environment.image = filled(128, 64, {2.0f, 4.0f, 6.0f, 1.0f});
  adjust(bench.scene.environment, 1.0, 0.0);
  for (const glm::vec3& n : {glm::vec3(0, 1, 0), {0, -1, 0}, {1, 0, 0}, {0, 0, -1}, {0.6f, 0.8f, 0}}) {
    bench.normal = n;
    const glm::vec3 color = bench.color();
    CHECK(color.x == Approx(1.0).epsilon(2e-4));
    CHECK(color.y == Approx(2.0).epsilon(2e-4));
    CHECK(color.z == Approx(3.0).epsilon(2e-4));
  }
}

TEST_CASE("compose: an environment's light reaches each normal by the cosine lobe") {
  // Of radiance up to the second order in the direction, the lobe leaves 1, 2/3 and 1/4 of the orders, times
  // pi.
  Bench bench;
  Image image(Format::RGBA32F, 256, 128);
  for (int row = 0; row < 128; ++row)
    for (int column = 0; column < 256; ++column) {
      const double up = ((row + 0.5) / 128 - 0.5) * 3.14159265358979,
                   turn = ((column + 0.5) / 256 - 0.5) * 6.28318530717959;
      const double x = std::cos(up) * std::sin(turn), y = std::sin(up), z = -std::cos(up) * std::cos(turn);
      image.at(column, row, 0) =
          static_cast<float>(4.0 + 0.3 * x + 0.4 * y - 0.5 * z + 0.8 * x * y - 0.6 * y * z + 0.7 * x * z);
      image.at(column, row, 1) = static_cast<float>(4.0 + 0.5 * (3.0 * z * z - 1.0) + 0.9 * (x * x - y * y));
    }
  bench.scene.environment.image = image;
  adjust(bench.scene.environment, 1.0, 0.0);
  for (const glm::vec3& n : {glm::vec3(0.6f, 0.0f, 0.8f), {0.0f, 0.8f, -0.6f}, {-0.6f, 0.8f, 0.0f}}) {
    bench.normal = n;
    const glm::vec3 color = bench.color();
    CHECK(color.x == Approx(0.5 * (4.0 + (0.3 * n.x + 0.4 * n.y - 0.5 * n.z) * 2.0 / 3.0 +
                                   (0.8 * n.x * n.y - 0.6 * n.y * n.z + 0.7 * n.x * n.z) * 0.25))
                         .epsilon(1e-3));
    CHECK(color.y ==
          Approx(0.5 * (4.0 + (0.5 * (3.0 * n.z * n.z - 1.0) + 0.9 * (n.x * n.x - n.y * n.y)) * 0.25))
              .epsilon(1e-3));
  }
}

TEST_CASE("compose: what of a surface is not shown is the sky behind it") {
  Bench bench;
  bench.direct = glm::vec3(kPi);
  bench.view = level_view();
  bench.scene.environment.horizon = glm::vec3(8.0f);
  bench.shown = 0.0f;
  const glm::vec3 sky = bench.color();
  bench.shown = 1.0f;
  const glm::vec3 surface = bench.color();
  bench.covered = 0.0f;
  check_color(sky, bench.color());
  bench.covered = 1.0f;
  bench.shown = 0.25f;
  check_color(bench.color(), surface * 0.25f + sky * 0.75f);
}

TEST_CASE(
    "compose: what only glass shows is lit likewise, has no backdrop, and says how much of it there is") {
  // Irradiance pi on albedo 0.5, three quarters of it shown.
  const auto composed = [](float covered) {
    const Scene scene;
    const View view = down(1.0, 10.0, 20.0);
    const Effects effects;
    const Pass pass = compose_pass();
    return texel(run_pass(definition_of(pass, {}, kHiddenBehind),
                          {.uniforms = pass.uniforms({.scene = &scene,
                                                      .effects = &effects,
                                                      .camera = &view,
                                                      .width = 1,
                                                      .height = 1,
                                                      .drawn_for = &kHiddenBehind}),
                           .textures = {filled(1, 1, glm::vec4(0.0f, 0.0f, 0.0f, covered)),
                                        filled(1, 1, {0, 1, 0, 1}), filled(1, 1, {0.5f, 0.5f, 0.5f, 0.75f}),
                                        Image{}, filled(1, 1, glm::vec4(kPi)), Image{}, Image{}, Image{},
                                        Image{}, Image{}, Image{}, Image{}, Image{}}})["scene_color"],
                 0, 0);
  };
  CHECK(composed(1.0f).y == Approx(0.375));
  CHECK(composed(1.0f).w == 0.25f);
  CHECK(composed(0.0f) == glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
}

TEST_CASE("compose: occlusion keeps the environment's light away, diffuse and mirrored, not that of lights") {
  Bench bench;
  bench.highlights = true;
  bench.view = level_view();
  bench.reflectance = glm::vec3(0.5f);
  bench.scene.environment.zenith = bench.scene.environment.horizon = bench.scene.environment.ground =
      glm::vec3(2.0f);
  bench.direct = bench.caustic = bench.emission = bench.highlight = glm::vec3(0.0f);
  const glm::vec3 of_environment = bench.color();
  CHECK(of_environment.x > 0.5f);
  bench.ambient = 0.25f;
  check_color(bench.color(), of_environment * 0.25f);
  bench.direct = glm::vec3(3.0f);
  bench.emission = glm::vec3(1.0f);
  bench.highlight = glm::vec3(0.5f);
  check_color(bench.color(), of_environment * 0.25f + bench.albedo * (3.0f / kPi) + glm::vec3(1.5f));
}

namespace {

// A black surface of alpha 0.25, of a layer or behind all layers; `nearer`: radiance of the nearer layers and
// how much passes them; `first`: w of the nearest's position; `own`: of its own.
glm::vec4 composed(int number, const glm::vec4& nearer, float first, float own = 1.0f) {
  const Pass pass = compose_pass();
  const auto is_layer = [&](const DrawnFor& each) { return each.layer == number; };
  const DrawnFor& drawn_for = *std::find_if(pass.drawn_for.begin(), pass.drawn_for.end(), is_layer);
  Scene scene;
  scene.environment.zenith = scene.environment.horizon = scene.environment.ground = glm::vec3(0.0f);
  Effects effects;
  effects.layered.active = true;
  const View view = down(1.0, 10.0, 20.0);
  const auto all = [](const glm::vec4& value) { return filled(1, 1, value); };
  // Irradiance pi on the opaque surface's albedo 1.
  const glm::vec4 albedo = number > 0 ? glm::vec4(0.0f, 0.0f, 0.0f, 0.25f) : glm::vec4(1.0f);
  return texel(run_pass(definition_of(pass, {}, drawn_for),
                        {.uniforms = pass.uniforms({.scene = &scene,
                                                    .effects = &effects,
                                                    .camera = &view,
                                                    .width = 1,
                                                    .height = 1,
                                                    .drawn_for = &drawn_for}),
                         .textures = {all(glm::vec4(own)), all({0, 1, 0, 10}), all(albedo), Image{},
                                      all(glm::vec4(kPi)), Image{}, Image{}, Image{}, Image{}, Image{},
                                      all(nearer), all(glm::vec4(first))}})["scene_color"],
               0, 0);
}

}  // namespace

TEST_CASE("compose: a black sheet of alpha 0.25 lets 0.75 of a white floor through, two let 0.5625") {
  const glm::vec4 one = composed(1, {}, 1.0f);
  CHECK(one == glm::vec4(0.0f, 0.0f, 0.0f, 0.75f));
  CHECK(composed(0, one, 1.0f).x == Approx(0.75));
  const glm::vec4 two = composed(2, one, 1.0f);
  CHECK(two.w == 0.5625f);
  CHECK(composed(0, two, 1.0f).x == Approx(0.5625));
}

TEST_CASE("compose: what glass scatters takes nothing from what lies behind, which `glass` has dimmed") {
  CHECK(composed(1, {}, 3.0f, 3.0f).w == 1.0f);
  CHECK(composed(2, {0.0f, 0.0f, 0.0f, 0.5f}, 2.0f, 3.0f).w == 0.5f);
}

TEST_CASE("compose: what shines in a nearer layer is kept, and what lies before glass left to it") {
  const glm::vec4 bright{0.5f, 0.25f, 0.0f, 0.5f};
  CHECK(composed(2, bright, 1.0f) == glm::vec4(0.5f, 0.25f, 0.0f, 0.375f));
  CHECK(composed(0, bright, 1.0f).x == Approx(0.5 + 0.5 * 1.0));
  CHECK(composed(0, bright, 2.0f).x == Approx(1.0));
  CHECK(composed(0, bright, 0.0f).x == Approx(1.0));
}
