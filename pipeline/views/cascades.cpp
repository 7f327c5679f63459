#include "pipeline/views/cascades.hpp"

#include <cmath>

#include "pipeline/effects/camera.hpp"
#include "pipeline/scene/visibility.hpp"
#include "pipeline/settings/settings.hpp"
#include "pipeline/settings/splat_kernel.hpp"

namespace caustics {

namespace {

// Windows are tried that leave out these shares of the flux at each end of each axis. The steps are small,
// because a bright part ends at an edge, and a window that cuts into it leaves its brightest light to coarse
// texels.
constexpr double kLeast = 0.002, kMost = 0.16, kStep = 1.2;
// How much finer the texels under the mean flux must become to be worth a second map.
constexpr double kWorth = 0.5;

// A light's casters shade and light only what lies in the receivers' window, and on the way there only a
// medium shows their light.
bool is_out_of_sight(const LightViews& views, const Effects& effects, const View* camera) {
  if (!camera || views.receiver.cube || effects.medium.active || effects.seen_casters.active) return false;
  return !may_see(*camera, views.receiver);
}

}  // namespace

std::optional<View> cascade_view(const View& caustic, const LandedFlux& landed, double margin,
                                 double shortest) {
  std::optional<View> best;
  double least = kWorth;
  for (double share = kLeast; share < kMost; share *= kStep) {
    View view = caustic;
    const Window window = landed.window(share);
    set_window(view, window, margin, shortest);
    const double inside = landed.share_in(window);
    const double finer = std::sqrt(view.window_area() / caustic.window_area());
    const double mean = inside * finer + (1.0 - inside);
    if (mean >= least) continue;
    least = mean;
    best = view;
  }
  return best;
}

std::optional<View> covering_texels(const View& cascade, const View& caustic, const Settings& settings) {
  // This share of a texel is more than rounding loses.
  constexpr double kSlack = 0.01;
  const glm::dvec2 texel = (caustic.window_upper - caustic.window_lower) / static_cast<double>(settings.map);
  const auto in_texels = [&](const glm::dvec2& p) { return (p - caustic.window_lower) / texel; };
  const glm::dvec2 lower = glm::floor(in_texels(cascade.window_lower)) - kSlack;
  const glm::dvec2 upper = glm::ceil(in_texels(cascade.window_upper)) + kSlack;
  const double border = cascade_border(settings) / static_cast<double>(settings.map);
  const glm::dvec2 beyond = (upper - lower) * (border / (1.0 - 2.0 * border));
  View wider = cascade;
  wider.window_lower = caustic.window_lower + (lower - beyond) * texel;
  wider.window_upper = caustic.window_lower + (upper + beyond) * texel;
  if (!(wider.window_area() < kWorth * kWorth * caustic.window_area())) return {};
  return wider;
}

std::vector<PilotFinding> findings_of(const std::vector<LightViews>& views, const Effects& effects,
                                      const View* camera) {
  std::vector<PilotFinding> findings;
  findings.reserve(views.size());
  for (const LightViews& v : views)
    findings.push_back(
        {.cascades_in_map = v.cascade ? v.caustic.window_area() / v.cascade->window_area() : 0.0,
         .out_of_sight = is_out_of_sight(v, effects, camera)});
  return findings;
}

}  // namespace caustics
