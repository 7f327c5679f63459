#include "app/shell/setting_options.hpp"

#include <algorithm>

#include "pipeline/gpu/text.hpp"
#include "pipeline/settings/presets.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics::app {

namespace {

bool has(const std::vector<Setting::Part>& parts, const Setting& row) {
  return std::find(parts.begin(), parts.end(), row.part) != parts.end();
}

std::string placeholder(const Setting& row) {
  if (row.is_number()) return row.kind == Setting::Kind::Count ? "N" : "X";
  return row.kind == Setting::Kind::Text && row.unset.empty() ? "VALUE" : "NAME";
}

About about(const Setting& row, const Settings& settings) {
  return {std::string(row.meaning), row.range(), row.shown(settings)};
}

// ", grid=128 iterations=3"
std::string values_text(const Preset& preset) {
  std::string text;
  for (const PresetValue& each : preset.values)
    text.append(text.empty() ? ", " : " ").append(each.setting).append("=").append(each.value);
  return text;
}

// -D's KEY=VALUE, whose key is returned; `why_not` is said of keys that have no part here.
std::string assign(Settings& settings, const std::string& assignment, const std::vector<Setting::Part>& parts,
                   const std::string& why_not) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos)
    throw Error(ExitCode::WrongUsage,
                "-D cannot be " + in_quotes(assignment) + ": key=value, as in reflections=yes");
  std::string key = assignment.substr(0, equals);
  set_option(settings, key, assignment.substr(equals + 1));
  if (!has(parts, setting(key))) throw Error(ExitCode::WrongUsage, "-D " + key + " " + why_not);
  return key;
}

}  // namespace

std::string option_name(std::string_view name) {
  std::string option = "--" + std::string(name);
  std::replace(option.begin(), option.end(), '_', '-');
  return option;
}

void SettingOptions::add_preview(bool& wanted) {
  parser_.flag("--preview",
               std::string(preview().meaning) + values_text(preview()) + "; no error is estimated",
               [&wanted, &settings = settings_] {
                 wanted = true;
                 apply(settings, preview());
               });
}

void SettingOptions::add_resolution() {
  const Setting &width = setting("width"), &height = setting("height");
  const About about{"size of the picture", width.range() + " each",
                    width.shown(settings_) + "x" + height.shown(settings_)};
  parser_.option("-r,--resolution", "WxH", about, [&settings = settings_, &width](const std::string& value) {
    const Pair size = parse_pair("-r", value, {static_cast<int>(width.numbers.least), width.most()});
    settings.width = size.first;
    settings.height = size.second;
  });
  own_.push_back(width.name);
  own_.push_back(height.name);
}

void SettingOptions::add_preset() {
  std::string names;
  std::string meaning;
  for (const Preset& preset : all_presets()) {
    names += (names.empty() ? "" : "|") + std::string(preset.name);
    meaning += (meaning.empty() ? "" : "; ") + std::string(preset.name) + ": " + std::string(preset.meaning) +
               values_text(preset);
  }
  parser_.option(
      "--preset", "NAME",
      {"values of settings under one name, which other options override. " + meaning, names, "none"},
      [&settings = settings_](const std::string& name) { apply_preset(settings, name); });
}

void SettingOptions::add(std::string_view name) {
  const Setting& row = setting(name);
  const std::string option = option_name(name);
  if (row.kind == Setting::Kind::YesNo) {
    parser_.flag(option, std::string(row.meaning), [&row, &settings = settings_, &given = given_] {
      row.set(row, settings, row.choices().back());
      given.emplace_back(row.name);
    });
  } else {
    parser_.option(option, placeholder(row), about(row, settings_),
                   [name, &settings = settings_, &given = given_](const std::string& value) {
                     set_option(settings, name, value);
                     given.emplace_back(name);
                   });
  }
  own_.push_back(name);
}

void SettingOptions::add_any(const std::vector<Setting::Part>& parts, const std::string& why_not) {
  std::string own;
  for (const Setting& row : all_settings()) {
    const auto same = [&](std::string_view name) { return name == row.name; };
    if (!has(parts, row)) continue;
    if (std::none_of(own_.begin(), own_.end(), same)) {
      parser_.list("Settings for -D", std::string(row.name), about(row, settings_));
    } else {
      own += (own.empty() ? "" : ", ") + std::string(row.name);
    }
  }
  parser_.repeated("-D", "KEY=VALUE",
                   {"a setting: one of those listed below, or " + own + " as above; may stand several times"},
                   [&settings = settings_, &given = given_, parts, why_not](const std::string& value) {
                     given.push_back(assign(settings, value, parts, why_not));
                   });
}

Settings small_settings() {
  Settings settings;
  settings.width = 320;
  settings.height = 180;
  settings.grid = settings.map = 128;
  settings.shadow = 512;
  return settings;
}

std::string differing(const Settings& settings) {
  std::string text;
  for (const Setting& row : all_settings()) {
    if (row.get(settings) == row.get(Settings{})) continue;
    text += (text.empty() ? "" : ", ") + std::string(row.name) + " " + row.get(settings);
  }
  return text;
}

}  // namespace caustics::app
