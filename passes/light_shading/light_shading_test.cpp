#include "passes/light_shading/light_shading.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "pipeline/settings/settings.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// One surface point under one light that shines down from 10 m. All the light's views share a window of
// 8 m (tangent 1 for lights with a position), all its maps are 8 x 8.
struct Bench {
  Light light = [] {
    Light sun;
    sun.direction = {0.0, -1.0, 0.0};
    sun.intensity = 100.0f;
    return sun;
  }();
  glm::vec3 position{0.5f, 0.0f, -0.5f};  // over the centre of texel (4, 4) of the parallel maps
  glm::vec3 normal{0.0f, 1.0f, 0.0f};
  float covered = 1.0f;
  bool occluders = false, caustics = false, pixel_means = true;
  double casters_nearest = 0.0;
  Image shadow_depth{}, caster{}, receiver{}, caustic_map{}, cascade_map{}, panes{}, far_receiver{},
      far_caustic_map{};
  // What the camera sees with it: reflectance at normal incidence and roughness; glass and metal before it.
  bool highlights = false;
  std::optional<View> camera{};
  Image specular{}, glass{}, glass_normal{}, materials{};
  Image lift{};

  UniformBytes uniforms(const Pass& pass, const DrawnFor* drawn_for = nullptr) const {
    Scene scene;
    scene.lights = {light};
    Settings settings;
    settings.map = 8;
    settings.pixel_means = pixel_means;
    Effects effects;
    effects.occluders.active = occluders;
    effects.smooth_shading.active = !lift.values.empty();
    effects.caustics.active = caustics;
    effects.coloured_caustics.active = caustic_map.channels() > 1;
    effects.tinted_light.active = !panes.values.empty();
    effects.hidden_receivers.active = !far_receiver.values.empty();
    effects.highlights.active = highlights;
    effects.seen_casters.active = !glass.values.empty();
    if (caustics) effects.expectations = {{0, 0, true, ""}};
    View view = down(4.0, 10.0, 20.0);
    if (light.type != LightType::Directional) {
      view = down(1.0, 10.0, 20.0);
      view.perspective = true;
      view.near = 0.1;
    }
    LightViews views{.caster = view,
                     .receiver = view,
                     .caustic = view,
                     .shadow = view,
                     .panes = view,
                     .casters_nearest = casters_nearest,
                     .column = view,
                     .cascade = {}};
    if (!cascade_map.values.empty()) views.cascade = widened(view, 0.5);
    return pass.uniforms({.scene = &scene,
                          .settings = &settings,
                          .effects = &effects,
                          .views = &views,
                          .camera = camera ? &*camera : nullptr,
                          .light = &scene.lights[0],
                          .drawn_for = drawn_for});
  }

  std::vector<Image> textures() const {
    return {filled(1, 1, {position, covered}),
            filled(1, 1, {normal, 0.0f}),
            shadow_depth,
            caster,
            receiver,
            caustic_map,
            cascade_map,
            panes,
            far_receiver,
            far_caustic_map,
            specular,
            glass,
            glass_normal,
            materials,
            lift};
  }

  PassImages run() const {
    const Pass pass = light_shading_pass();
    return run_pass(definition_of(pass), {.uniforms = uniforms(pass), .textures = textures()});
  }
  float direct() const { return run()["direct"].at(0, 0, 0); }
  float caustic() const { return run()["caustic"].at(0, 0, 0); }
  glm::vec3 highlight(const char* of = "highlight") const { return glm::vec3(texel(run()[of], 0, 0)); }
};

Bench lamp(LightType type = LightType::Point) {
  Bench bench;
  bench.light.type = type;
  bench.light.position = {0.0, 10.0, 0.0};
  return bench;
}

// A caustic of 0.25 square metres' worth of light in every texel, landing on a floor at height 0.
Bench with_caustic() {
  Bench bench;
  bench.caustics = true;
  bench.caster = filled(8, 8, glm::vec4(0.0f));
  bench.receiver = filled(8, 8, {0.0f, 0.0f, 0.0f, 1.0f});
  bench.caustic_map = filled(8, 8, {0.25f, 0.5f, 0.0f, 1.0f});
  return bench;
}

// A floor of this roughness seen along a way, reflectance 0.04.
Bench glossy(float roughness, const glm::dvec3& way) {
  Bench bench;
  bench.highlights = true;
  bench.camera = view_along(-10.0 * way, way);
  bench.specular = filled(1, 1, {0.04f, 0.04f, 0.04f, roughness});
  return bench;
}

// Radiance over irradiance as glTF 2.0 states it (appendix B.3), by the cosines of the normal with the ways
// to light and camera, and of the half vector with the normal and the camera's way.
double gltf_specular(double f0, double roughness, double nl, double nv, double nh, double vh) {
  const double a2 = std::pow(roughness, 4.0);
  const double d = a2 / (3.14159265358979 * std::pow(nh * nh * (a2 - 1.0) + 1.0, 2.0));
  const auto shadowed = [a2](double c) { return c + std::sqrt(a2 + (1.0 - a2) * c * c); };
  return d / (shadowed(nl) * shadowed(nv)) * (f0 + (1.0 - f0) * std::pow(1.0 - vh, 5.0));
}

// Left half of a map filled, right half empty.
Image left_half(const glm::vec4& value, const glm::vec4& other) {
  Image image = filled(8, 8, other);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 4; ++x)
      for (int c = 0; c < 4; ++c) image.at(x, y, c) = value[c];
  return image;
}

}  // namespace

TEST_CASE("light_shading: a caustic map of one channel lights every channel alike") {
  Bench bench = with_caustic();
  bench.light.color = {1.0f, 0.5f, 0.25f};
  const glm::vec4 three = texel(bench.run()["caustic"], 0, 0);
  Image grey(Format::R32F, 8, 8);
  for (float& value : grey.values) value = 0.25f;
  bench.caustic_map = grey;
  const glm::vec4 one = texel(bench.run()["caustic"], 0, 0);
  CHECK(one.x == three.x);
  CHECK(one == glm::vec4(three.x, 0.5f * three.x, 0.25f * three.x, 0.0f));
}

TEST_CASE("light_shading: a directional light gives lux times the cosine, by channel") {
  Bench bench;
  bench.light.color = {1.0f, 0.5f, 0.25f};
  CHECK(texel(bench.run()["direct"], 0, 0) == glm::vec4(100.0f, 50.0f, 25.0f, 0.0f));
  bench.normal = {std::sqrt(0.75f), 0.5f, 0.0f};  // leaning by 60 degrees
  CHECK(bench.direct() == Approx(50.0));
  CHECK(bench.caustic() == 0.0f);
}

TEST_CASE("light_shading: a point light gives candela times the cosine over the distance squared") {
  Bench bench = lamp();
  bench.position = {0.0f, 8.0f, 0.0f};
  CHECK(bench.direct() == Approx(25.0));  // 100 / 2^2
  // A path of (3, -4, 0): 5 m long, cosine 0.8 to the floor's normal; 100 * 0.8 / 25.
  bench.position = {3.0f, 6.0f, 0.0f};
  CHECK(bench.direct() == Approx(3.2));
}

TEST_CASE("light_shading: a spot light is whole inside its inner cone and nothing outside its outer one") {
  Bench bench = lamp(LightType::Spot);
  bench.light.direction = {0.0, -1.0, 0.0};
  bench.light.inner_cone = 0.2f;
  bench.light.outer_cone = 0.4f;
  // At this angle from the axis on the floor 2 m below, the cosine c counts three times: 100 c^3 / 4.
  const auto at = [&](double angle) {
    bench.position = {static_cast<float>(2.0 * std::tan(angle)), 8.0f, 0.0f};
    return bench.direct();
  };
  CHECK(at(0.0) == Approx(25.0));
  CHECK(at(0.19) == Approx(25.0 * std::pow(std::cos(0.19), 3)).epsilon(1e-5));
  CHECK(at(0.41) == 0.0f);
  // Where the cosine is halfway between those of the cones, the ramp is a half and the falloff its square.
  const double middle = 0.5 * (std::cos(0.2) + std::cos(0.4));
  CHECK(at(std::acos(middle)) == Approx(25.0 * 0.25 * std::pow(middle, 3)).epsilon(1e-4));
}

TEST_CASE("light_shading: a range fades a light out by 1 - (d / range)^4") {
  Bench bench = lamp();
  bench.position = {0.0f, 8.0f, 0.0f};
  bench.light.range = 4.0f;
  CHECK(bench.direct() == Approx(25.0 * 15.0 / 16.0));
  bench.light.range = 1.9f;
  CHECK(bench.direct() == 0.0f);
}

TEST_CASE("light_shading: what faces away, and where there is no surface, gets nothing") {
  Bench bench;
  bench.normal = {0.6f, -0.8f, 0.0f};
  CHECK(bench.direct() == 0.0f);
  Bench empty;
  empty.covered = 0.0f;
  CHECK(empty.direct() == 0.0f);
}

TEST_CASE("light_shading: pixels that a layer leaves free are not shaded") {
  const Pass pass = light_shading_pass();
  const auto is_layer = [](const DrawnFor& each) { return each.layer == 1; };
  const DrawnFor& drawn_for = *std::find_if(pass.drawn_for.begin(), pass.drawn_for.end(), is_layer);
  const Bench bench;
  std::vector<Image> textures = bench.textures();
  textures[0] = left_half({bench.position, 1.0f}, glm::vec4(0.0f));
  textures[1] = filled(8, 8, {bench.normal, 0.0f});
  const PassImages out =
      run_pass(definition_of(pass, {}, drawn_for),
               {.width = 8, .height = 8, .uniforms = bench.uniforms(pass, &drawn_for), .textures = textures});
  CHECK(out.result.fragments == 8 * 4);
  CHECK(out["direct"].at(3, 4, 0) == 100.0f);
  CHECK(out["direct"].at(4, 4, 0) == 0.0f);
}

TEST_CASE("light_shading: an opaque surface nearer to the light casts a shadow") {
  // The floor lies 10 m along the light; a texel is 1 m, which is what the comparison allows.
  Bench bench;
  bench.occluders = true;
  bench.shadow_depth = filled(8, 8, glm::vec4(5.0f));
  CHECK(bench.direct() == 0.0f);
  bench.shadow_depth = filled(8, 8, glm::vec4(9.5f));
  CHECK(bench.direct() == Approx(100.0));
  bench.shadow_depth = filled(8, 8, glm::vec4(1e30f));
  CHECK(bench.direct() == Approx(100.0));
  // Not looked at where nothing can throw a shadow.
  bench.shadow_depth = filled(8, 8, glm::vec4(5.0f));
  bench.occluders = false;
  CHECK(bench.direct() == Approx(100.0));
}

TEST_CASE("light_shading: a smooth surface is shadowed where it is, not where its triangle is") {
  // The triangle lies 10 m along the light, 2 m behind the occluder; the surface 3 m above it, before that.
  Bench bench;
  bench.occluders = true;
  bench.shadow_depth = filled(8, 8, glm::vec4(8.0f));
  bench.lift = filled(1, 1, glm::vec4(0.0f));
  CHECK(bench.direct() == 0.0f);
  bench.lift = filled(1, 1, {0.0f, 3.0f, 0.0f, 0.0f});
  CHECK(bench.direct() == Approx(100.0));
  // A surface that faces away lies in its own shadow, whatever a normal texture says.
  bench.normal = {0.8f, 0.6f, 0.0f};
  bench.lift = filled(1, 1, {3.0f, 3.0f, 0.0f, 0.0f});
  CHECK(bench.direct() == Approx(60.0));
  bench.lift = filled(1, 1, {3.0f, -1.0f, 0.0f, 0.0f});
  CHECK(bench.direct() == 0.0f);
}

TEST_CASE("light_shading: a shadow's edge is interpolated between texels") {
  // x = 0 lies halfway between the centres of columns 3 (shadowed) and 4; x = 0.25 three quarters across.
  Bench bench;
  bench.occluders = true;
  bench.shadow_depth = left_half(glm::vec4(5.0f), glm::vec4(1e30f));
  bench.position.x = 0.0f;
  CHECK(bench.direct() == Approx(50.0));
  bench.position.x = 0.25f;
  CHECK(bench.direct() == Approx(75.0));
}

TEST_CASE("light_shading: a slope does not shadow itself") {
  // The plane y = -2 x: 2 m of depth a texel, more than the allowance of 1 m. Its own depths are 10 + 2 x.
  Bench bench;
  bench.occluders = true;
  bench.normal = {2.0f / std::sqrt(5.0f), 1.0f / std::sqrt(5.0f), 0.0f};
  bench.shadow_depth = filled(8, 8, glm::vec4(0.0f));
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) bench.shadow_depth.at(x, y, 0) = static_cast<float>(10.0 + 2.0 * (-3.5 + x));
  for (const float x : {-1.99f, -0.4f, 0.01f, 0.5f, 0.93f}) {
    bench.position = {x, -2.0f * x, 0.0f};
    CHECK(bench.direct() == Approx(100.0 / std::sqrt(5.0)));
  }
}

TEST_CASE("light_shading: a caster before the surface takes its direct light") {
  Bench bench = with_caustic();
  bench.caster = filled(8, 8, {0.0f, 5.0f, 0.0f, 1.0f});
  CHECK(bench.direct() == 0.0f);
  bench.caster = filled(8, 8, {0.0f, -5.0f, 0.0f, 1.0f});  // behind it
  CHECK(bench.direct() == Approx(100.0));
  bench.caster = left_half({0.0f, 5.0f, 0.0f, -1.0f}, glm::vec4(0.0f));  // half, and a back face
  bench.position.x = 0.0f;
  CHECK(bench.direct() == Approx(50.0));
}

TEST_CASE("light_shading: a caustic is the texel's flux over its area, times the cosine") {
  // 8 m in 8 texels: 1 square metre each. 0.25 square metres' worth of 100 lux is 25 lumen.
  Bench bench = with_caustic();
  CHECK(texel(bench.run()["caustic"], 0, 0) == glm::vec4(25.0f, 50.0f, 0.0f, 0.0f));
  bench.normal = {std::sqrt(0.75f), 0.5f, 0.0f};
  CHECK(bench.caustic() == Approx(12.5));
  bench.normal = {0.0f, -1.0f, 0.0f};
  CHECK(bench.caustic() == 0.0f);
}

TEST_CASE("light_shading: a point light's caustic is spread over solid angle times distance squared") {
  // A window of tangents +-1 in 8 texels: 1/16 steradian at the axis, 6.25 square metres 10 m below.
  // 0.25 sr of 100 cd are 25 lumen.
  Bench bench = with_caustic();
  bench.light.type = LightType::Point;
  bench.light.position = {0.0, 10.0, 0.0};
  bench.position = {0.0f, 0.0f, 0.0f};
  CHECK(bench.caustic() == Approx(25.0 / 6.25));
  // 5 m aside, at tangent 0.5: solid angle / 1.25^1.5, distance squared 125, cosine 1 / sqrt(1.25). Area over
  // cosine is what it was: a level floor is cut into equal squares.
  bench.position = {5.0f, 0.0f, 0.0f};
  CHECK(bench.caustic() == Approx(25.0 / 6.25));
}

TEST_CASE("light_shading: only surfaces that the receiver map sees take the caustic") {
  Bench hidden = with_caustic();
  hidden.receiver = filled(8, 8, {0.0f, 5.0f, 0.0f, 1.0f});  // something 5 m above the floor
  CHECK(hidden.caustic() == 0.0f);
  Bench hole = with_caustic();
  hole.receiver = filled(8, 8, glm::vec4(0.0f));
  CHECK(hole.caustic() == 0.0f);
  Bench before = with_caustic();  // between light and casters: 10 m from the light, casters from 12 m on
  before.casters_nearest = 12.0;
  CHECK(before.caustic() == 0.0f);
  Bench outside = with_caustic();
  outside.position = {4.5f, 0.0f, 0.0f};
  CHECK(outside.caustic() == 0.0f);
}

TEST_CASE("light_shading: a light that throws no caustic neither reads nor is blocked by the casters") {
  Bench bench = with_caustic();
  bench.caster = filled(8, 8, {0.0f, 5.0f, 0.0f, 1.0f});
  bench.caustics = false;
  CHECK(bench.direct() == Approx(100.0));
  CHECK(bench.caustic() == 0.0f);
}

TEST_CASE("light_shading: two lights add up in one target by blending") {
  // 100 lux straight on, and 100 candela from 2 m: 25 lux.
  Bench sun, bulb = lamp();
  sun.position = bulb.position = {0.0f, 8.0f, 0.0f};
  const Pass pass = light_shading_pass();
  CHECK(pass.owner == Each::Frame);
  const std::unique_ptr<Device> device = make_software_device({.threads = 1});
  const PassDefinition definition = definition_of(pass);
  PassRun run{.definition = &definition};
  for (const ColorWrite& write : definition.writes)
    run.colors.push_back(device->create_texture(write.format, 1, 1));
  for (const Bench* bench : {&sun, &bulb}) {
    Draw draw{.vertex_count = 3, .uniforms = bench->uniforms(pass)};
    for (const Image& image : bench->textures())
      draw.textures.push_back(image.values.empty() ? TextureId::None : device->upload(image));
    run.draws.push_back(draw);
  }
  device->run(run);
  CHECK(device->read_back(run.colors[0]).at(0, 0, 0) == Approx(125.0));
}

TEST_CASE("light_shading: a cascade is taken where it reaches, in its own texels") {
  Bench bench = with_caustic();
  // Half as wide and high as the map: texels of a quarter of the area, so 0.5 is 8 times as much a square
  // metre.
  bench.cascade_map = filled(8, 8, {0.5f, 1.0f, 0.0f, 1.0f});
  const float by_map = bench.caustic();
  bench.position = {0.05f, 0.0f, -0.05f};
  CHECK(bench.caustic() == 8.0f * by_map);
  // Three texels from the cascade's border, where splats may lack, the map is taken.
  bench.position = {0.5f, 0.0f, -0.5f};
  CHECK(bench.caustic() == by_map);
  bench.light.type = LightType::Point;
  bench.light.position = {0.0, 10.0, 0.0};
  bench.position = {0.01f, 0.0f, -0.01f};
  const float finer = bench.caustic();
  bench.cascade_map = Image{};
  CHECK(finer == Approx(8.0 * bench.caustic()));
}

TEST_CASE(
    "light_shading: a surface that another hides from the light takes the light of the farthest receivers") {
  Bench bench = with_caustic();
  const float open = bench.caustic();
  // The farthest receivers are a floor 5 m below; a texel's extent is a metre at most, of which two may lie
  // between.
  bench.far_receiver = filled(8, 8, {0.0f, -5.0f, 0.0f, 1.0f});
  bench.far_caustic_map = filled(8, 8, {0.125f, 0.25f, 0.0f, 1.0f});
  CHECK(bench.caustic() == open);
  bench.position.y = -5.0f;
  CHECK(bench.caustic() == 0.5f * open);
  // Between both, and below the farthest, lies nothing that the light was seen to reach.
  bench.position.y = -2.5f;
  CHECK(bench.caustic() == 0.0f);
  bench.position.y = -8.0f;
  CHECK(bench.caustic() == 0.0f);
  // Where the nearest receiver is the farthest, too, both maps hold a part of its light.
  bench.receiver = bench.far_receiver;
  bench.position.y = -5.0f;
  CHECK(bench.caustic() == 1.5f * open);
}

TEST_CASE("light_shading: thin panes tint the direct light under them, not the caustic") {
  Bench bench = with_caustic();
  bench.panes = left_half({0.5f, 0.25f, 0.0f, 1.0f}, glm::vec4(1.0f));
  bench.position.x = -2.5f;
  CHECK(texel(bench.run()["direct"], 0, 0) == glm::vec4(50.0f, 25.0f, 0.0f, 0.0f));
  CHECK(bench.caustic() == Approx(25.0));
  bench.position.x = 2.5f;
  CHECK(bench.direct() == 100.0f);
  // Beyond the panes' view nothing is tinted.
  bench.position.x = -4.5f;
  CHECK(bench.direct() == 100.0f);
}

TEST_CASE("light_shading: the surroundings are lit by the same rule") {
  const Bench bench = with_caustic();
  const Pass pass = light_shading_pass();
  const PassImages out = run_pass(definition_of(pass, {}, kLightSurroundings),
                                  {.uniforms = bench.uniforms(pass), .textures = bench.textures()});
  CHECK(out["direct"].at(0, 0, 0) == Approx(100.0));
  CHECK(out["caustic"].at(0, 0, 0) == Approx(25.0));
}

namespace {

// A picture of 2 x 2 pixels, 4 m or 4 texels apart, on the floor under a map with light in one texel only.
// The pixel in the lower left has its middle at texel coordinates 2, 2.
PassImages run_wide_pixels(Bench bench, int bright_x, int bright_y, bool level = true) {
  bench.caustic_map = filled(8, 8, glm::vec4(0.0f));
  for (int c = 0; c < 3; ++c) bench.caustic_map.at(bright_x, bright_y, c) = 0.25f;
  Image position(Format::RGBA32F, 2, 2);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 2; ++x) {
      const glm::vec4 p{x == 0 ? -2.0f : 2.0f, !level && x == 1 ? 6.0f : 0.0f, y == 0 ? 2.0f : -2.0f, 1.0f};
      for (int c = 0; c < 4; ++c) position.at(x, y, c) = p[c];
    }
  const Pass pass = light_shading_pass();
  std::vector<Image> textures = bench.textures();
  textures[0] = position;
  textures[1] = filled(2, 2, {0.0f, 1.0f, 0.0f, 0.0f});
  return run_pass(definition_of(pass),
                  {.width = 2, .height = 2, .uniforms = bench.uniforms(pass), .textures = textures});
}

}  // namespace

TEST_CASE("light_shading: a pixel wider than texels shows the mean of the caustic over itself") {
  // 4 texels: a spread of sqrt(16 - 1) = 3.873 texels, by 4 samples at 0.484 and 1.452 texels to either side.
  // A texel 1.5 from the middle has a share of 1 - (1.5 - 1.452) = 0.952 in one of them along each axis, and
  // none in the others. The view's y runs against the picture's here or along it, so all four pixels are
  // added up: one of them has the texel.
  const double share = (1.0 - (1.5 - 0.375 * std::sqrt(15.0))) / 4.0;
  const PassImages out = run_wide_pixels(with_caustic(), 0, 0);
  double sum = 0.0;
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 2; ++x) sum += static_cast<double>(out["caustic"].at(x, y, 0));
  CHECK(sum == Approx(100.0 * 0.25 * share * share).epsilon(1e-5));
}

TEST_CASE("light_shading: a pixel's caustic is not averaged over what is no part of its surface") {
  // The pixels to the right lie 6 m higher: no step along the picture's x, so all samples keep the middle's
  // x, where a texel 1.5 away has no share.
  const PassImages out = run_wide_pixels(with_caustic(), 0, 0, false);
  for (int y = 0; y < 2; ++y) CHECK(out["caustic"].at(0, y, 0) == 0.0f);
}

TEST_CASE("light_shading: without pixel means a wide pixel shows its middle") {
  Bench bench = with_caustic();
  bench.pixel_means = false;
  const PassImages out = run_wide_pixels(bench, 0, 0);
  for (const float value : out["caustic"].values) CHECK(value == 0.0f);
}

TEST_CASE("light_shading: a highlight is glTF's specular lobe times the irradiance") {
  // Straight down, in the mirror's direction: 1 / (4 pi alpha^2) with alpha = 0.25, 100 lux, 0.04.
  CHECK(glossy(0.5f, {0.0, -1.0, 0.0}).highlight().x ==
        Approx(100.0 * 0.04 * 4.0 / 3.14159265).epsilon(1e-5));
  // Seen from 60 degrees: the half vector lies at 30.
  const glm::dvec3 slanted{std::sqrt(0.75), -0.5, 0.0};
  for (const float roughness : {0.3f, 0.5f, 1.0f})
    CHECK(glossy(roughness, slanted).highlight().x ==
          Approx(100.0 * gltf_specular(0.04, double(roughness), 1.0, 0.5, std::sqrt(0.75), std::sqrt(0.75)))
              .epsilon(1e-5));
  // Smoother than 0.2 the highlight keeps its size.
  CHECK(glossy(0.0f, slanted).highlight() == glossy(0.2f, slanted).highlight());
}

TEST_CASE("light_shading: a surface mirrors its caustic as it mirrors the light") {
  Bench bench = with_caustic();
  const Bench rough = glossy(1.0f, {0.0, -1.0, 0.0});
  bench.highlights = true;
  bench.camera = rough.camera;
  bench.specular = rough.specular;
  // 100 lux of the light and 25 of the caustic, over 4 pi.
  CHECK(bench.highlight().x == Approx(125.0 * 0.04 / (4.0 * 3.14159265)).epsilon(1e-5));
}

TEST_CASE("light_shading: a camera in perspective sees a highlight from where it stands") {
  Bench bench = glossy(0.5f, {0.0, -1.0, 0.0});
  bench.camera->perspective = true;
  // Over x = 0 at 10 m, the point at (0.5, -0.5): nv = 10 / sqrt(100.5).
  const double nv = 10.0 / std::sqrt(100.5), nh = std::sqrt((1.0 + nv) / 2.0);
  CHECK(bench.highlight().x == Approx(100.0 * gltf_specular(0.04, 0.5, 1.0, nv, nh, nh)).epsilon(1e-4));
}

TEST_CASE("light_shading: no highlight in shadow, and none where none are wanted") {
  Bench bench = glossy(0.5f, {0.0, -1.0, 0.0});
  bench.occluders = true;
  bench.shadow_depth = filled(8, 8, glm::vec4(5.0f));
  CHECK(bench.highlight() == glm::vec3(0.0f));
  bench.occluders = bench.highlights = false;
  CHECK(bench.highlight() == glm::vec3(0.0f));
}

TEST_CASE("light_shading: glass and metal before a surface show their own highlight") {
  Bench bench = glossy(0.5f, {0.0, -1.0, 0.0});
  bench.glass = filled(1, 1, {0.5f, 2.0f, -0.5f, 1.0f});
  bench.glass_normal = filled(1, 1, {0.0f, 1.0f, 0.0f, 0.0f});
  // Index 1.5, roughness 0.4: alpha^2 = 0.0256.
  bench.materials = Image(Format::RGBA32F, 3, 1);
  bench.materials.at(0, 0, 0) = 1.5f;
  for (int c = 0; c < 3; ++c) bench.materials.at(2, 0, c) = 0.9f - 0.3f * static_cast<float>(c);
  bench.materials.at(2, 0, 3) = 0.4f;
  const double lobe = 100.0 / (4.0 * 3.14159265 * 0.0256);
  const auto shown = [&] { return bench.highlight("caster_highlight"); };
  CHECK(shown().z == Approx(0.04 * lobe).epsilon(1e-5));
  bench.materials.at(0, 0, 3) = 1.0f;  // metal: its colour
  CHECK(shown().x == Approx(0.9 * lobe).epsilon(1e-5));
  CHECK(shown().z == Approx(0.3 * lobe).epsilon(1e-5));
  // In an opaque surface's shadow, 5 m along the light, there is none.
  bench.occluders = true;
  bench.shadow_depth = filled(8, 8, glm::vec4(5.0f));
  CHECK(shown() == glm::vec3(0.0f));
  bench.occluders = false;
  // Seen from inside there is none, nor behind the floor; the floor's own stays for glass to show.
  bench.glass = filled(1, 1, {0.5f, 2.0f, -0.5f, -1.0f});
  CHECK(shown() == glm::vec3(0.0f));
  bench.glass = filled(1, 1, {0.5f, -2.0f, -0.5f, 1.0f});
  CHECK(shown() == glm::vec3(0.0f));
  CHECK(bench.highlight() == glossy(0.5f, {0.0, -1.0, 0.0}).highlight());
}
