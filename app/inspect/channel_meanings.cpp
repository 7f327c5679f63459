#include "app/inspect/channel_meanings.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace caustics::app {

namespace {

constexpr std::array<std::string_view, 7> kUnits = {"square metres", "metres", "lux",   "nit",
                                                    "radians",       "texels", "pixels"};

std::vector<std::string> split(const std::string& text, const std::string& by) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  for (std::size_t at; (at = text.find(by, from)) != std::string::npos; from = at + by.size())
    parts.push_back(text.substr(from, at - from));
  parts.push_back(text.substr(from));
  return parts;
}

// "where light lands, metres, scene space" without its unit.
ChannelMeaning meaning_of(char name, const std::string& text) {
  ChannelMeaning channel{std::string(1, name), {}, {}};
  for (const std::string& part : split(text, ", ")) {
    if (channel.unit.empty() && std::find(kUnits.begin(), kUnits.end(), part) != kUnits.end())
      channel.unit = part;
    else
      channel.meaning += (channel.meaning.empty() ? "" : ", ") + part;
  }
  return channel;
}

// "xyz" of "xyz: ..."; "" where no channels are named.
std::string named_channels(const std::string& part) {
  const std::size_t colon = part.find(": ");
  if (colon == std::string::npos || colon > 4) return {};
  const std::string names = part.substr(0, colon);
  return names.find_first_not_of("xyzwrgba") == std::string::npos ? names : std::string();
}

}  // namespace

std::vector<ChannelMeaning> channel_meanings(const std::string& meaning, int channels) {
  std::vector<ChannelMeaning> result;
  for (const std::string& part : split(meaning, "; ")) {
    const std::string names = named_channels(part);
    const std::string text = names.empty() ? part : part.substr(names.size() + 2);
    for (const char name : names) result.push_back(meaning_of(name, text));
    if (names.empty() && result.empty()) result.push_back(meaning_of('v', text));
  }
  const std::string others = channels == 1 ? "v" : "xyzw";
  const ChannelMeaning whole = result.empty() ? ChannelMeaning{} : result.front();
  while (static_cast<int>(result.size()) < channels) {
    // What is said of the first channel alone holds for all.
    result.push_back(whole.name == "v" ? whole : ChannelMeaning{{}, "not used", {}});
    result.back().name = others.substr(std::min(result.size() - 1, others.size() - 1), 1);
  }
  result.resize(static_cast<std::size_t>(channels));
  if (channels == 1) result.front().name = "value";
  return result;
}

}  // namespace caustics::app
