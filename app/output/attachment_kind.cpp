#include "app/output/attachment_kind.hpp"

#include <algorithm>
#include <initializer_list>

namespace caustics::app {

namespace {

bool has(std::string_view text, std::string_view word) { return text.find(word) != text.npos; }

// What is said of the first channels: "xyz: unit normal" of "xyz: unit normal; w: depth, metres".
std::string_view first_part(std::string_view meaning) {
  for (const std::string_view next : {"; w:", "; a:", "; g:", "; z:", "; y, z:"})
    meaning = meaning.substr(0, meaning.find(next));
  return meaning;
}

// The first row of which a word occurs decides.
struct WordsOfKind {
  AttachmentKind kind;
  std::initializer_list<std::string_view> words;
};
const WordsOfKind kWords[] = {
    {AttachmentKind::Display, {"sRGB"}},
    {AttachmentKind::Normal, {"unit shading normal", "unit normal", "unit direction", "direction, unit"}},
    {AttachmentKind::Flux, {"flux"}},
    {AttachmentKind::Radiance, {"radiance"}},
    {AttachmentKind::Color, {"albedo", "0..1"}},
    {AttachmentKind::Depth, {"depth", "distance of"}},
    {AttachmentKind::Position, {"scene space", "places"}},
};

}  // namespace

std::string_view name_of(AttachmentKind kind) {
  constexpr std::string_view kNames[] = {"position", "normal", "flux",    "depth",
                                         "radiance", "color",  "display", "scalar"};
  return kNames[static_cast<std::size_t>(kind)];
}

AttachmentKind kind_of(Format format, std::string_view meaning) {
  if (is_depth(format)) return AttachmentKind::Depth;
  const std::string_view part = first_part(meaning);
  for (const WordsOfKind& row : kWords)
    if (std::any_of(row.words.begin(), row.words.end(),
                    [&](std::string_view word) { return has(part, word); }))
      return row.kind;
  return AttachmentKind::Scalar;
}

int status_channel_of(std::string_view meaning) {
  const auto at = meaning.find(": LandingStatus");
  if (at == meaning.npos || at == 0) return -1;
  const auto channel = std::string_view("xyzw").find(meaning[at - 1]);
  return channel == std::string_view::npos ? -1 : static_cast<int>(channel);
}

}  // namespace caustics::app
