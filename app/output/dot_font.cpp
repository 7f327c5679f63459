#include "app/output/dot_font.hpp"

#include <algorithm>
#include <array>

namespace caustics::app {

namespace {

// Row by row from the top.
struct Glyph {
  char character;
  std::array<const char*, kDotRows> rows;
};
constexpr Glyph kFont[] = {
    {'0', {"###", "# #", "# #", "# #", "###"}}, {'1', {" # ", "## ", " # ", " # ", "###"}},
    {'2', {"###", "  #", "###", "#  ", "###"}}, {'3', {"###", "  #", " ##", "  #", "###"}},
    {'4', {"# #", "# #", "###", "  #", "  #"}}, {'5', {"###", "#  ", "###", "  #", "###"}},
    {'6', {"###", "#  ", "###", "# #", "###"}}, {'7', {"###", "  #", "  #", "  #", "  #"}},
    {'8', {"###", "# #", "###", "# #", "###"}}, {'9', {"###", "# #", "###", "  #", "###"}},
    {'.', {"   ", "   ", "   ", "   ", " # "}}, {'-', {"   ", "   ", "###", "   ", "   "}},
    {'_', {"   ", "   ", "   ", "   ", "###"}}, {'[', {"## ", "#  ", "#  ", "#  ", "## "}},
    {']', {" ##", "  #", "  #", "  #", " ##"}}, {'/', {"  #", "  #", " # ", "#  ", "#  "}},
    {'A', {" # ", "# #", "###", "# #", "# #"}}, {'B', {"## ", "# #", "## ", "# #", "## "}},
    {'C', {" ##", "#  ", "#  ", "#  ", " ##"}}, {'D', {"## ", "# #", "# #", "# #", "## "}},
    {'E', {"###", "#  ", "## ", "#  ", "###"}}, {'F', {"###", "#  ", "## ", "#  ", "#  "}},
    {'G', {" ##", "#  ", "# #", "# #", " ##"}}, {'H', {"# #", "# #", "###", "# #", "# #"}},
    {'I', {"###", " # ", " # ", " # ", "###"}}, {'J', {"  #", "  #", "  #", "# #", " # "}},
    {'K', {"# #", "# #", "## ", "# #", "# #"}}, {'L', {"#  ", "#  ", "#  ", "#  ", "###"}},
    {'M', {"# #", "###", "###", "# #", "# #"}}, {'N', {"## ", "# #", "# #", "# #", "# #"}},
    {'O', {" # ", "# #", "# #", "# #", " # "}}, {'P', {"## ", "# #", "## ", "#  ", "#  "}},
    {'Q', {" # ", "# #", "# #", " # ", "  #"}}, {'R', {"## ", "# #", "## ", "# #", "# #"}},
    {'S', {" ##", "#  ", " # ", "  #", "## "}}, {'T', {"###", " # ", " # ", " # ", " # "}},
    {'U', {"# #", "# #", "# #", "# #", "###"}}, {'V', {"# #", "# #", "# #", "# #", " # "}},
    {'W', {"# #", "# #", "###", "###", "# #"}}, {'X', {"# #", "# #", " # ", "# #", "# #"}},
    {'Y', {"# #", "# #", " # ", " # ", " # "}}, {'Z', {"###", "  #", " # ", "#  ", "###"}},
};

const Glyph* glyph_of(char character) {
  const char capital =
      character >= 'a' && character <= 'z' ? static_cast<char>(character - 'a' + 'A') : character;
  const auto* found = std::find_if(std::begin(kFont), std::end(kFont),
                                   [&](const Glyph& each) { return each.character == capital; });
  return found == std::end(kFont) ? nullptr : found;
}

}  // namespace

int dot_width(std::string_view text) { return static_cast<int>(text.size()) * kDotAdvance - 1; }

void draw_dots(std::string_view text, const std::function<void(int x, int y)>& put) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const Glyph* glyph = glyph_of(text[i]);
    if (!glyph) continue;
    for (int y = 0; y < kDotRows; ++y)
      for (int x = 0; x < 3; ++x)
        if (glyph->rows[static_cast<std::size_t>(y)][x] == '#') put(static_cast<int>(i) * kDotAdvance + x, y);
  }
}

}  // namespace caustics::app
