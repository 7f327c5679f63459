// Numbers and names as messages, reports and pages show them, the same in every locale.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace caustics {

// The text as a terminal or a page may show it, on one line. Control characters (C0, DEL, C1), line and
// paragraph separators, marks that turn the direction of writing, and bytes that are no UTF-8 are shown as
// escapes such as \x1b and \u202e, so that a name from a file cannot move the cursor, add a line or reverse
// what follows. What is longer than `most` bytes is cut between two characters and ends in "...".
std::string one_line(std::string_view text, std::size_t most = std::string_view::npos);
// What somebody typed, as a message quotes it: on one line, and cut where it is long.
std::string in_quotes(std::string_view text);

// "12 ms", "3.4 s", "2 min 5 s".
std::string duration_text(double milliseconds);
// "512 B", "18.4 MiB".
std::string bytes_text(double bytes);
// 1234567 -> "1,234,567".
std::string grouped(std::uint64_t number);
// The number rounded to so many digits, as people write it: 100 and 123000 rather than 1e+02 and 1.23e+05.
// Only what is below 0.0001 or from 1e15 on has an exponent.
std::string significant(double value, int digits);
// "82.1%", "1234.5%": rounded down, so never up to 100.0%.
std::string percent(double share);
// "a/B.EXR" -> ".exr": ASCII letters alone change.
std::string lower_extension(const std::filesystem::path& path);

}  // namespace caustics
