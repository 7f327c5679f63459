#include "passes/caustic_map/caustic_map.hpp"

#include "pipeline/settings/settings.hpp"
#include "pipeline/settings/splat_kernel.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// Splats a grid of landings into an 8 x 8 map over a window of 8 m: a texel is 1 m.
PassImages splat(const Image& landing, const Image& flux, Splat how, float sigma = 0.7f) {
  Settings settings;
  settings.grid = landing.width();
  settings.map = 8;
  settings.splat = how;
  settings.gaussian_sigma = sigma;
  LightViews views;
  views.caustic = down(4.0, 10.0, 20.0);
  const Pass pass = caustic_map_pass();
  return run_pass(definition_with(pass, &Effects::coloured_caustics),
                  {.width = 8,
                   .height = 8,
                   .uniforms = pass.uniforms({.settings = &settings, .views = &views}),
                   .textures = {landing, flux, Image{}},
                   .vertex_count = landing.width() * landing.height()});
}

Image landed_at(float x, float z, float status = 1.0f) { return filled(1, 1, {x, 0.0f, z, status}); }

}  // namespace

TEST_CASE("caustic_map: a point splat puts its whole flux into the texel that holds the landing") {
  // x = 1.5 is the centre of column 5 (-4 + 5.5); z = -2.5 lies up by 2.5, row 6.
  const Image map =
      splat(landed_at(1.5f, -2.5f), filled(1, 1, {2.0f, 3.0f, 4.0f, 0.0f}), Splat::Point)["caustic_map"];
  CHECK(texel(map, 5, 6) == glm::vec4(2.0f, 3.0f, 4.0f, 1.0f));
  CHECK(sum(map, 3) == 1.0);
}

TEST_CASE("caustic_map: splats into one texel add up") {
  const Image map = splat(filled(4, 4, {0.5f, 0.0f, 0.5f, 1.0f}), filled(4, 4, {0.25f, 0.5f, 1.0f, 0.0f}),
                          Splat::Point)["caustic_map"];
  CHECK(texel(map, 4, 3) == glm::vec4(4.0f, 8.0f, 16.0f, 16.0f));
}

TEST_CASE("caustic_map: only landed vertices are drawn") {
  for (const float status : {0.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f})
    CHECK(sum(splat(landed_at(0.5f, 0.5f, status), filled(1, 1, glm::vec4(1.0f)),
                    Splat::Gaussian)["caustic_map"],
              0) == 0.0);
}

TEST_CASE("caustic_map: a Gaussian inside the map deposits exactly its flux wherever its centre lies") {
  // The shares telescope (caustic_map.md); what remains is the rounding of up to 49 products.
  for (const float sigma : {0.2f, 0.3f, 0.5f, 0.7f, 1.0f})
    for (const float x : {0.0f, 0.013f, 0.25f, 0.5f, 0.77f, 0.999f})
      CHECK(
          sum(splat(landed_at(x, 0.3f), filled(1, 1, glm::vec4(1.0f)), Splat::Gaussian, sigma)["caustic_map"],
              0) == Approx(1.0).epsilon(1e-6));
}

TEST_CASE("caustic_map: a Gaussian's texels hold its integral over them") {
  // Centre of texel (4, 3), sigma 0.7: the middle share is erf(0.5 / (0.7 sqrt 2)) / erf(3 / sqrt 2) =
  // 0.524950 / 0.997300, its right neighbour's 0.5 (erf(1.5 / (0.7 sqrt 2)) - erf(0.5 / (0.7 sqrt 2))) /
  // 0.9973 = 0.5 (0.967853 - 0.524950) / 0.997300.
  const Image map =
      splat(landed_at(0.5f, 0.5f), filled(1, 1, glm::vec4(1.0f)), Splat::Gaussian)["caustic_map"];
  const double middle = 0.524950 / 0.997300, beside = 0.5 * (0.967853 - 0.524950) / 0.997300;
  CHECK(map.at(4, 3, 0) == Approx(middle * middle).epsilon(1e-4));
  CHECK(map.at(5, 3, 0) == Approx(middle * beside).epsilon(1e-4));
  CHECK(map.at(4, 2, 0) == Approx(middle * beside).epsilon(1e-4));
}

TEST_CASE("caustic_map: what a kernel loses at the map's edge is what the ledger's kernel says") {
  // Centre on the edge between the map and nothing: half the flux stays.
  Settings settings;
  settings.splat = Splat::Gaussian;
  const SplatKernel kernel = splat_kernel(settings);
  const float x = 3.75f;  // a quarter of a texel inside the right edge
  const Image map = splat(landed_at(x, 0.5f), filled(1, 1, glm::vec4(1.0f)), Splat::Gaussian)["caustic_map"];
  const double expected = kernel.share(-7.75, 0.25) * kernel.share(-4.0, 4.0);
  CHECK(expected < 0.75);
  CHECK(sum(map, 0) == Approx(expected).epsilon(1e-6));
}
