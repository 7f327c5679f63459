#include "pipeline/views/cascades.hpp"

#include <cmath>

#include "pipeline/effects/camera.hpp"
#include "pipeline/scene/visibility.hpp"

namespace caustics {

namespace {

// Of the flux, left out at each end of each axis: the windows that are tried.
constexpr double kShares[] = {0.002, 0.005, 0.01, 0.02, 0.04, 0.08, 0.15};
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
  for (const double share : kShares) {
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
