// Renders a scene on the software device, or another, and returns the textures asked for, by full name.
#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "passes/registry.hpp"
#include "pipeline/views/cascades.hpp"
#include "pipeline/measure/error_estimate.hpp"
#include "pipeline/renderer/light_pilot.hpp"
#include "pipeline/measure/ledger.hpp"
#include "pipeline/measure/pixel_side.hpp"
#include "pipeline/renderer/run_plan.hpp"
#include "raster/software_device.hpp"

namespace caustics::test {

struct Rendering {
  std::map<std::string, Image> images;
  std::vector<LightViews> views;
  std::vector<Branch> branches;
  std::vector<PassReport> passes;
  const Image& operator[](const std::string& name) const { return images.at(name); }
};

// `framer`: the device that fits the light views; none: the same one.
inline Rendering render_on(Device& device, const Scene& scene, const Settings& settings,
                           const std::vector<std::string>& textures, Device* framer = nullptr) {
  Effects effects = effects_of(scene, settings);
  const SceneOnDevice on_device(scene, effects, device);
  Rendering out;
  out.branches = effects.branches;
  if (framer) {
    const SceneOnDevice on_framer(scene, effects, *framer);
    out.views = fit_light_views(on_framer, effects, settings, pass_registry());
  } else {
    out.views = fit_light_views(on_device, effects, settings, pass_registry());
  }
  judge_cascades(out.views, settings, effects);
  const FramePlan plan = make_plan(scene, effects, settings, pass_registry(), {textures});
  const FrameTargets targets(plan, device);
  const FrameInputs inputs{
      .settings = &settings,
      .effects = &effects,
      .views = &out.views,
      .camera = scene.cameras.empty() ? View{}
                                    : view_of(scene.cameras[0], settings.width, settings.height,
                                               bounds_of(scene)),
      .exposure = exposure_of(scene, settings)};
  out.passes = run_plan(plan, pass_registry(), on_device, targets, inputs);
  for (std::size_t i = 0; i < plan.textures.size(); ++i)
    if (!plan.textures[i].external)
      out.images[plan.textures[i].name] = device.read_back(targets[static_cast<int>(i)]);
  return out;
}

inline Rendering render(const Scene& scene, const Settings& settings,
                        const std::vector<std::string>& textures, SoftwareOptions options = {}) {
  return render_on(*make_software_device(options), scene, settings, textures);
}

inline Ledger ledger_of(const Rendering& r, const Settings& settings, int light = 0) {
  const auto has = [&](const std::string& name) { return r.images.count(name) > 0; };
  const auto read = [&](const std::string& name) { return r[name]; };
  const std::string far = light_texture(far_texture(kCausticMap), light);
  return make_ledger(branch_images(light, r.branches, has, read), cell_images(light, r.branches, has, read),
                     r[light_texture(kCausticMap, light)], has(far) ? r[far] : Image{},
                     r.views[static_cast<std::size_t>(light)].caustic, settings);
}

// What estimate_of reads.
inline const std::vector<std::string> kEstimateTextures = {
    kLanding,  kLandingFlux, kLandingFresnel, kLandingAbsorbed, kCellNear,
    kCellFar, kCellFlux,    kCausticMap,     kCascadeMap,      "view_position"};

inline ErrorEstimate estimate_of(const Rendering& r, const Settings& settings, int light = 0) {
  const auto has = [&](const std::string& name) { return r.images.count(name) > 0; };
  const auto read = [&](const std::string& name) { return has(name) ? r[name] : Image{}; };
  const Image& map = r[light_texture(kCausticMap, light)];
  const LightViews& views = r.views[static_cast<std::size_t>(light)];
  return estimate_error(branch_images(light, r.branches, has, read), cell_images(light, r.branches, has, read), map,
                        read(light_texture(kCascadeMap, light)), views, settings, ledger_of(r, settings, light),
                        pixel_side(r["view_position"], map, views.caustic));
}

// The sizes of grid and map at which an estimate is held against the truth.
struct EstimateCase {
  int grid, map;
};
inline constexpr EstimateCase kEstimateCases[] = {{64, 64}, {64, 128}, {128, 64}, {128, 128}, {256, 128}, {256, 256}};

}  // namespace caustics::test
