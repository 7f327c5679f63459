// Whole frames whose casters have textures, against light that is followed by hand.
#include <cmath>

#include "lab/reference/closed_forms.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/run_pass.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

constexpr double kPi = 3.14159265358979323846;

// An open, level sheet of 2 x 2 m; texture coordinates from 0 to 1 along +x and -z.
Mesh sheet(double height, int material) {
  Mesh mesh = floor(1.0, height, material);
  const glm::vec2 uv[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (std::size_t i = 0; i < 4; ++i) mesh.vertices[i].uv = uv[i];
  mesh.has_uv = true;
  return mesh;
}

// The sheet, of material 1, over a floor under a vertical light of 1 lux, seen from below it.
Scene under_sheet(const Material& material, double height, std::vector<Image> images) {
  Scene scene;
  scene.materials = {diffuse(0.8f), material};
  scene.meshes = {floor(2.5, 0.0, 0), sheet(height, 1)};
  scene.images = std::move(images);
  scene.lights = {sun({0.0, -1.0, 0.0}, 1.0f)};
  scene.cameras = {camera_down(0.5 * height, 0.5)};
  return scene;
}

Image texels(int width, int height) { return Image(Format::RGBA32F, width, height); }

void set_texel(Image& image, int x, int y, const glm::vec4& value) {
  for (int c = 0; c < 4; ++c) image.at(x, y, c) = value[c];
}

// The texel for a surface that rises by `slope` along +u.
glm::vec4 normal_of_slope(double slope) {
  const double length = std::sqrt(1.0 + slope * slope);
  return {static_cast<float>(0.5 - 0.5 * slope / length), 0.5f, static_cast<float>(0.5 + 0.5 / length), 1.0f};
}

Material water_with_normals(float index) {
  Material m = glass(index);
  m.normal_texture.image = 0;
  return m;
}

// Snell's law on vertical light that meets a surface of this slope: how far it lands to +x for each metre
// down, and the share that enters.
struct Bent {
  double shift, entered;
};
Bent bent(double slope, double n) {
  const double incidence = std::atan(slope), inside = std::asin(std::sin(incidence) / n);
  const double ci = std::cos(incidence), ct = std::cos(inside);
  const double rs = (ci - n * ct) / (ci + n * ct), rp = (n * ci - ct) / (n * ci + ct);
  return {std::tan(incidence - inside), 1.0 - 0.5 * (rs * rs + rp * rp)};
}

// Mean irradiance of 64 strips from x = -0.5 to 0.5 below level water whose normals are those of the sine
// h = cos(k x) slope / k, by counting rays.
std::vector<double> level_sine_truth(double slope, double k, double n, double depth) {
  std::vector<double> strips(64, 0.0);
  constexpr int kRays = 1 << 20;
  for (int i = 0; i < kRays; ++i) {
    const double x = -1.0 + 2.0 * (i + 0.5) / kRays;
    const Bent light = bent(-slope * std::sin(k * x), n);
    const double at = (x + depth * light.shift + 0.5) * 64.0;
    if (at >= 0.0 && at < 64.0) strips[static_cast<std::size_t>(at)] += light.entered * 2.0 / kRays * 64.0;
  }
  return strips;
}

// The middle row of the picture, 64 pixels.
std::vector<double> sine_picture(double slope, double k, double n, double depth, int texels_a_wave) {
  Image normals = texels(texels_a_wave, 1);
  for (int i = 0; i < texels_a_wave; ++i)
    set_texel(normals, i, 0, normal_of_slope(-slope * std::sin(2.0 * kPi * (i + 0.5) / texels_a_wave)));
  Material water = water_with_normals(static_cast<float>(n));
  // Whole waves over the 2 m, the first at x = -1.
  water.normal_texture.uv_transform[0][0] = static_cast<float>(2.0 * k / (2.0 * kPi));
  const Settings settings = small_settings(512, 512, 64);
  const Rendering r = render(under_sheet(water, depth, {normals}), settings, {"aov_direct", "aov_caustic"});
  std::vector<double> row;
  for (int x = 0; x < 64; ++x)
    row.push_back(double(r["aov_direct"].at(x, 32, 0)) + double(r["aov_caustic"].at(x, 32, 0)));
  return row;
}

double relative_l1(const std::vector<double>& found, const std::vector<double>& truth) {
  double difference = 0.0, total = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    difference += std::fabs(found[i] - truth[i]);
    total += truth[i];
  }
  return difference / total;
}

// Flux that lands, by channel.
glm::dvec3 landed(const Rendering& r) {
  glm::dvec3 sum{0.0};
  const Image& flux = r["landing_flux[0]"];
  for (int y = 0; y < flux.height(); ++y)
    for (int x = 0; x < flux.width(); ++x)
      for (int c = 0; c < 3; ++c) sum[c] += double(flux.at(x, y, c));
  return sum;
}

}  // namespace

TEST_CASE("textured casters: level water whose normals all lean moves its light as Snell's law says") {
  // A slope of 0.5 everywhere, 1 m deep.
  const Scene scene = under_sheet(water_with_normals(1.33f), 1.0, {[] {
                                    Image normals = texels(1, 1);
                                    set_texel(normals, 0, 0, normal_of_slope(0.5));
                                    return normals;
                                  }()});
  const Rendering r = render(scene, small_settings(32, 256, 16), {"landing", "caster_position"});
  const Bent light = bent(0.5, 1.33);
  int landings = 0;
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      const glm::vec4 from = texel(r["caster_position[0]"], x, y), to = texel(r["landing[0]"], x, y);
      if (from.w == 0.0f) continue;
      ++landings;
      CHECK(to.w == 1.0f);
      CHECK(to.x - from.x == Approx(light.shift).epsilon(1e-4));
      CHECK(to.z - from.z == Approx(0.0).margin(1e-5));
    }
  CHECK(landings > 700);
}

TEST_CASE("textured casters: a sine of normals on level water is as light followed by hand") {
  const double k = 4.0 * kPi, n = 1.33;
  for (const double slope : {0.1, 0.3}) {
    const double depth = 0.6 * n / ((n - 1.0) * slope * k);
    const double error =
        relative_l1(sine_picture(slope, k, n, depth, 64), level_sine_truth(slope, k, n, depth));
    INFO("slope " << slope << ": relative L1 " << error);
    CHECK(error < 0.005);
  }
}

TEST_CASE("textured casters: a sine of normals equals the sine's own surface while its waves are low") {
  // Texture and geometry differ by where the light enters: the wave's height a against the depth. The
  // landings then differ by up to (n - 1) / n (a k) a, and irradiance by k times that, (n - 1) / n (a k)^2 =
  // 0.25 % at a k = 0.1, magnified up to 2.5-fold at 0.6 of the first focus.
  const double k = 4.0 * kPi, n = 1.33, slope = 0.1;
  WaterWave wave{.amplitude = slope / k, .wave_number = k, .index = n, .depth = 1.0};
  wave.depth = 0.6 * wave.first_focus();
  const std::vector<double> truth = irradiance_average(wave, -0.5, 0.5, 64, 1.0);
  const double error = relative_l1(sine_picture(slope, k, n, wave.depth, 64), truth);
  INFO("relative L1 " << error);
  CHECK(error < 0.006);
}

TEST_CASE("textured casters: a coloured texture leaves its mean of each channel") {
  // 8 x 8 texels of three patterns, no two of which have the same mean. The sheet, a whole period of the
  // texture, covers 256 / (1 + 4 / 256) = 252.06 grid vertices each way: 252 samples of it but for 0.06 /
  // 252.
  Image stained = texels(8, 8);
  glm::dvec3 mean{0.0};
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      const glm::vec4 color{(x + y) % 2 ? 1.0f : 0.25f, static_cast<float>(x) / 7.0f,
                            (x * 3 + y * 5) % 8 < 3 ? 0.125f : 0.5f, 1.0f};
      set_texel(stained, x, y, color);
      mean += glm::dvec3(color) / 64.0;
    }
  const Settings settings = small_settings(256, 256, 16);
  Material plain = glass(1.5f), colored = plain;
  colored.base_color_texture.image = 0;
  const std::vector<std::string> wanted = {"landing_flux"};
  const glm::dvec3 without = landed(render(under_sheet(plain, 0.5, {stained}), settings, wanted));
  const glm::dvec3 with = landed(render(under_sheet(colored, 0.5, {stained}), settings, wanted));
  for (int c = 0; c < 3; ++c) {
    INFO("channel " << c);
    CHECK(with[c] / without[c] == Approx(mean[c]).epsilon(0.06 / 252.0));
  }
}

TEST_CASE("textured casters: the flux ledger closes with textures") {
  Image stained = texels(2, 1), normals = texels(2, 1);
  set_texel(stained, 0, 0, {1.0f, 0.5f, 0.0f, 1.0f});
  set_texel(stained, 1, 0, {0.0f, 0.5f, 1.0f, 1.0f});
  set_texel(normals, 0, 0, normal_of_slope(0.3));
  set_texel(normals, 1, 0, normal_of_slope(-0.1));
  Material m = water_with_normals(1.33f);
  m.base_color_texture.image = 1;
  const Settings settings = small_settings(128, 128, 16);
  const Rendering r = render(under_sheet(m, 1.0, {normals, stained}), settings,
                             {"landing_fresnel", "landing_absorbed", "caustic_map"});
  CHECK(std::fabs(ledger_of(r, settings).residual()) < 1e-5);
}

TEST_CASE("textured casters: light falls straight through the holes of an alpha mask") {
  // The left half of the sheet is cut out; the floor below it, away from the edge, has the light's full 1
  // lux, and the rest what glass of index 1.5 lets in, 0.96. The wall of the mask lies at x = 0, texels of
  // the grid are 16 mm.
  Image mask = texels(2, 1);
  set_texel(mask, 0, 0, {1.0f, 1.0f, 1.0f, 0.0f});
  set_texel(mask, 1, 0, {1.0f, 1.0f, 1.0f, 1.0f});
  Material m = glass(1.5f);
  m.base_color_texture.image = 0;
  m.alpha_mode = AlphaMode::Mask;
  const Rendering r =
      render(under_sheet(m, 0.5, {mask}), small_settings(128, 128, 32), {"aov_direct", "aov_caustic"});
  for (int x = 0; x < 32; ++x) {
    if (x >= 14 && x < 18) continue;
    INFO("pixel " << x);
    CHECK(r["aov_direct"].at(x, 16, 0) == (x < 16 ? 1.0f : 0.0f));
    CHECK(r["aov_caustic"].at(x, 16, 0) == Approx(x < 16 ? 0.0 : 0.96).epsilon(1e-3).margin(1e-6));
  }
}

TEST_CASE("textured casters: a scene without textures on casters runs the plain passes alone") {
  Scene scene = sphere_scene(1.5f, 2);
  const Settings settings = small_settings(16, 16, 16);
  const auto names = [&](const Scene& s) {
    std::string all;
    const FramePlan plan = make_plan(s, effects_of(s, settings), settings, pass_registry());
    for (const PlannedPass& pass : plan.passes)
      all += pass.label + " by " + std::string(pass.definition->shader->name) + " ";
    for (const PlannedTexture& texture : plan.textures) all += texture.name + " ";
    return all;
  };
  // A texture on the floor is no caster's.
  scene.materials[0].base_color_texture.image = 0;
  scene.images = {texels(1, 1)};
  CHECK(names(scene).find("caster_map[sun] by caster_map ") != std::string::npos);
  for (const char* part : {"detailed", "tint"}) CHECK(names(scene).find(part) == std::string::npos);
  scene.materials[1].normal_texture.image = 0;
  CHECK(names(scene).find("caster_map[sun] by caster_map_detailed ") != std::string::npos);
  CHECK(names(scene).find("caster_exit_map[sun] by caster_exit_map_detailed ") != std::string::npos);
  CHECK(names(scene).find("tint") == std::string::npos);
  scene.materials[1].base_color_texture.image = 0;
  CHECK(names(scene).find("caster_map[sun] by caster_map_tinted ") != std::string::npos);
  CHECK(names(scene).find("caster_tint[0]") != std::string::npos);
  CHECK(names(scene).find("detailed_caster_map") == std::string::npos);
}
