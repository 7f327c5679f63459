#include "pipeline/scene/gltf/resources.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "pipeline/scene/gltf/compressed.hpp"

namespace caustics::gltf {

namespace {

namespace fs = std::filesystem;
constexpr std::size_t kLongestUri = 4096;

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

// No value where an escape is broken.
std::optional<std::string> percent_decoded(const std::string& text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      decoded += text[i];
      continue;
    }
    const int high = i + 1 < text.size() ? hex_digit(text[i + 1]) : -1;
    const int low = i + 2 < text.size() ? hex_digit(text[i + 2]) : -1;
    if (high < 0 || low < 0) return {};
    decoded += static_cast<char>(high * 16 + low);
    i += 2;
  }
  return decoded;
}

bool has_scheme(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos || colon == 0) return false;
  return std::all_of(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(colon), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '+' ||
           c == '-' || c == '.';
  });
}

bool inside(const fs::path& file, const fs::path& folder) {
  const auto mismatch = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return mismatch.first == folder.end();
}

fs::path folder_of(const Context& context) {
  const fs::path parent = context.path().parent_path();
  return parent.empty() ? fs::path(".") : parent;
}

// The file that a relative URI names, proven to lie in the glTF file's folder.
fs::path confined(const Context& context, const Cursor& uri, const std::string& text) {
  const char* advice = "put the file beside the glTF file and refer to it by its name";
  if (text.empty()) uri.fail("is empty", advice);
  if (text.size() > kLongestUri) uri.fail("is longer than 4096 characters", advice);
  if (has_scheme(text)) uri.fail("only data: URIs and relative files are read: " + text, advice);
  if (context.options().content != nullptr)
    uri.fail("refers to another file, and " + context.path().string() + " has no folder",
             "give a .glb file, which holds all that it needs");
  const std::optional<std::string> decoded = percent_decoded(text);
  if (!decoded) uri.fail("has a broken percent escape", "write % as %25");
  const std::string& name = *decoded;
  if (std::any_of(name.begin(), name.end(),
                  [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '\\'; })) {
    uri.fail("holds a control character or a backslash", advice);
  }
  const fs::path relative = fs::path(name).lexically_normal();
  if (name.front() == '/' || relative.is_absolute() || relative.begin()->string() == "..") {
    uri.fail("leaves the glTF file's folder: " + text, advice);
  }
  std::error_code error;
  const fs::path folder = fs::canonical(folder_of(context), error);
  if (error) uri.fail("the glTF file's folder cannot be read: " + error.message());
  fs::path file = fs::canonical(folder / relative, error);
  if (error) uri.fail("file not found: " + text, "put it beside the glTF file");
  if (!inside(file, folder)) uri.fail("leaves the glTF file's folder by a link: " + text, advice);
  return file;
}

// Six bits of base64, -1: no character of its alphabet.
int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

// Up to the first character that is none of base64's, such as the padding.
Bytes decode_base64(std::string_view text) {
  Bytes bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const int digit = base64_digit(c);
    if (digit < 0) break;
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<std::uint8_t>(bits >> count));
  }
  return bytes;
}

// The media type does not matter here.
Bytes decode_data_uri(const Cursor& uri, const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos || comma < 12 || text.compare(comma - 7, 7, ";base64") != 0) {
    uri.fail("is a data URI that is not base64", "export the file again");
  }
  Bytes bytes = decode_base64(std::string_view(text).substr(comma + 1));
  if (bytes.empty()) uri.fail("is an empty or broken data URI", "export the file again");
  return bytes;
}

Bytes read_buffer(Context& context, const Document& document, std::size_t i) {
  const Cursor buffer = document.root(context).member("buffers").element(i);
  const auto length = static_cast<std::size_t>(
      buffer.member("byteLength").integer(1, static_cast<std::int64_t>(context.options().max_bytes)));
  const Cursor uri = buffer.member("uri");
  Bytes bytes;
  if (uri.present()) {
    bytes = read_uri(context, uri);
  } else if (i == 0 && document.has_bin) {
    context.spend_bytes(document.bin.size(), buffer.path());
    bytes.assign(document.bin.begin(), document.bin.end());
  } else if (is_meshopt_fallback(buffer)) {
    return {};
  } else {
    uri.fail("is missing, and there is no binary chunk for this buffer", "export the file again");
  }
  if (bytes.size() < length) {
    buffer.member("byteLength")
        .fail("is " + std::to_string(length) + ", but there are only " + std::to_string(bytes.size()) +
                  " bytes",
              "the file is damaged or was cut short: get or export it again");
  }
  bytes.resize(length);
  return bytes;
}

void add_uris(const Json& json, std::vector<std::string>& uris) {
  if (json.is_array())
    for (const Json& element : json.as<Json::Array>()) add_uris(element, uris);
  if (!json.is_object()) return;
  for (const JsonMember& member : json.as<Json::Object>()) {
    const bool is_name = member.key == "uri" && member.value.is<std::string>();
    if (is_name) uris.push_back(member.value.as<std::string>());
    add_uris(member.value, uris);
  }
}

}  // namespace

std::vector<fs::path> referred_files(const Context& context, const Document& document) {
  std::vector<fs::path> files;
  if (context.options().content) return files;
  std::vector<std::string> uris;
  add_uris(document.json, uris);
  for (const std::string& uri : uris) {
    if (uri.empty() || uri.size() > kLongestUri || has_scheme(uri)) continue;
    if (const auto name = percent_decoded(uri)) files.push_back(folder_of(context) / *name);
  }
  return files;
}

Bytes read_uri(Context& context, const Cursor& uri) {
  const std::string text = uri.string();
  if (text.compare(0, 5, "data:") != 0) {
    return read_file(context, confined(context, uri, text), uri.path());
  }
  context.spend_bytes(text.size() / 4 * 3, uri.path());
  return decode_data_uri(uri, text);
}

std::vector<Bytes> read_buffers(Context& context, const Document& document, const Used& used) {
  const std::size_t count = document.root(context).member("buffers").size();
  std::vector<Bytes> buffers;
  for (std::size_t i = 0; i < count; ++i)
    buffers.push_back(used.buffers[i] ? read_buffer(context, document, i) : Bytes());
  return buffers;
}

}  // namespace caustics::gltf
