// Letters of 3 x 5 dots, for the few words that a picture bears.
#pragma once
#include <functional>
#include <string_view>

namespace caustics::app {

inline constexpr int kDotRows = 5;
// Dots from one character to the next.
inline constexpr int kDotAdvance = 4;

// Dots from the first to the last.
int dot_width(std::string_view text);

// Calls `put` for each dot that is set, counted from the text's left and top. Small letters look like
// capitals; characters that it does not know are blanks.
void draw_dots(std::string_view text, const std::function<void(int x, int y)>& put);

}  // namespace caustics::app
