// Talk: everything that is not data goes to stderr through here.
#pragma once
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

namespace caustics::app {

// Is this stream a terminal that a person watches?
bool is_terminal(std::FILE* stream);
// Colours only there, and not under NO_COLOR or TERM=dumb.
bool has_colour(std::FILE* stream);

// The text without control characters, so that file names and messages stay on one line.
std::string one_line(std::string_view text);

// "caustics: LINE" on stderr.
void complain(std::string_view line);

// "12 ms", "3.4 s", "2 min 5 s".
std::string duration_text(double milliseconds);
// "512 B", "18.4 MiB".
std::string bytes_text(double bytes);
// 1234567 -> "1,234,567".
std::string grouped(std::uint64_t number);
// printf's %.*g, the same in every locale.
std::string significant(double value, int digits);
// "82.1%", never rounded up to 100.0%.
std::string percent(double share);

}  // namespace caustics::app
