#include "app/flux.hpp"

#include "app/output/light_groups.hpp"
#include "app/shell/terminal.hpp"
#include "pipeline/measure/pixel_side.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics::app {

namespace {
constexpr char kViewPosition[] = "view_position";
}

std::vector<std::string> ledger_textures() {
  std::vector<std::string> textures{kCasterNormal, kLandingMedium, kCascadeMap, kViewPosition};
  for (const char* name : {kLanding, kLandingFlux, kLandingFresnel, kLandingAbsorbed, kCellNear, kCellFar,
                           kCellFlux, kCausticMap}) {
    textures.emplace_back(name);
    textures.push_back(far_texture(name));
  }
  return textures;
}

PlanGoal goal_with_ledgers(std::vector<std::string> images) {
  PlanGoal goal{.textures = std::move(images), .beside = ledger_textures()};
  goal.beside.emplace_back("beauty");
  return goal;
}

namespace {

// The casters in the order of their rows in kCasterMaterials. None where casters share rows.
std::vector<int> casters_by_row(const RenderedFrame& frame) {
  std::vector<int> meshes;
  for (int m = 0; m < static_cast<int>(frame.effects().surfaces.size()); ++m) {
    if (!is_caster(frame.effects().surfaces[static_cast<std::size_t>(m)].role)) continue;
    if (frame.on_device().material_row(m) != static_cast<int>(meshes.size())) return {};
    meshes.push_back(m);
  }
  return meshes;
}

// Adds what a light's sample did, `share` times.
void add_sample(const RenderedFrame& frame, int light, double share, LightLedger& sum) {
  const auto has = [&](const std::string& name) { return frame.has(name); };
  const auto read = [&](const std::string& name) { return frame.read(name); };
  const std::vector<BranchImages> branches = branch_images(light, frame.effects().branches, has, read);
  const Image map = frame.read(light_texture(kCausticMap, light));
  const LightViews& views = frame.views()[static_cast<std::size_t>(light)];
  const auto if_any = [&](const std::string& name) { return has(name) ? read(name) : Image{}; };
  const std::vector<CellImages> cells = cell_images(light, frame.effects().branches, has, read);
  const Ledger ledger =
      make_ledger(branches, cells, map, if_any(light_texture(far_texture(kCausticMap), light)), views.caustic,
                  frame.settings());
  const double pixel = frame.settings().pixel_means && has(kViewPosition)
                           ? pixel_side(read(kViewPosition), map, views.caustic)
                           : 0.0;
  add(sum.ledger, ledger, share);
  add(sum.error,
      estimate_error(branches, cells, map, if_any(light_texture(kCascadeMap, light)), views, frame.settings(),
                     ledger, pixel),
      share);
  const std::vector<Outcome> outcomes = outcomes_of(
      sum.light, branches, frame.read(light_texture(kCasterNormal, light)), casters_by_row(frame));
  if (sum.outcomes.empty())
    for (const Outcome& outcome : outcomes)
      sum.outcomes.push_back({.light = outcome.light, .mesh = outcome.mesh});
  for (std::size_t i = 0; i < outcomes.size(); ++i) add(sum.outcomes[i], outcomes[i], share);
}

}  // namespace

double LightLedger::leaves() const {
  const double entered = sum(ledger.entered);
  return entered > 0.0 ? (sum(ledger.outside) + sum(ledger.kernel_edge)) / entered : 0.0;
}

std::vector<LightLedger> read_ledgers(const RenderedFrame& frame) {
  const Scene& scene = frame.scene();
  std::vector<LightLedger> ledgers;
  for (int source = 0; source < static_cast<int>(scene.sources.size()); ++source) {
    LightLedger sum{.light = source, .ledger = {}};
    bool any = false;
    for (const int light : samples_of(scene, source)) {
      const Branch& branch = frame.effects().branches.front();
      if (!frame.has(branch_texture(kLanding, light, branch))) continue;
      if (!frame.has(light_texture(kCausticMap, light))) continue;
      // A sample's flux is relative to its own intensity.
      const double share = static_cast<double>(scene.lights[static_cast<std::size_t>(light)].intensity) /
                           static_cast<double>(scene.sources[static_cast<std::size_t>(source)].intensity);
      add_sample(frame, light, share, sum);
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
          {"exit_not_found", ledger.exit_not_found},
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

const char* intensity_unit(const Light& light) { return light.type == LightType::Directional ? "lx" : "cd"; }

}  // namespace caustics::app
