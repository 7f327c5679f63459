#include "pipeline/gpu/text.hpp"

#include <charconv>
#include <cmath>

namespace caustics {

std::string one_line(std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return line;
}

std::string significant(double value, int digits) {
  char buffer[64];
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, digits).ptr;
  return std::string(buffer, end);
}

std::string duration_text(double milliseconds) {
  if (milliseconds < 1000.0) return significant(milliseconds, milliseconds < 1.0 ? 2 : 3) + " ms";
  const double seconds = milliseconds / 1000.0;
  if (seconds < 60.0) return significant(seconds, 3) + " s";
  const int whole = static_cast<int>(seconds);
  return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
}

std::string bytes_text(double bytes) {
  constexpr const char* kUnits[] = {"B", "KiB", "MiB", "GiB", "TiB"};
  int unit = 0;
  for (; bytes >= 1024.0 && unit < 4; ++unit) bytes /= 1024.0;
  return significant(bytes, bytes >= 1000.0 ? 4 : 3) + " " + kUnits[unit];
}

std::string grouped(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, 1, ',');
  return digits;
}

std::string percent(double share) {
  const double tenths = std::floor(share * 1000.0);
  const std::string text = significant(tenths / 10.0, 4);
  return (text.find('.') == std::string::npos ? text + ".0" : text) + "%";
}

}  // namespace caustics
