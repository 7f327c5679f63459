// Rough glass in whole frames: the same light, spread.
#include "tests/support/catch.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/run_pass.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// The caustic map under a glass sphere, or an open level sheet of glass.
Rendering map_below(float roughness, bool sheet, float further_share) {
  Scene scene = sphere_scene(1.5f, 4);
  if (sheet) scene.meshes[1] = floor(0.4, 0.3, 1);
  scene.materials[1].roughness = roughness;
  Settings settings = small_settings(96, 256, 32);
  settings.further_share = further_share;
  settings.cascades = false;
  settings.splits = 0;
  settings.drawn = false;  // what goes straight through alone: the map is no wider than that needs
  return render(scene, settings, {kCausticMap});
}

struct MapLight {
  double flux = 0.0, peak = 0.0;  // peak: per square metre
};

MapLight light_below(float roughness, bool sheet = false) {
  const Rendering r = map_below(roughness, sheet, 0.03f);
  const Image& map = r[light_texture(kCausticMap, 0)];
  MapLight light{sum(map)};
  const double texel = r.views[0].caustic.window_area() / (map.width() * map.height());
  for (int y = 0; y < map.height(); ++y)
    for (int x = 0; x < map.width(); ++x)
      light.peak = std::max(light.peak, static_cast<double>(map.at(x, y, 0)) / texel);
  return light;
}

}  // namespace

TEST_CASE("rough glass: the light of a sphere is spread, the more the rougher") {
  const MapLight smooth = light_below(0.0f), rough = light_below(0.3f), rougher = light_below(0.5f);
  // Steep facets of the second surface reflect it all.
  CHECK(rough.flux > 0.85 * smooth.flux);
  CHECK(rough.peak / rough.flux < 0.5 * smooth.peak / smooth.flux);
  CHECK(rougher.peak / rougher.flux < rough.peak / rough.flux);
}

TEST_CASE("rough glass: an open sheet keeps its light") {
  // Straight down 4 % are mirrored; a facet that leans by 45 degrees mirrors 5 %.
  const MapLight smooth = light_below(0.0f, true), rough = light_below(0.4f, true);
  CHECK(smooth.flux == Approx(0.64 * 0.96).epsilon(0.01));
  CHECK(rough.flux == Approx(smooth.flux).epsilon(0.01));
}

TEST_CASE("rough glass: where light is not followed it goes as through smooth glass, to the bit") {
  const std::string name = light_texture(kCausticMap, 0);
  CHECK(sha256(map_below(0.4f, false, 1.0f)[name]) == sha256(map_below(0.0f, false, 1.0f)[name]));
}
