// Renders a scene on the software device, or another, and returns the textures asked for, by full name.
#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "passes/registry.hpp"
#include "pipeline/measure/error_estimate.hpp"
#include "pipeline/measure/ledger.hpp"
#include "pipeline/measure/pixel_side.hpp"
#include "pipeline/renderer/frame_renderer.hpp"
#include "raster/software_device.hpp"

namespace caustics::test {

struct Rendering {
  std::map<std::string, Image> images;
  std::vector<LightViews> views;
  std::vector<Branch> branches;
  Effects effects;
  std::vector<PassReport> passes;
  const Image& operator[](const std::string& name) const { return images.at(name); }
};

// Draws the renderer's frame and reads all of it back that is kept.
inline Rendering rendering_of(FrameRenderer& renderer) {
  Rendering out;
  out.effects = renderer.effects();
  out.branches = out.effects.branches;
  out.views = renderer.views();
  out.passes = renderer.run();
  for (const PlannedTexture& texture : renderer.plan().textures)
    if (!texture.external && texture.kept) out.images[texture.name] = renderer.read(texture.name);
  return out;
}

// Every attachment that the registry's passes have, so that tests can look at all that was drawn on the way.
inline std::vector<std::string> all_attachments() {
  std::vector<std::string> names;
  for (const Pass& pass : pass_registry())
    for (const DrawnFor& drawn_for : pass.drawn_for) {
      const std::string label = std::string(drawn_for.label.empty() ? "" : ".").append(drawn_for.label);
      for (const Write& write : pass.writes) names.push_back(std::string(write.name) + label);
      if (pass.depth) names.push_back(std::string(pass.depth->name) + label);
    }
  return names;
}

// `pilot`: the device that fits the light views; none: the same one.
inline Rendering render_on(Device& device, Scene scene, const Settings& settings,
                           const std::vector<std::string>& textures, Device* pilot = nullptr) {
  FrameRenderer renderer(scene, settings, pass_registry(), device,
                         {.goal = {textures, all_attachments()}, .pilot = pilot});
  return rendering_of(renderer);
}

inline Rendering render(const Scene& scene, const Settings& settings,
                        const std::vector<std::string>& textures, SoftwareOptions options = {}) {
  return render_on(*make_software_device(options), scene, settings, textures);
}

// These textures and no others, in the memory and time of a frame.
inline Rendering render_alone(const Scene& given, const Settings& settings,
                              const std::vector<std::string>& textures, SoftwareOptions options = {}) {
  Scene scene = given;
  const auto device = make_software_device(options);
  FrameRenderer renderer(scene, settings, pass_registry(), *device, {.goal = {textures}});
  return rendering_of(renderer);
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
    kLanding, kLandingFlux, kLandingFresnel, kLandingAbsorbed, kCellNear,
    kCellFar, kCellFlux,    kCausticMap,     kCascadeMap,      "view_position"};

inline ErrorEstimate estimate_of(const Rendering& r, const Settings& settings, int light = 0) {
  const auto has = [&](const std::string& name) { return r.images.count(name) > 0; };
  const auto read = [&](const std::string& name) { return has(name) ? r[name] : Image{}; };
  const Image& map = r[light_texture(kCausticMap, light)];
  const LightViews& views = r.views[static_cast<std::size_t>(light)];
  return estimate_error(branch_images(light, r.branches, has, read),
                        cell_images(light, r.branches, has, read), map,
                        read(light_texture(kCascadeMap, light)), views, settings,
                        ledger_of(r, settings, light), pixel_side(r["view_position"], map, views.caustic));
}

// The sizes of grid and map at which an estimate is held against the truth.
struct EstimateCase {
  int grid, map;
};
inline constexpr EstimateCase kEstimateCases[] = {{64, 64},   {64, 128},  {128, 64},
                                                  {128, 128}, {256, 128}, {256, 256}};

}  // namespace caustics::test
