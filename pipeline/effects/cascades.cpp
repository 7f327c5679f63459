#include "pipeline/effects/cascades.hpp"

#include <cmath>

#include "pipeline/settings/settings.hpp"
#include "pipeline/settings/splat_kernel.hpp"

namespace caustics {

namespace {

// Is no more than half of a cascade border, which is not shown?
bool has_room(const Settings& settings) { return settings.map >= 4.0 * cascade_border(settings); }

}  // namespace

bool can_have_cascades(const Settings& settings) {
  return settings.cascades && settings.splat == Splat::Cell && 2 * settings.grid >= settings.map &&
         has_room(settings);
}

std::string why_no_cascades(const Settings& settings) {
  if (!settings.cascades) return "asked for one map a light";
  if (settings.splat != Splat::Cell) return "points would leave gaps in finer texels";
  if (!has_room(settings)) return "half of one would be border; a larger --map has room";
  return can_have_cascades(settings)
             ? "no light's caustic is small in its map"
             : "a grid of less than half the map's side would show its cells in finer texels";
}

namespace {

constexpr char kOutOfSight[] =
    "the camera sees nothing of what its light through the caster lights or shades";

// Lights whose casters change nothing in view are not expected to throw a caustic; without any other, there
// is none.
void leave_out_of_sight(const std::vector<PilotFinding>& findings, Effects& effects) {
  bool any = false;
  for (Expectation& e : effects.expectations) {
    if (e.expected && findings[static_cast<std::size_t>(e.light)].out_of_sight)
      e = {e.light, e.mesh, false, kOutOfSight};
    any |= e.expected;
  }
  if (any || !effects.caustics.active) return;
  for (Effect Effects::*effect :
       {&Effects::caustics, &Effects::cells, &Effects::hidden_receivers, &Effects::distance_impostors})
    if ((effects.*effect).active) effects.*effect = {false, "the camera sees nothing of the caustics"};
}

}  // namespace

Effects with_findings(Effects effects, const Settings& settings, const std::vector<PilotFinding>& findings) {
  leave_out_of_sight(findings, effects);
  std::string reason;
  std::size_t lights = 0;
  for (std::size_t i = 0; i < findings.size(); ++i) {
    std::string& cascade = effects.lights[i].cascade;
    cascade.clear();
    if (!(findings[i].cascades_in_map > 0.0) || findings[i].out_of_sight) continue;
    cascade = "most of its light falls on 1/" + std::to_string(std::lround(findings[i].cascades_in_map)) +
              " of its map's area";
    if (++lights == 1) reason = cascade;
  }
  effects.cascades = {lights > 0, lights == 0 ? why_no_cascades(settings)
                                  : lights == 1
                                      ? "one light: " + reason
                                      : std::to_string(lights) + " lights' caustics are small in their maps"};
  return effects;
}

}  // namespace caustics
