#include "pipeline/gpu/text.hpp"

#include <charconv>
#include <cmath>
#include <optional>

namespace caustics {

namespace {

// The character at the head of `text`, and how many bytes it takes; no value where they are no UTF-8.
struct Character {
  char32_t code = 0;
  std::size_t bytes = 0;
};

std::optional<Character> first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (byte(0) < 0x80) return Character{byte(0), 1};
  const std::size_t bytes = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
  if (byte(0) < 0xC2 || byte(0) > 0xF4 || text.size() < bytes) return {};
  char32_t code = byte(0) & (0x7Fu >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xC0u) != 0x80u) return {};
    code = code << 6 | (byte(i) & 0x3Fu);
  }
  // Neither longer than need be, nor half of a UTF-16 pair, nor beyond Unicode.
  constexpr char32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  if (code < kLeast[bytes] || (code >= 0xD800 && code <= 0xDFFF) || code > 0x10FFFF) return {};
  return Character{code, bytes};
}

// May it not be shown as it is? Source: Unicode 15, sections 23.1 and 23.2, and UAX 9.
bool is_hidden(char32_t code) {
  const auto within = [&](char32_t first, char32_t last) { return code >= first && code <= last; };
  return code < 0x20 || within(0x7F, 0x9F) || code == 0x061C || within(0x200B, 0x200F) ||
         within(0x2028, 0x202E) || within(0x2060, 0x206F) || code == 0xFEFF || within(0xFFF9, 0xFFFB) ||
         within(0xE0000, 0xE007F);
}

std::string escape(char letter, char32_t code, int digits) {
  std::string text{'\\', letter};
  for (int digit = digits - 1; digit >= 0; --digit) text += "0123456789abcdef"[code >> (4 * digit) & 0xFu];
  return text;
}

}  // namespace

std::string one_line(std::string_view text, std::size_t most) {
  std::string line;
  std::size_t fits = 0;  // bytes of `line` after which "..." still has room
  while (!text.empty() && line.size() <= most) {
    const std::optional<Character> character = first_character(text);
    const std::size_t bytes = character ? character->bytes : 1;
    if (!character) {
      line += escape('x', static_cast<unsigned char>(text[0]), 2);
    } else if (!is_hidden(character->code)) {
      line += text.substr(0, bytes);
    } else if (character->code < 0x80) {
      line += escape('x', character->code, 2);
    } else {
      line += character->code < 0x10000 ? escape('u', character->code, 4) : escape('U', character->code, 8);
    }
    text.remove_prefix(bytes);
    if (line.size() + 3 <= most) fits = line.size();
  }
  return line.size() <= most ? line : line.substr(0, fits) + "...";
}

std::string in_quotes(std::string_view text) { return "'" + one_line(text, 80) + "'"; }

std::string significant(double value, int digits) {
  char buffer[64];
  char* end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, digits).ptr;
  std::string text(buffer, end);
  double rounded = 0.0;
  std::from_chars(buffer, end, rounded);
  if (text.find('e') == std::string::npos || std::fabs(rounded) < 1.0 || !(std::fabs(rounded) < 1e15))
    return text;
  end = std::to_chars(buffer, buffer + sizeof buffer, rounded, std::chars_format::fixed, 0).ptr;
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
  const double percents = std::floor(share * 1000.0 + 1e-5) / 10.0;
  if (!(std::fabs(percents) < 1e15)) return significant(percents, 4) + "%";
  char buffer[64];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, percents, std::chars_format::fixed, 1).ptr;
  return std::string(buffer, end) + "%";
}

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return extension;
}

}  // namespace caustics
