#include "pipeline/effects/further_surfaces.hpp"

#include <algorithm>
#include <map>

#include "pipeline/effects/branches.hpp"
#include "pipeline/effects/drawn_sizes.hpp"
#include "pipeline/gpu/text.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

namespace {

// Metal mirrors all that it does not absorb: its light never parts.
bool any_refractor(const Effects& effects) {
  return std::any_of(effects.surfaces.begin(), effects.surfaces.end(),
                     [](const SurfaceRole& surface) { return surface.role == Role::Refractor; });
}

// Those that part from a branch by being mirrored, the last surface first, and what all of these leave
// behind.
void add_parted(const Branch& through, int splits, bool drawn, std::vector<Branch>& branches) {
  const std::string before = through.name.empty() ? "" : through.name + " ";
  for (int surface = splits; surface > 0; --surface) {
    branches.push_back(through);
    branches.back().name = before + "mirrored " + std::to_string(surface);
    branches.back().mirrored_at = surface;
  }
  if (!drawn) return;
  branches.push_back(through);
  branches.back().name = before + "drawn";
  branches.back().drawn = true;
}

constexpr const char* kInterfacesAskedFor = "a number of interfaces was asked for";

}  // namespace

std::string why_not_followed(const Settings& settings, const Effects& effects) {
  if (!effects.caustics.active) return "there is no caustic";
  if (settings.interfaces != Interfaces::Auto) return kInterfacesAskedFor;
  if (settings.weights == Weights::Paper) return "the paper's weights know two surfaces";
  if (settings.thickness == Thickness::Wyman) return "Wyman's thickness knows two surfaces";
  if (settings.draw_unconverged) return "what has not converged is drawn where its search stopped";
  if (settings.estimator == Estimator::Impostor) return "impostors were asked for";
  return {};
}

Effects with_further_surfaces(Effects effects, const Settings& settings, std::vector<FurtherShare> shares) {
  const bool sizes = any_size_is_drawn(effects);
  // Rough glass sends all its light other ways.
  const bool spread = effects.rough_glass.active && settings.further_share < 1.0f;
  if (shares.empty() && !sizes) {
    if (may_be_followed(effects)) effects.further_surfaces.reason = "none of the casters' light lands";
    return effects;
  }
  std::map<int, double> of_lights;
  for (const FurtherShare& found : shares) of_lights[found.light] += found.share * found.of_light;
  double share = 0.0, seen = 0.0;
  for (const auto& [light, of_light] : of_lights) share = std::max(share, of_light);
  for (const FurtherShare& found : shares) seen = std::max(seen, found.seen);
  for (const FurtherShare& found : shares)
    effects.lights[static_cast<std::size_t>(found.light)].lit = found.lit;
  effects.further_shares = std::move(shares);
  const bool by_sight = seen > share;
  const double limit = static_cast<double>(settings.further_share);
  const bool enough = limit < 1.0 && std::max(share, seen) >= limit;
  const bool active = enough || sizes || spread;
  effects.further_surfaces = {
      active, percent(std::max(share, seen)) + " of the light that " + (by_sight ? "is seen" : "lands") +
                  " goes other ways than through two surfaces" +
                  (limit > 0.0 ? (enough ? ", at least " : ", less than ") + percent(limit) : "") +
                  (sizes ? "; and a light has a size" : "") + (spread ? "; and glass is rough" : "")};
  if (!active) return effects;
  for (const FurtherShare& found : effects.further_shares)
    if (found.looks != glm::dvec3(0.0))
      effects.lights[static_cast<std::size_t>(found.light)].looks = found.looks;
  std::vector<Branch> branches;
  const bool parts = any_refractor(effects);
  for (const Branch& branch : effects.branches)
    if (!branch.reflected) {
      branches.push_back(branch);
      if (parts) add_parted(branch, std::min(settings.splits, settings.bounces), settings.drawn, branches);
    }
  for (Branch& branch : branches) branch.spread = all_light_is_spread(effects);
  effects.branches = std::move(branches);
  return effects;
}

}  // namespace caustics
