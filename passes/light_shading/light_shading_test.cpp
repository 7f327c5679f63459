// Direct light: falloff, shadows, panes, highlights.
#include <algorithm>
#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/light_shading_bench.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

using Bench = LightShadingBench;

Bench lamp(LightType type = LightType::Point) {
  Bench bench;
  bench.light.type = type;
  bench.light.position = {0.0, 10.0, 0.0};
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

}  // namespace

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

TEST_CASE("light_shading: what only glass shows is lit by the same rule") {
  const Bench bench = with_caustic();
  const Pass pass = light_shading_pass();
  const PassImages out = run_pass(definition_of(pass, {}, kLightBehind),
                                  {.uniforms = bench.uniforms(pass), .textures = bench.textures()});
  CHECK(out["direct"].at(0, 0, 0) == Approx(100.0));
  CHECK(out["caustic"].at(0, 0, 0) == Approx(25.0));
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
  bench.materials = Image(Format::RGBA32F, 4, 1);
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

TEST_CASE("light_shading: a pane mirrors a light with both its faces, from either side") {
  Bench bench = glossy(0.5f, {0.0, -1.0, 0.0});
  bench.glass_is_pane = true;
  // Index 1.5, roughness 0.4: alpha^2 = 0.0256. No metal, no thickness.
  bench.materials = Image(Format::RGBA32F, 4, 1);
  bench.materials.at(0, 0, 0) = 1.5f;
  bench.materials.at(0, 0, 3) = -1.0f;
  bench.materials.at(2, 0, 3) = 0.4f;
  const double lobe = 100.0 / (4.0 * 3.14159265 * 0.0256);
  for (const float side : {1.0f, -1.0f}) {
    bench.glass = filled(1, 1, {0.5f, 2.0f, -0.5f, side});
    bench.glass_normal = filled(1, 1, {0.0f, side, 0.0f, 0.0f});
    CHECK(bench.highlight("caster_highlight").x == Approx(0.08 / 1.04 * lobe).epsilon(1e-5));
  }
}

TEST_CASE(
    "light_shading: glass and metal show no highlight of a mesh that shines, which they mirror as such") {
  Bench bench = glossy(0.5f, {0.0, -1.0, 0.0});
  bench.glass = filled(1, 1, {0.5f, 2.0f, -0.5f, 1.0f});
  bench.glass_normal = filled(1, 1, {0.0f, 1.0f, 0.0f, 0.0f});
  bench.materials = Image(Format::RGBA32F, 4, 1);
  bench.materials.at(0, 0, 0) = 1.5f;
  CHECK(bench.highlight("caster_highlight").x > 0.0f);
  bench.light.emitter = 0;
  CHECK(bench.highlight("caster_highlight") == glm::vec3(0.0f));
}

TEST_CASE("light_shading: what is seen through panes is asked for its highlight alone") {
  Bench bench = glossy(0.5f, {0.0, -1.0, 0.0});
  bench.glass = filled(1, 1, {0.5f, 2.0f, -0.5f, 1.0f});
  bench.glass_normal = filled(1, 1, {0.0f, 1.0f, 0.0f, 0.0f});
  bench.materials = Image(Format::RGBA32F, 4, 1);
  bench.materials.at(0, 0, 0) = 1.5f;
  const glm::vec3 shown = bench.highlight("caster_highlight");
  const Pass pass = light_shading_pass();
  const PassImages out =
      run_pass(definition_of(pass, {}, kLightBeyondPanes),
               {.uniforms = bench.uniforms(pass, &kLightBeyondPanes), .textures = bench.textures()});
  CHECK(glm::vec3(texel(out["caster_highlight"], 0, 0)) == shown);
  CHECK(glm::vec3(texel(out["direct"], 0, 0)) == glm::vec3(0.0f));
}
