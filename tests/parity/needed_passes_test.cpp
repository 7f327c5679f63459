// Only what the wanted images depend on is planned, and they are the same as those of a whole frame.
#include <algorithm>

#include "tests/support/catch.hpp"
#include "tests/support/render_scene.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/shapes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A glass ball over a floor, which a box shadows in part.
Scene shadowed_sphere() {
  Scene scene = sphere_scene(1.5f, 4);
  scene.meshes.push_back(box({-1.4, 0.4, -0.9}, {-0.6, 0.6, -0.4}, 0));
  return scene;
}

std::vector<std::string> passes_towards(const std::vector<std::string>& textures) {
  const Rendering r = render(shadowed_sphere(), small_settings(32, 32, 24), textures);
  std::vector<std::string> labels;
  for (const PassReport& report : r.passes) labels.push_back(report.label);
  std::sort(labels.begin(), labels.end());
  return labels;
}

bool runs(const std::vector<std::string>& labels, const std::string& pass) {
  return std::any_of(labels.begin(), labels.end(),
                     [&](const std::string& label) { return label.rfind(pass, 0) == 0; });
}

}  // namespace

TEST_CASE("needed passes: depth, normals and coverage need no light") {
  const std::vector<std::string> expected = {"caster_map.camera", "first_hit", "view_surfaces"};
  CHECK(passes_towards({"aov_normal"}) == expected);
  CHECK(passes_towards({"aov_position"}) == expected);
}

TEST_CASE("needed passes: direct light needs shadows, but no landings") {
  const std::vector<std::string> labels = passes_towards({"aov_direct"});
  CHECK(runs(labels, "shadow_map"));
  CHECK(runs(labels, "caster_map["));
  CHECK(runs(labels, "light_shading["));
  for (const char* pass :
       {"receiver_map", "landing", "cells", "caustic_", "cascade_", "compose", "glass", "tone_map"})
    CHECK_FALSE(runs(labels, pass));
}

TEST_CASE("needed passes: what is left out changes no texel of what is wanted") {
  const Settings settings = small_settings(32, 32, 24);
  const std::vector<std::string> layers = {"aov_direct", "aov_caustic", "aov_position", "aov_normal"};
  const Rendering whole = render(shadowed_sphere(), settings, layers);
  for (const std::string& layer : layers)
    CHECK(render(shadowed_sphere(), settings, {layer})[layer].values == whole[layer].values);
}
