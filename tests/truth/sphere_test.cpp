// Spheres of glass and of gas under parallel light.
#include <cmath>

#include "lab/reference/closed_forms.hpp"
#include "tests/support/catch.hpp"
#include "tests/truth/rows.hpp"

namespace caustics::test {

namespace {

constexpr double kPi = 3.14159265358979323846;

// The caustic of sphere_scene(n) over the pixels within `reach` of the axis, against the closed
// form's means over the same pixels, and what a shift by one texel would make of these.
struct SphereFigures {
  double error = 0.0, by_a_texel = 0.0;
};

SphereFigures compare(const Rendering& r, const Scene& scene, const Settings& settings, double index,
                      double reach) {
  const int pixels = settings.width;
  const GlassSphere sphere{.radius = 0.5, .index = index, .distance = 0.8};
  const auto truth = [&](double shift) {
    const FloorIrradiance all =
        irradiance_average(sphere, {.lower = {-1.0 + shift, -1.0}, .side = 2.0, .pixels = pixels});
    return all.values;
  };
  const auto within = [&](const auto& value_of) {
    std::vector<double> values;
    for (int y = 0; y < pixels; ++y)
      for (int x = 0; x < pixels; ++x) {
        const glm::dvec2 p = 2.0 * (glm::dvec2(x, y) + 0.5) / double(pixels) - 1.0;
        if (glm::length(p) < reach) values.push_back(value_of(x, y));
      }
    return values;
  };
  const auto of = [&](const std::vector<double>& values) {
    return within([&](int x, int y) { return values[static_cast<std::size_t>(y * pixels + x)]; });
  };
  const std::vector<double> exact = of(truth(0.0));
  const std::vector<double> picture =
      within([&](int x, int y) { return double(r["aov_caustic"].at(x, y, 0)); });
  return {relative_l1(picture, exact), relative_l1(of(truth(texel_on_floor(scene, r, settings))), exact)};
}

const std::vector<std::string> kTextures = {"aov_caustic", kCausticMap, kLandingFresnel, kLandingAbsorbed};

// How far the area of a disc round the sphere's middle, by counting the centres of grid cells, is
// from its own; its rim is drawn to a facet's sagitta, for edges of 0.02 radii.
double counted_area_error(const Rendering& r, int grid, double radius) {
  const View& view = r.views[0].caster;
  const glm::dvec2 cell = (view.window_upper - view.window_lower) / double(grid);
  const glm::dvec2 middle = view.window(view.coordinates({0.0, 0.8, 0.0}));
  double worst = 0.0;
  for (int k = -2; k <= 2; ++k) {
    const double rim = radius * (1.0 + 0.5 * k * 0.02 * 0.02 / 6.0);
    int inside = 0;
    for (int y = 0; y < grid; ++y)
      for (int x = 0; x < grid; ++x) {
        const glm::dvec2 p = view.window_lower + (glm::dvec2(x, y) + 0.5) * cell;
        inside += glm::length(p - middle) < rim ? 1 : 0;
      }
    worst = std::max(worst, std::fabs(inside * cell.x * cell.y / (kPi * radius * radius) - 1.0));
  }
  return worst;
}

// What passes the glass sphere in the outermost ring of grid cells, whose exits lie among the exit
// map's rim texels.
double rim_share(const Rendering& r, int grid) {
  const View& view = r.views[0].caster;
  const double cell = (view.window_upper.x - view.window_lower.x) / grid;
  const GlassSphere sphere{.radius = 0.5, .index = 1.5};
  double sum = 0.0;
  constexpr int kSteps = 1000;
  for (int i = 0; i < kSteps; ++i) {
    const double b = 0.5 - cell * (i + 0.5) / kSteps;
    sum += 2.0 * b * sphere.transmittance(b) * cell / kSteps;
  }
  return sum / 0.25;
}

}  // namespace

Rows sphere_rows(const Bench& bench) {
  const Scene scene = sphere_scene(1.5f, 6);
  const Settings settings = bench.settings();
  const Rendering r = bench.render(scene, settings, kTextures);
  const SphereFigures figures = compare(r, scene, settings, 1.5, 0.5);
  const Ledger l = ledger_of(r, settings);
  const double share = GlassSphere{.radius = 0.5, .index = 1.5}.transmitted_share();
  const double lost = (l.fresnel[0] + l.total_reflection[0] + l.exit_not_found[0]) / l.entered[0];
  const double counted = counted_area_error(r, settings.grid, 0.5);
  const std::string text = text_of(settings) + ", 81 920 triangles";
  return {{"glass sphere", "irradiance in the shadow, relative L1", figures.error, figures.by_a_texel, text},
          {"glass sphere", "flux that enters, relative", std::fabs(l.entered[0] / (0.25 * kPi) - 1.0),
           counted, text},
          {"glass sphere", "share reflected, and not followed at the rim", std::fabs(lost - (1.0 - share)),
           counted + rim_share(r, settings.grid), text}};
}

Rows bubble_rows(const Bench& bench) {
  Rows rows;
  for (const double index : {0.75, 1.0 / 1.33}) {
    const Scene scene = sphere_scene(static_cast<float>(index), 6);
    const Settings settings = bench.settings();
    const Rendering r = bench.render(scene, settings, kTextures);
    const Ledger l = ledger_of(r, settings);
    const std::string text = text_of(settings) + ", 81 920 triangles";
    const std::string name = index == 0.75 ? "n = 0.75" : "n = 1 / 1.33";
    // Two discs are counted: the sphere's and that of what passes.
    rows.push_back(
        {"gas bubble", "share of total reflection, 1 - n^2, " + name,
         std::fabs(l.total_reflection[0] / l.entered[0] - (1.0 - index * index)),
         counted_area_error(r, settings.grid, 0.5) + counted_area_error(r, settings.grid, 0.5 * index),
         text});
    const SphereFigures figures = compare(r, scene, settings, index, 0.5);
    rows.push_back({"gas bubble", "irradiance in the shadow, relative L1, " + name, figures.error,
                    figures.by_a_texel, text});
  }
  return rows;
}

}  // namespace caustics::test

TEST_CASE("truth: a glass sphere's irradiance, flux and loss on both devices") {
  // Irradiance: less than what a shift by one texel would make. Flux: the silhouette's sampling.
  caustics::test::check_rows(caustics::test::sphere_rows);
}

TEST_CASE(
    "truth: a cascade takes the sphere's caustic closer to its closed form than a map of twice the side") {
  using namespace caustics;
  using namespace caustics::test;
  const Scene scene = sphere_scene(1.5f, 6);
  const auto error = [&](int map, bool cascades) {
    Settings settings = through_two_surfaces(small_settings(128, map, 256));
    settings.cascades = cascades;
    return compare(render(scene, settings, kTextures), scene, settings, 1.5, 0.5).error;
  };
  CHECK(error(128, true) < error(256, false));
}

TEST_CASE("truth: a picture shows as much of a sphere's light with a cascade as without") {
  using namespace caustics;
  using namespace caustics::test;
  const Scene scene = sphere_scene(1.5f, 6);
  const auto shown = [&](bool cascades) {
    Settings settings = small_settings(256, 64, 256);
    settings.cascades = cascades;
    const Image caustic = render(scene, settings, {"aov_caustic"})["aov_caustic"];
    double sum = 0.0;
    for (int y = 0; y < caustic.height(); ++y)
      for (int x = 0; x < caustic.width(); ++x) sum += static_cast<double>(caustic.at(x, y, 0));
    return sum;
  };
  CHECK(shown(true) == Approx(shown(false)).epsilon(0.01));
}

TEST_CASE("truth: the estimated error of a sphere's caustic is honest") {
  using namespace caustics;
  using namespace caustics::test;
  const Scene scene = sphere_scene(1.5f, 6);
  std::vector<std::string> textures = kEstimateTextures;
  textures.emplace_back("aov_caustic");
  for (const EstimateCase c : kEstimateCases) {
    const Settings settings = through_two_surfaces(small_settings(c.grid, c.map, 256));
    const Rendering r = render(scene, settings, textures);
    const double error = compare(r, scene, settings, 1.5, 2.0).error;
    const double estimate = estimate_of(r, settings).total();
    INFO("grid " << c.grid << ", map " << c.map << ": " << error << ", estimated " << estimate);
    CHECK(estimate > 0.8 * error);
    // A smooth caustic's error falls faster with the grid than the estimate takes it to.
    CHECK(estimate < 6.0 * error);
  }
}

TEST_CASE("truth: a gas bubble reflects all light beyond n R and spreads the rest") {
  caustics::test::check_rows(caustics::test::bubble_rows);
}

TEST_CASE("truth: light whose exit a bubble hides is not booked as total reflection") {
  // A ball of radius R, in its middle a bubble of radius b = R / 2, n = 1.5. By Bouguer's law a ray that
  // comes at p from the axis meets the bubble where p < n b, and is totally reflected there where p > b:
  // (n^2 - 1) b^2 / R^2 = 0.3125 of the light, less Fresnel's share. What passes beside the bubble,
  // 1 - n^2 b^2 / R^2 = 0.4375, leaves behind it.
  using namespace caustics;
  using namespace caustics::test;
  Scene scene = sphere_scene(1.5f);
  const Mesh bubble = sphere({0.0, 0.8, 0.0}, 0.25, 5, 1);
  Mesh& ball = scene.meshes[1];
  const auto first = static_cast<std::uint32_t>(ball.vertices.size());
  for (Vertex v : bubble.vertices) {
    v.normal = -v.normal;
    ball.vertices.push_back(v);
  }
  for (std::size_t i = 0; i < bubble.indices.size(); i += 3)
    for (const std::size_t j : {i, i + 2, i + 1}) ball.indices.push_back(first + bubble.indices[j]);
  finish(ball, 1.0f);
  Settings settings = through_two_surfaces(small_settings(256, 256, 16));
  settings.interfaces = Interfaces::Two;
  const Ledger l = ledger_of(render(scene, settings, kTextures), settings);
  CHECK(l.total_reflection[0] / l.entered[0] < 0.3125);
  CHECK(l.total_reflection[0] / l.entered[0] > 0.15);
  CHECK(l.exit_not_found[0] / l.entered[0] > 0.9 * 0.4375);
  CHECK(l.not_converged[0] == 0.0);
  CHECK(l.residual() < 1e-5);
}
