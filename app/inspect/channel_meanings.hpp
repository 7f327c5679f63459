// What single channels of an attachment mean, taken from what its pass says of a texel.
#pragma once
#include <string>
#include <vector>

namespace caustics::app {

struct ChannelMeaning {
  std::string name;     // "x", "r", "value"
  std::string meaning;  // "position of the nearest receiver, scene space"
  std::string unit;     // "metres", or "" for plain numbers
};

// `meaning` as ColorWrite has it: "xyz: where light lands, metres, scene space; w: LandingStatus".
std::vector<ChannelMeaning> channel_meanings(const std::string& meaning, int channels);

}  // namespace caustics::app
