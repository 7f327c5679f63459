#include "pipeline/effects/cascades.hpp"

#include <cmath>

namespace caustics {

bool can_have_cascades(const Settings& settings) {
  return settings.cascades && settings.splat == Splat::Cell && 2 * settings.grid >= settings.map;
}

std::string why_no_cascades(const Settings& settings) {
  if (!settings.cascades) return "asked for one map a light";
  if (settings.splat != Splat::Cell) return "points would leave gaps in finer texels";
  return can_have_cascades(settings)
             ? "no light's caustic is small in its map"
             : "a grid of less than half the map's side would show its cells in finer texels";
}

Effects with_findings(Effects effects, const Settings& settings, const std::vector<PilotFinding>& findings) {
  std::string reason;
  std::size_t lights = 0;
  for (std::size_t i = 0; i < findings.size(); ++i) {
    std::string& cascade = effects.lights[i].cascade;
    cascade.clear();
    if (!(findings[i].cascades_in_map > 0.0)) continue;
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
