// The pass `light_shading` by itself: one surface point under one light.
#pragma once
#include <optional>

#include "passes/light_shading/light_shading.hpp"
#include "pipeline/settings/settings.hpp"
#include "pipeline/views/cascades.hpp"
#include "tests/support/run_pass.hpp"

namespace caustics::test {

// One surface point under one light that shines down from 10 m. All the light's views share a window of
// 8 m (tangent 1 for lights with a position), all its maps are 8 x 8.
struct LightShadingBench {
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
  int map = 8;
  LitFromBehind behind = LitFromBehind::No;
  Image shadow_depth{}, caster{}, receiver{}, caustic_map{}, cascade_map{}, panes{}, far_receiver{},
      far_caustic_map{};
  // What the camera sees with it: reflectance at normal incidence and roughness; glass and metal before it.
  bool highlights = false;
  std::optional<View> camera{};
  Image specular{}, glass{}, glass_normal{}, materials{};
  bool glass_is_pane = false;
  Image lift{};

  UniformBytes uniforms(const Pass& pass, const DrawnFor* drawn_for = nullptr) const {
    Scene scene;
    scene.lights = {light};
    Settings settings;
    settings.map = map;
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
    if (glass_is_pane) effects.surfaces = {{.role = Role::ThinPane}};
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
    if (!cascade_map.values.empty()) {
      views.cascade = view;
      views.cascade->window_lower *= 0.25;
      views.cascade->window_upper *= 0.25;
      views.cascade = covering_texels(*views.cascade, view, settings);
    }
    LightEffects of_light;
    of_light.lit.behind = behind;
    return pass.uniforms({.scene = &scene,
                          .settings = &settings,
                          .effects = &effects,
                          .views = &views,
                          .camera = camera ? &*camera : nullptr,
                          .light = &scene.lights[0],
                          .of_light = &of_light,
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

// A caustic of 0.25 square metres' worth of light in every texel, landing on a floor at height 0.
inline LightShadingBench with_caustic() {
  LightShadingBench bench;
  bench.caustics = true;
  bench.caster = filled(8, 8, glm::vec4(0.0f));
  bench.receiver = filled(8, 8, {0.0f, 0.0f, 0.0f, 1.0f});
  bench.caustic_map = filled(8, 8, {0.25f, 0.5f, 0.0f, 1.0f});
  return bench;
}

// Left half of a map filled, right half empty.
inline Image left_half(const glm::vec4& value, const glm::vec4& other) {
  Image image = filled(8, 8, other);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 4; ++x)
      for (int c = 0; c < 4; ++c) image.at(x, y, c) = value[c];
  return image;
}

}  // namespace caustics::test
