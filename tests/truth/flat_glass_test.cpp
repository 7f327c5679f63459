// Flat faces of glass: slab, prism, and single interfaces from straight on to grazing.
#include <algorithm>
#include <cmath>

#include "lab/reference/closed_forms.hpp"
#include "tests/support/catch.hpp"
#include "tests/truth/prism.hpp"
#include "tests/truth/rows.hpp"

namespace caustics::test {

namespace {

// What the closed forms here count.
Settings two_surfaces(Settings settings) {
  settings.interfaces = Interfaces::Two;
  return settings;
}

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegree = kPi / 180.0;

std::string degrees_text(double radians) {
  return std::to_string(static_cast<int>(std::lround(radians / kDegree))) + " degrees";
}

// ---- Slab: 2 x 0.3 x 2 m, its lower face 0.3 m above the floor, IOR 1.5. Red passes freely; of
// green and blue the medium leaves 0.6 and 0.2 after 0.3 m.

struct Slab {
  double angle, thickness = 0.3, bottom = 0.3, index = 1.5;
  glm::dvec3 left{1.0, 0.6, 0.2};  // after `thickness`
  Scene scene;

  explicit Slab(double incidence) : angle(incidence) {
    Material material = glass(static_cast<float>(index));
    material.attenuation_color = glm::vec3(left);
    material.attenuation_distance = static_cast<float>(thickness);
    scene.materials = {diffuse(0.8f), material};
    scene.meshes = {floor(5.0, 0.0, 0), box({-1.0, bottom, -1.0}, {1.0, bottom + thickness, 1.0}, 1)};
    scene.lights = {sun({std::sin(angle), -std::cos(angle), 0.0}, 1.0f)};
    Camera camera = camera_down(0.5 * bottom, 0.8);
    camera.position.x = patch().x;
    scene.cameras = {camera};
  }

  double shift() const { return slab_floor_shift(angle, index, thickness); }
  double inside() const { return std::asin(std::sin(angle) / index); }
  // Middle and half width of what light that passed top and bottom lights, along x, metres.
  glm::dvec2 patch() const {
    const double across = thickness * std::tan(inside()), down = bottom * std::tan(angle);
    return {0.5 * across + down, 1.0 - 0.5 * across};
  }
  double irradiance(int channel) const {
    return std::cos(angle) *
           slab_transmittance(angle, index, thickness, absorption_of(left[channel], thickness));
  }
};

// Worst landing of what enters the top and leaves the bottom, metres.
double worst_landing(const Slab& slab, const Rendering& r) {
  const Image& landing = r[light_texture(kLanding, 0)];
  const Image& entry = r[light_texture("caster_position", 0)];
  const Image& normal = r[light_texture("caster_normal", 0)];
  double worst = 0.0;
  for (int y = 0; y < landing.height(); ++y)
    for (int x = 0; x < landing.width(); ++x) {
      if (entry.at(x, y, 3) == 0.0f || normal.at(x, y, 1) < 0.99f) continue;
      const double entered = entry.at(x, y, 0);
      // Within two or three texels of the bottom's edge the exit map mixes in other faces.
      const double left = entered + slab.thickness * std::tan(slab.inside());
      if (left > 1.0 - 0.03 || std::fabs(entry.at(x, y, 2)) > 1.0f - 0.03f) continue;
      const double top = slab.bottom + slab.thickness;
      const double expected = entered + top * std::tan(slab.angle) - slab.shift();
      REQUIRE(landing.at(x, y, 3) == float(LandingStatus::Landed));
      worst = std::max(worst, std::fabs(double(landing.at(x, y, 0)) - expected));
    }
  return worst;
}

// Worst pixel of the patch's inside, relative, in one channel.
double worst_pixel(const Slab& slab, const Rendering& r, int pixels, double margin, int channel) {
  const glm::dvec2 patch = slab.patch();
  double worst = 0.0;
  for (int y = pixels / 4; y < pixels * 3 / 4; ++y)
    for (int x = 0; x < pixels; ++x) {
      const double away = std::fabs(0.8 * (2.0 * (x + 0.5) / pixels - 1.0));
      if (away > patch.y - margin) continue;
      const double found = r["aov_caustic"].at(x, y, channel);
      worst = std::max(worst, std::fabs(found / slab.irradiance(channel) - 1.0));
    }
  return worst;
}

// ---- Interfaces: R of a level sheet, by what is booked.

// Share of the flux that the sheet reflects, over all grid vertices that see it.
double booked_reflectance(const Bench& bench, double incidence, double index) {
  Scene scene;
  scene.materials = {diffuse(0.8f), glass(static_cast<float>(index))};
  scene.meshes = {floor(8.0, 0.0, 0), wave_sheet(1.0, 0.1, 0.0, 1.0, 4, 1)};
  scene.lights = {sun({std::sin(incidence), -std::cos(incidence), 0.0}, 1.0f)};
  // Fine enough to see the sheet at half a degree: 17 mm of a window of 1 m.
  const Rendering r =
      bench.render(scene, through_two_surfaces(small_settings(256, 256, 8)), {kLandingFresnel, kCausticMap});
  const Image& fresnel = r[light_texture(kLandingFresnel, 0)];
  double reflected = 0.0, entered = 0.0;
  for (int y = 0; y < fresnel.height(); ++y)
    for (int x = 0; x < fresnel.width(); ++x) {
      reflected += double(fresnel.at(x, y, 0));
      entered += double(fresnel.at(x, y, 3));
    }
  REQUIRE(entered > 0.0);
  return reflected / entered;
}

double reflectance(double incidence, double index) { return fresnel(std::cos(incidence), 1.0, index).mean(); }

// The cosine between two rounded unit vectors is off by some roundings, and R by its slope times as
// much, besides its own roundings.
double reflectance_bound(double incidence, double index) {
  const double off = 4.0 * kUlp, cosine = std::cos(incidence);
  const auto at = [&](double c) { return fresnel(std::max(c, 0.0), 1.0, index).mean(); };
  return std::max(std::fabs(at(cosine + off) - at(cosine)), std::fabs(at(cosine - off) - at(cosine))) +
         4.0 * kUlp;
}

// ---- The critical angle, from inside: where a prism's exit face begins to let light out.

// Does the exit face reflect all light that comes to it? Light and prism as given; the float's
// index.
bool all_reflected(const Bench& bench, double incidence, double index) {
  const Prism prism(glass(static_cast<float>(index)), incidence);
  const Rendering r =
      bench.render(prism.scene, two_surfaces(small_settings(32, 32, 8)), {kLanding, kCausticMap});
  const Image& landing = r[light_texture(kLanding, 0)];
  const Image& position = r[light_texture("caster_position", 0)];
  int reflected = 0, compared = 0;
  const int y = landing.height() / 2;
  for (int x = 0; x < landing.width(); ++x) {
    const glm::dvec3 p1{position.at(x, y, 0), position.at(x, y, 1), 0.0};
    if (position.at(x, y, 3) == 0.0f || !prism.is_entry(r[light_texture("caster_normal", 0)], x, y) ||
        !prism.exit_point(p1, index))
      continue;
    ++compared;
    reflected += landing.at(x, y, 3) == float(LandingStatus::TotalReflection) ? 1 : 0;
  }
  REQUIRE(compared > 0);
  return reflected * 2 > compared;
}

// Incidence on the entry face below which the exit face reflects everything, by bisection.
double found_least_incidence(const Bench& bench, double index, double expected) {
  double low = expected - 0.01, high = expected + 0.01;
  REQUIRE(all_reflected(bench, low, index));
  REQUIRE_FALSE(all_reflected(bench, high, index));
  for (int i = 0; i < 14; ++i) {
    const double middle = 0.5 * (low + high);
    (all_reflected(bench, middle, index) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// How far the least incidence moves: the exit's squared cosine, n^2 cos^2 in the glass, is rounded
// and taken for 0 down to -1e-6 (optics.glsl); each vector is rounded to some ulps.
double least_incidence_bound(double index, double incidence) {
  const double inside = std::asin(std::sin(incidence) / index);
  const double inside_by_incidence = std::cos(incidence) / (index * std::cos(inside));
  const double squared_by_inside = 2.0 * index * std::cos(critical_angle(index));
  return (1e-6 + 8.0 * kUlp) / (squared_by_inside * inside_by_incidence) + 0.02 / (1 << 14);
}

}  // namespace

Rows slab_rows(const Bench& bench) {
  Rows rows;
  for (const double angle : {0.0, 20.0 * kDegree, 40.0 * kDegree, 60.0 * kDegree, 75.0 * kDegree}) {
    const Slab slab(angle);
    const Settings settings = two_surfaces(bench.settings());
    const Rendering r = bench.render(slab.scene, settings, {"aov_caustic", kLanding, kCausticMap});
    const std::string text = text_of(settings);
    const double texel = texel_on_floor(slab.scene, r, settings);
    // Roundings of coordinates up to 5 m, of which the floor's is stretched along the slant.
    rows.push_back({"slab", "landings, floor shift at " + degrees_text(angle) + ", worst, m",
                    worst_landing(slab, r), 4.0 * 5.0 * kUlp / std::cos(angle), text});
    const char* names[] = {"T^2, free of absorption", "T^2 and 0.6 left after 0.3 m",
                           "T^2 and 0.2 left after 0.3 m"};
    const double margin = 3.0 * texel + 2.0 * 1.6 / settings.width;
    for (int c = 0; c < 3; ++c)
      rows.push_back({c == 0 ? "slab" : "Beer and Lambert",
                      std::string(names[c]) + ", " + degrees_text(angle) + ", worst pixel",
                      worst_pixel(slab, r, settings.width, margin, c), 4.0 * settings.map * 0.5 * kUlp,
                      text});
  }
  return rows;
}

Rows prism_rows(const Bench& bench) {
  Rows rows;
  const int grid = bench.full ? 512 : 128;
  const Settings settings = two_surfaces(small_settings(grid, grid, 8));
  for (const double incidence : {30.0, 40.0, 50.0, 65.0}) {
    const Prism prism(glass(1.5f), incidence * kDegree);
    const Rendering r = bench.render(prism.scene, settings, {kLanding, kCausticMap});
    int compared = 0;
    const double worst = worst_landing(prism, r, light_texture(kLanding, 0), 1.5, compared);
    const double deviation = *prism_deviation(60.0 * kDegree, 1.5, incidence * kDegree);
    // Across the ray, seen from the prism's middle.
    const double squared_cosine = std::cos(deviation) * std::cos(deviation);
    rows.push_back({"prism", "deviation at " + degrees_text(incidence * kDegree) + ", worst ray, radians",
                    compared > 0 ? worst * squared_cosine / prism.height : 1.0,
                    // Some ulps of each coordinate, up to 4 m; the exit's cosine divides them.
                    4.0 * 4.0 * kUlp, text_of(settings)});
  }
  Material bk7 = glass(1.5168f);
  bk7.dispersion = static_cast<float>(20.0 / 64.17);
  const Prism prism(bk7);
  const Rendering r = bench.render(prism.scene, settings, {kLanding, kCausticMap});
  double worst = 0.0;
  int compared = 0;
  for (const Branch& branch : r.branches)
    worst = std::max(worst, worst_landing(prism, r, branch_texture(kLanding, 0, branch),
                                          1.5168 + 0.5168 / 64.17 * branch.bend, compared));
  rows.push_back({"prism", "BK7, landings of the C, d and F lines, worst, m",
                  r.branches.size() == 3 ? worst : 1.0, 4.0 * 4.0 * kUlp, text_of(settings)});
  return rows;
}

Rows interface_rows(const Bench& bench) {
  Rows rows;
  for (const double index : {1.33, 1.5, 2.42}) {
    const double rounded = static_cast<float>(index);
    const std::string n = "n = " + std::to_string(index).substr(0, 4);
    const auto add = [&](const std::string& what, const std::vector<double>& angles) {
      // The angle that comes nearest to its bound.
      Row worst{"interface", "R, " + what + ", " + n, 0.0, 1.0, "grid 256"};
      double most = -1.0;
      for (const double angle : angles) {
        const double error =
            std::fabs(booked_reflectance(bench, angle, rounded) - reflectance(angle, rounded));
        const double bound = reflectance_bound(angle, rounded);
        if (error / bound <= most) continue;
        most = error / bound;
        worst.error = error;
        worst.bound = bound;
      }
      rows.push_back(worst);
    };
    add("0, 20, 40 degrees and Brewster's angle",
        {0.0, 20.0 * kDegree, 40.0 * kDegree, brewster_angle(index)});
    add("grazing: 80, 85, 89 and 89.5 degrees",
        {80.0 * kDegree, 85.0 * kDegree, 89.0 * kDegree, 89.5 * kDegree});
  }
  for (const double index : {1.33, 1.5, 1.7}) {
    const double rounded = static_cast<float>(index);
    const double expected = prism_least_incidence(60.0 * kDegree, rounded);
    rows.push_back({"interface",
                    "total reflection inside a prism: incidence where it ends, n = " +
                        std::to_string(index).substr(0, 4) + ", radians",
                    std::fabs(found_least_incidence(bench, rounded, expected) - expected),
                    least_incidence_bound(rounded, expected), "grid 32"});
  }
  return rows;
}

}  // namespace caustics::test

TEST_CASE("truth: a slab shifts light and dims it by channel, from 0 to 75 degrees") {
  // Landings are plane geometry and the light is even: what is left is single precision. In the
  // picture a cell's corners are rounded at the map's far end, so its overlaps are good to the
  // map's size in ulps.
  caustics::test::check_rows(caustics::test::slab_rows);
}

TEST_CASE("truth: a prism's deviation at four angles, and its colours, on both devices") {
  caustics::test::check_rows(caustics::test::prism_rows);
}

TEST_CASE("truth: reflectance to grazing angles, and where total reflection ends") {
  caustics::test::check_rows(caustics::test::interface_rows);
}

TEST_CASE("truth: a prism's light lands on a floor that begins beside it") {
  // Straight on, beneath the prism, there is none. The ray at its left edge lands nearest, at x = 0.2157 m.
  using namespace caustics;
  using namespace caustics::test;
  Prism prism(glass(1.5f));
  for (Vertex& v : prism.scene.meshes[0].vertices) v.position.x = std::max(v.position.x, 0.2f);
  finish(prism.scene.meshes[0], 0.0f);
  const Rendering r = render(prism.scene, two_surfaces(small_settings(128, 256, 8)), {kLanding, kCausticMap});
  int compared = 0;
  CHECK(worst_landing(prism, r, light_texture(kLanding, 0), 1.5, compared) < 1e-5);
  CHECK(compared > 50);
}
