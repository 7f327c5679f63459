#include "pipeline/settings/setting.hpp"

#include <algorithm>
#include <charconv>
#include <type_traits>

#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/text.hpp"
#include "pipeline/settings/nearest.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

namespace {

template <class T>
std::string shortest(T value) {
  char buffer[64];
  std::string text(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
  // As people write it: 1e6, not 1e+06.
  if (const std::size_t e = text.find('e'); e != std::string::npos)
    text.replace(e + 1, std::string::npos, std::to_string(std::stoi(text.substr(e + 1))));
  return text;
}

template <class T>
bool read(const Setting::Range& range, std::string_view text, T& result) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return false;
  bool inside = value >= static_cast<T>(range.least) && value <= static_cast<T>(range.most);
  if constexpr (std::is_integral_v<T>) {
    const auto& also = range.also;
    inside |= value != 0 && std::find(also.begin(), also.end(), value) != also.end();
  }
  if (inside) result = value;
  return inside;
}

// "1, 3 or 8..64", "auto or -40..40 EV".
std::string number_range(const Setting& row) {
  std::string before;
  const auto add = [&](const std::string& other) { before += (before.empty() ? "" : ", ") + other; };
  if (!row.unset.empty()) add(std::string(row.unset));
  for (const int other : row.numbers.also)
    if (other != 0) add(number_text(other));
  if (!before.empty()) before += " or ";
  const std::string unit = row.numbers.unit.empty() ? "" : " " + std::string(row.numbers.unit);
  return before + number_text(row.numbers.least) + ".." + number_text(row.numbers.most) + unit;
}

}  // namespace

std::string number_text(int value) { return shortest(value); }
std::string number_text(float value) { return shortest(value); }
std::string number_text(double value) { return shortest(value); }

bool read_number(const Setting::Range& range, std::string_view text, int& result) {
  return read(range, text, result);
}
bool read_number(const Setting::Range& range, std::string_view text, float& result) {
  return read(range, text, result);
}
bool read_number(const Setting::Range& range, std::string_view text, double& result) {
  return read(range, text, result);
}

std::string Setting::range() const {
  if (is_number()) return number_range(*this);
  if (kind == Kind::Text) return std::string(takes);
  std::string text;
  for (const std::string_view name : choices()) text += (text.empty() ? "" : "|") + std::string(name);
  return text;
}

std::string Setting::shown(const Settings& settings) const {
  std::string value = get(settings);
  return value.empty() ? std::string(unset) : value;
}

std::vector<Setting::Part> all_parts() {
  return {Setting::Part::View, Setting::Part::Picture, Setting::Part::Light, Setting::Part::Maps};
}

const Setting& setting(std::string_view name) {
  const auto rows = all_settings();
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const Setting& row) { return row.name == name; });
  if (found != rows.end()) return *found;
  std::vector<std::string> names;
  for (const Setting& row : rows) names.emplace_back(row.name);
  throw Error(ExitCode::WrongUsage,
              "unknown key " + in_quotes(name) + suggestion(name, names, "see 'caustics render --help'"));
}

void set_option(Settings& settings, std::string_view key, std::string_view value) {
  const Setting& row = setting(key);
  if (row.set(row, settings, value)) return;
  throw Error(ExitCode::WrongUsage, std::string(key) + " cannot be " + in_quotes(value) + ": " + row.range() +
                                        ", default " + row.shown(Settings{}));
}

void check_ranges(const Settings& settings) {
  Settings copy = settings;
  for (const Setting& row : all_settings()) {
    const std::string value = row.get(settings);
    if (row.set(row, copy, value)) continue;
    throw Error(ExitCode::WrongUsage, std::string(row.name) + " is " + value + ", must be " + row.range());
  }
}

}  // namespace caustics
