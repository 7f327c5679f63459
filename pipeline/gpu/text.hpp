// Numbers and names as messages, reports and pages show them, the same in every locale.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace caustics {

// The text without control characters, so that file names and messages stay on one line.
std::string one_line(std::string_view text);

// "12 ms", "3.4 s", "2 min 5 s".
std::string duration_text(double milliseconds);
// "512 B", "18.4 MiB".
std::string bytes_text(double bytes);
// 1234567 -> "1,234,567".
std::string grouped(std::uint64_t number);
// printf's %.*g.
std::string significant(double value, int digits);
// "82.1%", never rounded up to 100.0%.
std::string percent(double share);

}  // namespace caustics
