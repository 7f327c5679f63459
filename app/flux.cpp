#include "app/flux.hpp"

#include "app/light_groups.hpp"
#include "app/terminal.hpp"

namespace caustics::app {

std::vector<std::string> ledger_textures() {
  return {kLanding, kLandingFlux, kLandingFresnel, kLandingAbsorbed, kLandingMedium, kCellFlux, kCausticMap};
}

namespace {

Ledger read_ledger(const RenderedFrame& frame, int light) {
  const auto has = [&](const std::string& name) { return frame.has(name); };
  const auto read = [&](const std::string& name) { return frame.read(name); };
  return make_ledger(branch_images(light, frame.effects().branches, has, read),
                     frame.read(light_texture(kCausticMap, light)),
                     frame.frames()[static_cast<std::size_t>(light)].caustic, frame.settings());
}

}  // namespace

std::vector<LightLedger> read_ledgers(const RenderedFrame& frame) {
  const Scene& scene = frame.scene();
  std::vector<LightLedger> ledgers;
  for (int source = 0; source < static_cast<int>(scene.sources.size()); ++source) {
    LightLedger sum{source, {}};
    bool any = false;
    for (const int light : samples_of(scene, source)) {
      const Branch& branch = frame.effects().branches.front();
      if (!frame.has(branch_texture(kLanding, light, branch))) continue;
      if (!frame.has(light_texture(kCausticMap, light))) continue;
      // A sample's flux is relative to its own intensity.
      const double share = static_cast<double>(scene.lights[static_cast<std::size_t>(light)].intensity) /
                           static_cast<double>(scene.sources[static_cast<std::size_t>(source)].intensity);
      add(sum.ledger, read_ledger(frame, light), share);
      any = true;
    }
    if (any) ledgers.push_back(sum);
  }
  return ledgers;
}

std::vector<std::pair<const char*, FluxRgb>> accounts(const Ledger& ledger) {
  return {{"entered", ledger.entered},
          {"in_map", ledger.in_map},
          {"fresnel", ledger.fresnel},
          {"absorbed", ledger.absorbed},
          {"total_reflection", ledger.total_reflection},
          {"medium", ledger.medium},
          {"missed", ledger.missed},
          {"outside", ledger.outside},
          {"not_converged", ledger.not_converged},
          {"kernel_edge", ledger.kernel_edge}};
}

double sum(const FluxRgb& flux) { return flux[0] + flux[1] + flux[2]; }

std::string light_label(const Scene& scene, int source) {
  const std::string& name = scene.sources[static_cast<std::size_t>(source)].name;
  return name.empty() ? std::to_string(source) : "'" + one_line(name) + "'";
}

const char* flux_unit(const Light& light) {
  return light.type == LightType::Directional ? "m2 (lumen per lux)" : "sr (lumen per candela)";
}

const char* intensity_unit(const Light& light) {
  return light.type == LightType::Directional ? "lx" : "cd";
}

}  // namespace caustics::app
