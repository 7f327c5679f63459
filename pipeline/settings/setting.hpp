// A row of the table of settings: all that is known of one. The command line, its help, docs/command_line.md,
// --stats and the study read it.
#pragma once
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace caustics {

struct Settings;

struct Setting {
  enum class Kind : std::uint8_t { Count, Real, Choice, YesNo, Text };
  enum class Part : std::uint8_t {
    View,     // what is seen
    Picture,  // how it is shown
    Light,    // what light does, in any renderer
    Maps,     // how this one follows it
  };
  // Of a number. `also` are numbers below `least` that are allowed too, 0 for none.
  struct Range {
    double least = 0.0, most = 0.0;
    std::string_view unit = {};
    std::array<int, 2> also = {};
  };

  std::string_view name;  // the key of -D
  Kind kind;
  Part part;
  std::string_view meaning;  // a phrase in plain text
  // The value as text, which `set` reads back as the same.
  std::string (*get)(const Settings& settings);
  // False, and nothing is changed, where the text is no value within the range.
  bool (*set)(const Setting& row, Settings& settings, std::string_view text);
  Range numbers = {};                                    // of a Count or Real
  std::vector<std::string_view> (*choices)() = nullptr;  // of a Choice or YesNo
  std::string_view takes = {};                           // of a Text: what it may be
  std::string_view unset = {};                           // what it is when there is no value: "auto"

  // "1..16384 pixels", "point|gaussian|cell".
  std::string range() const;
  // `get` for people: what an empty text stands for is named.
  std::string shown(const Settings& settings) const;
  bool is_number() const { return kind == Kind::Count || kind == Kind::Real; }
  int most() const { return static_cast<int>(numbers.most); }
};

std::span<const Setting> all_settings();
std::vector<Setting::Part> all_parts();
// Throws Error (WrongUsage) naming the nearest of an unknown one.
const Setting& setting(std::string_view name);

// The shortest text that is read back as the same number.
std::string number_text(int value);
std::string number_text(float value);
std::string number_text(double value);
// The whole text must be a number within the range; nothing is rounded or cut off silently.
bool read_number(const Setting::Range& range, std::string_view text, int& result);
bool read_number(const Setting::Range& range, std::string_view text, float& result);
bool read_number(const Setting::Range& range, std::string_view text, double& result);

}  // namespace caustics
