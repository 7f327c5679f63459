#include "app/flux.hpp"

#include "app/terminal.hpp"

namespace caustics::app {

std::vector<std::string> ledger_textures() {
  return {kLanding, kLandingFlux, kLandingFresnel, kLandingAbsorbed, kCellFlux, kCausticMap};
}

std::vector<LightLedger> read_ledgers(const RenderedFrame& frame) {
  std::vector<LightLedger> ledgers;
  for (int light = 0; light < static_cast<int>(frame.scene().lights.size()); ++light) {
    const std::string map = light_texture(kCausticMap, light);
    const std::vector<Branch>& branches = frame.effects().branches;
    if (!frame.has(map) || !frame.has(branch_texture(kLanding, light, branches.front()))) continue;
    const auto has = [&](const std::string& name) { return frame.has(name); };
    const auto read = [&](const std::string& name) { return frame.read(name); };
    ledgers.push_back({light, make_ledger(branch_images(light, branches, has, read), frame.read(map),
                                          frame.frames()[static_cast<std::size_t>(light)].caustic,
                                          frame.settings())});
  }
  return ledgers;
}

std::vector<std::pair<const char*, FluxRgb>> accounts(const Ledger& ledger) {
  return {{"entered", ledger.entered},
          {"in_map", ledger.in_map},
          {"fresnel", ledger.fresnel},
          {"absorbed", ledger.absorbed},
          {"total_reflection", ledger.total_reflection},
          {"missed", ledger.missed},
          {"outside", ledger.outside},
          {"not_converged", ledger.not_converged},
          {"kernel_edge", ledger.kernel_edge}};
}

double sum(const FluxRgb& flux) { return flux[0] + flux[1] + flux[2]; }

std::string light_label(const Scene& scene, int light) {
  const std::string& name = scene.lights[static_cast<std::size_t>(light)].name;
  return name.empty() ? std::to_string(light) : "'" + one_line(name) + "'";
}

const char* flux_unit(const Light& light) {
  return light.type == LightType::Directional ? "m2 (lumen per lux)" : "sr (lumen per candela)";
}

const char* intensity_unit(const Light& light) {
  return light.type == LightType::Directional ? "lx" : "cd";
}

}  // namespace caustics::app
