#include "lab/study/sweep_settings.hpp"

#include <algorithm>

#include "pipeline/settings/check_settings.hpp"
#include "pipeline/settings/setting.hpp"

namespace caustics::study {

Settings settings_at(const Settings& base, const std::vector<Knob>& knobs, const Point& point) {
  Settings settings = base;
  for (std::size_t k = 0; k < knobs.size(); ++k)
    if (knobs[k].key != kWithout && point.values[k] != knobs[k].base)
      set_option(settings, knobs[k].key, point.values[k]);
  check(settings);
  return settings;
}

Settings finest_settings(const Settings& base, const std::vector<Knob>& knobs) {
  Settings settings = base;
  for (const Knob& knob : knobs) {
    // More of what is counted is finer.
    if (!knob.ordered || setting(knob.key).kind != Setting::Kind::Count) continue;
    std::string most = knob.base;
    for (const std::string& value : knob.values)
      if (std::stod(value) > std::stod(most)) most = value;
    set_option(settings, knob.key, most);
  }
  for (Side* side : {&settings.grid, &settings.map}) *side = std::min(2 * side->count, setting("map").most());
  return settings;
}

}  // namespace caustics::study
