// Settings on the command line: options of their own, and -D for all. What the help says of them is the
// table's (pipeline/settings/setting.hpp); the defaults are what the settings hold when the options are
// added.
#pragma once
#include "app/shell/parser.hpp"
#include "pipeline/settings/setting.hpp"

namespace caustics::app {

// The options write into `settings`, which must outlive the parser.
class SettingOptions {
 public:
  // `given` receives the names of the settings that are set by options of their own or by -D.
  SettingOptions(Parser& parser, Settings& settings, std::vector<std::string>& given)
      : parser_(parser), settings_(settings), given_(given) {}

  // --preview: before all others, which override it.
  void add_preview(bool& wanted);
  // -r: width and height.
  void add_resolution();
  // --preset NAME: likewise.
  void add_preset();
  // The setting's name as an option: --grid N; a flag where it is yes or no.
  void add(std::string_view name);
  // -D KEY=VALUE, after the others, with a list of the keys. It refuses those that have no part here, for
  // this reason.
  void add_any(const std::vector<Setting::Part>& parts, const std::string& why_not = "");

 private:
  Parser& parser_;
  Settings& settings_;
  std::vector<std::string>& given_;
  std::vector<std::string_view> own_;  // settings that have options of their own
};

// The option of a setting: --assume-solid for assume_solid.
std::string option_name(std::string_view name);

// What `digest` and `parity` begin with: small frames.
Settings small_settings();
// "width 320, height 180": where they are not what a setting is by default.
std::string differing(const Settings& settings);

}  // namespace caustics::app
