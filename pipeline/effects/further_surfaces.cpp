#include "pipeline/effects/further_surfaces.hpp"

#include <algorithm>
#include <bit>
#include <map>

#include "pipeline/effects/optics.hpp"
#include "pipeline/gpu/text.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

int Branch::parts_at() const { return std::bit_width(mirrored); }

namespace {

// Those that a branch parts into, the last surface first, each followed by its own.
void add_parts(const Branch& branch, int splits, std::vector<Branch>& branches) {
  branches.push_back(branch);
  for (int surface = splits; surface > branch.parts_at(); --surface) {
    Branch part = branch;
    part.mirrored |= 1u << (surface - 1);
    const std::string number = std::to_string(surface);
    if (branch.mirrored != 0) {
      part.name += "+" + number;
    } else {
      part.name += (branch.name.empty() ? "mirrored " : " mirrored ") + number;
    }
    add_parts(part, splits, branches);
  }
}

}  // namespace

namespace {

constexpr const char* kInterfacesAskedFor = "a number of interfaces was asked for";

std::string why_not_by_triangles(const Scene& scene, const Effects& effects) {
  if (effects.rough_glass.active) return "rough glass (" + effects.rough_glass.reason + ")";
  return not_in_triangles(scene, effects);
}

std::string why_not_viewed(const Scene& scene, const Settings& settings, const Effects& effects) {
  if (!effects.seen_casters.active) return effects.seen_casters.reason;
  if (settings.further_share >= 1.0f) return "nothing is to be followed further (further.share 1)";
  if (settings.interfaces != Interfaces::Auto) return kInterfacesAskedFor;
  return why_not_by_triangles(scene, effects);
}

}  // namespace

void add_followed_view(const Scene& scene, const Settings& settings, Effects& effects) {
  const std::string why_not = why_not_viewed(scene, settings, effects);
  effects.followed_view = {
      why_not.empty(), why_not.empty() ? "the camera's rays are followed from surface to surface" : why_not};
}

std::string why_not_followed(const Scene& scene, const Settings& settings, const Effects& effects) {
  if (!effects.caustics.active) return "there is no caustic";
  if (settings.interfaces != Interfaces::Auto) return kInterfacesAskedFor;
  if (settings.weights == Weights::Paper) return "the paper's weights know two surfaces";
  if (settings.thickness == Thickness::Wyman) return "Wyman's thickness knows two surfaces";
  if (settings.draw_unconverged) return "what has not converged is drawn where its search stopped";
  if (settings.estimator == Estimator::Impostor) return "impostors were asked for";
  return why_not_by_triangles(scene, effects);
}

Effects with_further_surfaces(Effects effects, const Settings& settings, std::vector<FurtherShare> shares) {
  if (shares.empty()) return effects;
  std::map<int, double> of_lights;
  for (const FurtherShare& found : shares) of_lights[found.light] += found.share * found.of_light;
  double share = 0.0;
  for (const auto& [light, of_light] : of_lights) share = std::max(share, of_light);
  effects.further_shares = std::move(shares);
  const bool active = share > static_cast<double>(settings.further_share);
  const std::string limit = percent(static_cast<double>(settings.further_share));
  effects.further_surfaces = {
      active, percent(share) + " of the light that lands goes other ways than through two surfaces, " +
                  (active ? "more than " : "no more than ") + limit};
  if (!active) return effects;
  std::vector<Branch> branches;
  for (const Branch& branch : effects.branches)
    if (!branch.reflected) add_parts(branch, std::min(settings.splits, settings.bounces), branches);
  effects.branches = std::move(branches);
  return effects;
}

}  // namespace caustics
