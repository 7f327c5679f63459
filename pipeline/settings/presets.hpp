// Presets: values of settings under one name. What is set after a preset overrides it.
#pragma once
#include <span>
#include <string_view>

namespace caustics {

struct Settings;

struct PresetValue {
  std::string_view setting, value;  // as set_option takes them
};

struct Preset {
  std::string_view name;
  std::string_view meaning;  // a phrase in plain text
  std::span<const PresetValue> values;
};

std::span<const Preset> all_presets();
// Of an option of its own: a picture in about 100 ms on two cores.
const Preset& preview();
void apply(Settings& settings, const Preset& preset);
// Throws Error (WrongUsage) naming the presets where there is none of the name.
void apply_preset(Settings& settings, std::string_view name);

}  // namespace caustics
