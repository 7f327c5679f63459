#include "pipeline/views/cascades.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/effects/surface_role.hpp"

namespace caustics {

namespace {

constexpr char kName[] = "cascades";
// Of the flux, left out at each end of each axis: the windows that are tried.
constexpr double kShares[] = {0.002, 0.005, 0.01, 0.02, 0.04, 0.08, 0.15};
// How much finer the texels under the mean flux must become to be worth a second map.
constexpr double kWorth = 0.5;

std::string off_reason(const Settings& settings) {
  if (!settings.cascades) return "asked for one map a light";
  if (settings.splat != Splat::Cell) return "points would leave gaps in finer texels";
  return can_have_cascades(settings) ? "no light's caustic is small in its map"
                                     : "a grid of less than half the map's side would show its cells in finer texels";
}

void set_effect(Effects& effects, bool active, const std::string& reason) {
  const auto found = std::find_if(effects.list.begin(), effects.list.end(),
                                  [](const Effect& effect) { return effect.name == kName; });
  if (found != effects.list.end()) {
    *found = {kName, active, reason};
  } else {
    effects.list.push_back({kName, active, reason});
  }
}

// "1/12 of the map's area"
std::string size_text(const LightViews& views) {
  return "1/" + std::to_string(std::lround(views.caustic.window_area() / views.cascade->window_area())) +
         " of its map's area";
}

}  // namespace

bool can_have_cascades(const Settings& settings) {
  return settings.cascades && settings.splat == Splat::Cell && 2 * settings.grid >= settings.map;
}

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

void add_cascades(const Settings& settings, Effects& effects) {
  effects.cascades.clear();
  set_effect(effects, false, off_reason(settings));
}

void judge_cascades(const std::vector<LightViews>& views, const Settings& settings, Effects& effects) {
  add_cascades(settings, effects);
  std::string reason;
  std::size_t lights = 0;
  for (const LightViews& f : views) {
    effects.cascades.push_back(f.cascade ? "most of its light falls on " + size_text(f) : "");
    if (f.cascade && ++lights == 1) reason = effects.cascades.back();
  }
  if (lights == 1) set_effect(effects, true, "one light: " + reason);
  if (lights > 1) set_effect(effects, true, std::to_string(lights) + " lights' caustics are small in their maps");
}

}  // namespace caustics
