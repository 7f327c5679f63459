#include "pipeline/settings/stage.hpp"

#include <array>
#include <vector>

#include "pipeline/settings/setting.hpp"

namespace caustics {

namespace {

constexpr std::string_view kAuto = "auto";
constexpr Setting::Range kHeights{-1e9, 1e9}, kAzimuths{-360, 360}, kElevations{-90, 90}, kLuxes{0, 1e9};

std::vector<std::string_view> parts(std::string_view text) {
  std::vector<std::string_view> result;
  for (std::size_t comma; (comma = text.find(',')) != std::string_view::npos; text.remove_prefix(comma + 1))
    result.push_back(text.substr(0, comma));
  result.push_back(text);
  return result;
}

bool parse_bearing(std::string_view azimuth, std::string_view elevation, Bearing& bearing) {
  return read_number(kAzimuths, azimuth, bearing.azimuth) &&
         read_number(kElevations, elevation, bearing.elevation);
}

std::string bearing_text(const Bearing& bearing) {
  return number_text(bearing.azimuth) + "," + number_text(bearing.elevation);
}

}  // namespace

std::string text_of(const Ground& ground) {
  switch (ground.wish) {
    case Ground::Wish::Auto:
      return std::string(kAuto);
    case Ground::Wish::On:
      return "on";
    case Ground::Wish::Off:
      return "off";
    case Ground::Wish::At:
      break;
  }
  return number_text(ground.height);
}

std::string text_of(const std::optional<SunWish>& sun) {
  if (!sun) return std::string(kAuto);
  return bearing_text(sun->stands) + (sun->lux ? "," + number_text(*sun->lux) : "");
}

std::string text_of(const std::optional<Bearing>& view) {
  return view ? bearing_text(*view) : std::string(kAuto);
}

bool parse(std::string_view text, Ground& ground) {
  if (text == kAuto) return ground = {}, true;
  if (text == "on") return ground = {Ground::Wish::On}, true;
  if (text == "off") return ground = {Ground::Wish::Off}, true;
  float height = 0.0f;
  if (!read_number(kHeights, text, height)) return false;
  ground = {Ground::Wish::At, height};
  return true;
}

bool parse(std::string_view text, std::optional<SunWish>& sun) {
  if (text == kAuto) return sun.reset(), true;
  const std::vector<std::string_view> numbers = parts(text);
  SunWish wish;
  if (numbers.size() < 2 || numbers.size() > 3 || !parse_bearing(numbers[0], numbers[1], wish.stands))
    return false;
  if (numbers.size() == 3 && !read_number(kLuxes, numbers[2], wish.lux.emplace())) return false;
  sun = wish;
  return true;
}

bool parse(std::string_view text, std::optional<Bearing>& view) {
  if (text == kAuto) return view.reset(), true;
  const std::vector<std::string_view> numbers = parts(text);
  Bearing bearing;
  if (numbers.size() != 2 || !parse_bearing(numbers[0], numbers[1], bearing)) return false;
  view = bearing;
  return true;
}

}  // namespace caustics
