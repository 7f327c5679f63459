#include "app/output/first_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/expectations.hpp"
#include "app/loaded_scene.hpp"
#include "app/shell/on_demand.hpp"
#include "app/shell/terminal.hpp"
#include "pipeline/renderer/stage.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics::app {

namespace {

// Shares of the light that lands: less than the first is not seen in the picture, of which more than the
// second lies behind casters alone.
constexpr double kInPicture = 0.01, kThrough = 0.95;
// So many times as bright as what is lit beside it, or as the same place without it, a caustic is seen.
constexpr double kStandsOut = 1.05, kShows = 1.1;

// Less of the light onto the casters is no caustic that anyone would see.
constexpr double kLeastShare = 1e-3;

constexpr char kOtherWays[] = "light that takes other ways than those followed";

std::string added_line(const std::vector<std::string>& added) {
  std::string line;
  for (std::size_t i = 0; i < added.size(); ++i)
    line += (i == 0 ? "" : i + 1 == added.size() ? " and " : ", ") + added[i];
  return "added: " + (line.empty() ? "nothing" : line) + "\n";
}

// Of meshes that shine: which light the scene, and which do not and why. Nothing where none shines.
std::string shining_line(const RenderedFrame& frame) {
  const Effects& effects = frame.effects();
  return effects.emission.active ? "shining: " + effects.emissive_lights.reason + "\n" : "";
}

// What throws the caustics: "'Dragon'", "its glass and mirrors".
std::string thrown_by(const RenderedFrame& frame) {
  const std::vector<SurfaceRole>& surfaces = frame.effects().surfaces;
  int glass = 0, mirrors = 0;
  std::string label;
  for (int mesh = 0; mesh < static_cast<int>(surfaces.size()); ++mesh) {
    const Role role = surfaces[static_cast<std::size_t>(mesh)].role;
    if (!is_caster(role)) continue;
    ++(role == Role::Mirror ? mirrors : glass);
    label = mesh_label(frame.scene(), mesh);
  }
  if (glass + mirrors == 1) return label;
  return mirrors == 0 ? "its glass" : glass == 0 ? "its mirrors" : "its glass and mirrors";
}

// Of all lights together, lumen.
double lumens(const RenderedFrame& frame, const std::vector<LightLedger>& ledgers, FluxRgb Ledger::*account) {
  double all = 0.0;
  for (const LightLedger& entry : ledgers) {
    const glm::dvec3 intensity = caustic_intensity_of(frame, entry.light);
    for (int c = 0; c < 3; ++c) all += (entry.ledger.*account)[static_cast<std::size_t>(c)] * intensity[c];
  }
  return all;
}

// "at the lower left of the picture (x 410, y 530)"
std::string place_text(const glm::dvec2& pixel, const Settings& settings) {
  constexpr const char* kPlaces[3][3] = {{"at the upper left", "at the top", "at the upper right"},
                                         {"at the left", "in the middle", "at the right"},
                                         {"at the lower left", "at the bottom", "at the lower right"}};
  const auto third = [](double at, int size) { return std::clamp(static_cast<int>(3.0 * at / size), 0, 2); };
  return std::string(kPlaces[third(pixel.y, settings.height)][third(pixel.x, settings.width)]) +
         " of the picture (x " + std::to_string(static_cast<int>(pixel.x)) + ", y " +
         std::to_string(static_cast<int>(pixel.y)) + ")";
}

std::string times_text(double times) {
  const bool is_counted = times >= 9.95 && times < 1e9;
  return is_counted ? grouped(static_cast<std::uint64_t>(std::llround(times))) : significant(times, 2);
}

std::string brightness_text(const SeenCaustic& seen) {
  if (!(seen.times > 0.0)) return "where no other light falls";
  if (seen.times >= kStandsOut) return times_text(seen.times) + " times as bright as what is lit beside it";
  if (seen.times_without >= kShows || !(seen.times_without > 0.0))
    return "in a shadow, " + percent(seen.times) + " as bright as what is lit beside it";
  return "too faint to be seen beside the other light: --sun moves the light, --environment-strength dims "
         "what is around";
}

// Where the picture shows the light, or what to do to see it. `landed`: lumen; 0 where that is not known.
std::string sight_text(const RenderedFrame& frame, const SeenCaustic& seen, double landed) {
  const std::vector<std::string>& added = frame.loaded().added();
  const bool own_camera =
      !frame.settings().view && std::find(added.begin(), added.end(), kAddedCamera) == added.end();
  if (!(seen.beside + seen.through > kInPicture * landed))
    return std::string(", but the picture does not show it: ") +
           (own_camera ? "--view 37,34 frames it" : "--zoom 0.5 shows more, --view another side");
  std::string text;
  const bool only_through = seen.through > kThrough * (seen.beside + seen.through);
  if (only_through) text = ", seen through the glass only (--view shows it from another side)";
  const double shown = (seen.beside + seen.through) / landed;
  if (shown < 0.9) text += ", " + percent(shown) + " of that in the picture";
  text += "; brightest " + place_text(seen.brightest, frame.settings());
  if (seen.is_through && !only_through) text += ", through the glass";
  return text + ", " + brightness_text(seen);
}

// As an artist knows it: by the thing, whatever the light.
std::string no_caustic_text(const RenderedFrame& frame, const std::vector<LightLedger>& ledgers) {
  const std::vector<NoCaustic> groups =
      missing_caustics(frame.scene(), known_expectations(frame.scene(), frame.effects(), ledgers));
  if (groups.empty())
    return "none of its light lands: --ground on puts a ground below, --sun moves the light";
  const NoCaustic& most = groups.front();
  if (most.meshes.empty()) return most.reason;
  const std::string more = most.meshes.size() == 1 ? "" : " and " + grouped(most.meshes.size() - 1) + " more";
  return mesh_label(frame.scene(), *most.meshes.begin()) + more + ": " + most.reason;
}

std::string caustic_line(const RenderedFrame& frame, const std::vector<LightLedger>& ledgers,
                         const std::optional<SeenCaustic>& seen) {
  if (shows_none(frame, ledgers)) return "caustic: none; " + no_caustic_text(frame, ledgers) + "\n";
  if (ledgers.empty() && !seen) return "caustic: not told, as nothing that is asked for depends on it\n";
  if (ledgers.empty() && !(seen->beside + seen->through > 0.0))
    return "caustic: none in the picture; without --preview more is known\n";
  const double entered = lumens(frame, ledgers, &Ledger::entered);
  const double landed = lumens(frame, ledgers, &Ledger::in_map);
  const std::string share = entered > 0.0 ? percent(landed / entered) + " of the light onto " : "";
  const std::string by = thrown_by(frame);
  std::string line =
      "caustic: " + share + by + (share.empty() && by.ends_with("mirrors") ? " make one" : " makes one");
  if (seen) line += sight_text(frame, *seen, landed);
  return line + "\n";
}

std::string error_line(const RenderedFrame& frame, const std::vector<LightLedger>& ledgers) {
  const ErrorEstimate error = error_of(frame, ledgers);
  if (!(error.landed > 0.0)) return "error: not estimated\n";
  const std::array<std::pair<double, const char*>, 4> parts{
      {{error.map, "the map's texels (--map)"},
       {error.grid, "the spacing of the rays (--grid)"},
       {error.missing, "light whose landing was not found"},
       {error.model, kOtherWays}}};
  const auto largest = std::max_element(parts.begin(), parts.end(),
                                        [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string line = error.total() > 1.0
                         ? "error: no meaningful estimate: more than all the caustic's light is in wrong "
                           "places, most of it by "
                         : "error: estimated " + percent(error.total()) + ", most of it by ";
  line += largest->second;
  return line + (why_not_judged(frame).empty() ? "" : "; light that takes other ways is not counted") + "\n";
}

}  // namespace

bool shows_none(const RenderedFrame& frame, const std::vector<LightLedger>& ledgers) {
  if (!frame.effects().caustics.active) return true;
  return !ledgers.empty() &&
         !(lumens(frame, ledgers, &Ledger::in_map) > kLeastShare * lumens(frame, ledgers, &Ledger::entered));
}

std::string first_lines(const RenderedFrame& frame, const std::vector<LightLedger>& ledgers,
                        const std::optional<SeenCaustic>& seen) {
  return added_line(frame.loaded().added()) + shining_line(frame) + caustic_line(frame, ledgers, seen) +
         error_line(frame, ledgers);
}

}  // namespace caustics::app
