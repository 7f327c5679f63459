// Water: the sine wave under vertical light, and flat water under a point light.
#include <cmath>

#include "lab/reference/closed_forms.hpp"
#include "tests/support/catch.hpp"
#include "tests/truth/rows.hpp"

namespace caustics::test {

namespace {

constexpr double kPi = 3.14159265358979323846;

// ---- Sine wave: a k = 0.3, period 0.5 m, two periods of it over a floor at a share of the first
// focus' depth below the crest.

struct SineWater {
  WaterWave wave{.amplitude = 0.3 * 0.5 / (2.0 * kPi), .wave_number = 2.0 * kPi / 0.5, .index = 1.33};
  int cells = 0;
  Scene scene;

  SineWater(double share_of_focus, int cells_across) : cells(cells_across) {
    wave.depth = share_of_focus * wave.first_focus() - wave.amplitude;
    scene.materials = {diffuse(0.8f), glass(1.33f)};
    scene.meshes = {floor(1.5, 0.0, 0),
                    wave_sheet(0.5, wave.depth, wave.amplitude, wave.wave_number, cells, 1)};
    scene.lights = {sun({0.0, -1.0, 0.0}, 1.0f)};
    scene.cameras = {camera_down(0.5 * wave.depth, 0.25)};
  }

  // Normals and heights between the mesh's vertices lie on straight lines: what that moves a
  // landing by, over the whole depth. d tan(refracted) / d slope is 1 - 1 / n on level water and
  // less elsewhere.
  double landing_bound() const {
    const double step = 1.0 / cells;
    const auto slope = [&](double x) {
      return -wave.amplitude * wave.wave_number * std::sin(wave.wave_number * x);
    };
    const auto height = [&](double x) { return wave.height(x); };
    const double bend = 1.0 - 1.0 / wave.index;
    return wave.depth * bend * linear_error(slope, 0.0, 0.5, step) +
           0.3 * bend * linear_error(height, 0.0, 0.5, step) + 8.0 * kUlp * wave.depth;
  }
};

double worst_landing(const SineWater& water, const Rendering& r) {
  const Image& landing = r[light_texture(kLanding, 0)];
  const Image& entry = r[light_texture("caster_position", 0)];
  double worst = 0.0;
  for (int y = 0; y < landing.height(); ++y)
    for (int x = 0; x < landing.width(); ++x) {
      if (landing.at(x, y, 3) != float(LandingStatus::Landed)) continue;
      const double expected = water.wave.landing(double(entry.at(x, y, 0)));
      worst = std::max(worst, std::fabs(double(landing.at(x, y, 0)) - expected));
    }
  return worst;
}

// Mean of the caustic over the picture's columns, in its middle rows.
std::vector<double> strips(const Rendering& r, int pixels) {
  std::vector<double> values;
  for (int x = 0; x < pixels; ++x) {
    double sum = 0.0;
    for (int y = pixels * 3 / 8; y < pixels * 5 / 8; ++y) sum += double(r["aov_caustic"].at(x, y, 0));
    values.push_back(sum / (pixels / 4));
  }
  return values;
}

void add_picture_rows(const Bench& bench, double share, const std::string& where, Rows& rows) {
  const SineWater water(share, 400);
  const Settings settings = bench.settings();
  const Rendering r = bench.render(water.scene, settings, {"aov_caustic", kLanding, kCausticMap});
  const auto truth = [&](double shift) {
    return irradiance_average(water.wave, -0.25 + shift, 0.25 + shift, settings.width, 0.5);
  };
  const std::vector<double> exact = truth(0.0);
  const std::string text = text_of(settings) + ", 400 x 400 cells";
  rows.push_back({"sine water", "irradiance, floor at " + where + ", relative L1",
                  relative_l1(strips(r, settings.width), exact),
                  relative_l1(truth(texel_on_floor(water.scene, r, settings)), exact), text});
  rows.push_back({"sine water", "landings, floor at " + where + ", worst, m", worst_landing(water, r),
                  water.landing_bound(), text});
}

// Share of the first focus' depth at which the strip under the crest is brightest: by the picture
// and by the closed form's own means.
struct Brightest {
  double picture = 0.0, truth = 0.0;
};

constexpr double kDepthStep = 0.02;

Brightest brightest_depth(const Bench& bench) {
  Brightest found;
  double most = 0.0, most_truth = 0.0;
  for (int i = -5; i <= 5; ++i) {
    const double share = 1.0 + kDepthStep * i;
    const SineWater water(share, 400);
    const Settings settings = bench.settings();
    const Rendering r = bench.render(water.scene, settings, {"aov_caustic"});
    const auto crest = [](const std::vector<double>& v) { return v[v.size() / 2] + v[v.size() / 2 - 1]; };
    const double picture = crest(strips(r, settings.width));
    const double truth = crest(irradiance_average(water.wave, -0.25, 0.25, settings.width, 0.5));
    if (picture > most) found.picture = share;
    if (truth > most_truth) found.truth = share;
    most = std::max(most, picture);
    most_truth = std::max(most_truth, truth);
  }
  return found;
}

// Under the crest E = T / (1 - depth / focus): of two depths before the focus, the one where 1 / E
// would be 0.
double focus_by_extrapolation(const Bench& bench) {
  double depth[2], inverse[2];
  for (int i = 0; i < 2; ++i) {
    const SineWater water(i == 0 ? 0.25 : 0.5, 400);
    const Settings settings = bench.settings();
    const std::vector<double> v =
        strips(bench.render(water.scene, settings, {"aov_caustic"}), settings.width);
    depth[i] = i == 0 ? 0.25 : 0.5;
    inverse[i] = 2.0 / (v[v.size() / 2] + v[v.size() / 2 - 1]);
  }
  return depth[0] + inverse[0] * (depth[1] - depth[0]) / (inverse[0] - inverse[1]);
}

// ---- A point light of 1 candela, 1 m above flat water of 1 m depth.

constexpr double kWidest = 60.0 * kPi / 180.0;

Scene flat_water_scene(const LightOverWater& truth) {
  Scene scene;
  scene.materials = {diffuse(0.8f), glass(static_cast<float>(truth.index))};
  scene.meshes = {floor(4.0, 0.0, 0), wave_sheet(2.0, truth.depth, 0.0, 1.0, 4, 1)};
  Light light{.name = "point", .type = LightType::Point, .intensity = 1.0f};
  light.position = {0.0, truth.depth + truth.height, 0.0};
  scene.lights = {light};
  scene.cameras = {camera_down(0.5 * truth.depth, 2.7)};
  return scene;
}

double angle_of_landing(const LightOverWater& truth, double landing) {
  double low = 0.0, high = 0.49 * kPi;
  for (int i = 0; i < 60; ++i)
    (truth.landing(0.5 * (low + high)) < landing ? low : high) = 0.5 * (low + high);
  return low;
}

double irradiance_at(const LightOverWater& truth, double landing) {
  return truth.irradiance(angle_of_landing(truth, landing));
}

}  // namespace

Rows water_rows(const Bench& bench) {
  Rows rows;
  add_picture_rows(bench, 0.6, "0.6 of the first focus", rows);
  add_picture_rows(bench, 1.5, "1.5 of the first focus", rows);
  const Brightest brightest = brightest_depth(bench);
  const std::string text = text_of(bench.settings()) + ", 400 x 400 cells";
  rows.push_back({"sine water", "brightest depth against the closed form's, share of it",
                  std::fabs(brightest.picture - brightest.truth), kDepthStep + 1e-9, text});
  // Two strips of the picture, under a crest: E varies by its curvature over their width and over a
  // texel, (k w)^2 / 2 together at most.
  const double w = 2.0 * 0.5 / bench.pixels();
  const double k = 2.0 * kPi / 0.5;
  rows.push_back({"sine water", "first focus by 1 / E under the crest, share of it",
                  std::fabs(focus_by_extrapolation(bench) - 1.0), 0.5 * (k * w) * (k * w), text});
  return rows;
}

Rows point_light_rows(const Bench& bench) {
  const LightOverWater truth{.height = 1.0, .depth = 1.0, .index = 1.33};
  const Scene scene = flat_water_scene(truth);
  const Settings settings = bench.settings();
  const Rendering r = bench.render(scene, settings, {"aov_caustic"});
  const View& view = r.views[0].caustic;
  // A texel is so many tangent units wide, which 2 m below the light is as many times 2 m.
  const double texel = 2.0 * (view.window_upper.x - view.window_lower.x) / settings.map;
  constexpr int kBands = 6;
  double worst[kBands] = {}, bound[kBands] = {};
  for (int y = 0; y < settings.height; ++y)
    for (int x = 0; x < settings.width; ++x) {
      const glm::dvec2 p = 2.7 * (2.0 * (glm::dvec2(x, y) + 0.5) / double(settings.width) - 1.0);
      const double landed = glm::length(p), theta = angle_of_landing(truth, landed);
      if (theta >= kWidest) continue;
      const int band = static_cast<int>(theta / kWidest * kBands);
      const double expected = truth.irradiance(theta);
      const double found = double(r["aov_caustic"].at(x, y, 0));
      worst[band] = std::max(worst[band], std::fabs(found / expected - 1.0));
      const double shifted = irradiance_at(truth, landed + texel);
      bound[band] = std::max(bound[band], std::fabs(shifted / expected - 1.0));
    }
  Rows rows;
  for (int i = 0; i < kBands; ++i)
    rows.push_back({"point light over water",
                    "irradiance, " + std::to_string(10 * i) + " to " + std::to_string(10 * i + 10) +
                        " degrees, worst pixel",
                    worst[i], bound[i], text_of(settings)});
  return rows;
}

}  // namespace caustics::test

TEST_CASE("truth: the estimated error of water's caustic is honest") {
  using namespace caustics;
  using namespace caustics::test;
  const SineWater water(0.5, 400);
  std::vector<std::string> textures = kEstimateTextures;
  textures.emplace_back("aov_caustic");
  std::vector<double> estimates;
  for (const EstimateCase c : kEstimateCases) {
    const Settings settings = small_settings(c.grid, c.map, 128);
    const Rendering r = render(water.scene, settings, textures);
    const double error = relative_l1(strips(r, settings.width),
                                     irradiance_average(water.wave, -0.25, 0.25, settings.width, 0.5));
    const double estimate = estimate_of(r, settings).total();
    INFO("grid " << c.grid << ", map " << c.map << ": " << error << ", estimated " << estimate);
    // The picture shows the middle only, and its means over strips: the estimate also knows the light's
    // border.
    CHECK(estimate > error);
    estimates.push_back(estimate);
  }
  CHECK(estimates.back() < 0.35 * estimates.front());
}

TEST_CASE("truth: a sine wave's light before, at and behind the first focus, and the focus' depth") {
  // Irradiance: less than what a shift by one texel would make. Landings: what straight lines
  // between the mesh's vertices account for.
  caustics::test::check_rows(caustics::test::water_rows);
}

TEST_CASE("truth: a point light over flat water, on the axis and to 60 degrees off it") {
  // Each pixel: less than what a shift by one texel would make.
  caustics::test::check_rows(caustics::test::point_light_rows);
}
