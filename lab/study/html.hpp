// Small pieces of HTML and SVG.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace caustics::study {

// The text with & < > " ' as entities and without control characters.
std::string escaped(std::string_view text);
// RFC 4648, section 4.
std::string base64(const std::string& bytes);
// A PNG file as a data: address, "" where it cannot be read.
std::string png_address(const std::filesystem::path& file);
// A coordinate or length: two digits behind the point, the same in every locale.
std::string length_text(double value);

}  // namespace caustics::study
