#include "pipeline/scene/gltf/container.hpp"

#include <algorithm>
#include <fstream>
#include <string_view>

#include "pipeline/scene/gltf/other_format.hpp"

namespace caustics::gltf {

namespace {

constexpr std::uint32_t kMagic = 0x46546C67;      // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t kBinChunk = 0x004E4942;   // "BIN"
const char* kDamaged = "the file is damaged or was cut short: get or export it again";

std::uint32_t little_endian(const Bytes& bytes, std::size_t at) {
  return bytes[at] | bytes[at + 1] << 8 | bytes[at + 2] << 16 |
         static_cast<std::uint32_t>(bytes[at + 3]) << 24;
}

bool is_glb(const Bytes& bytes) { return bytes.size() >= 4 && little_endian(bytes, 0) == kMagic; }

struct Chunks {
  std::string_view json;
  std::span<const std::uint8_t> bin;
  bool has_bin = false;
};

std::uint64_t checked_length(Context& context, const Bytes& bytes) {
  if (bytes.size() < 20) context.fail("", "is too short for a .glb file", kDamaged);
  const std::uint32_t version = little_endian(bytes, 4);
  if (version != 2) {
    context.fail("", "is a .glb of version " + std::to_string(version) + ", only 2 can be read",
                 "export it as glTF 2.0");
  }
  const std::uint64_t length = little_endian(bytes, 8);
  if (length > bytes.size()) {
    context.fail("",
                 "the .glb header says " + std::to_string(length) + " bytes, the file has " +
                     std::to_string(bytes.size()),
                 kDamaged);
  }
  if (length < bytes.size()) context.note("Bytes after the end of the .glb are ignored.");
  return length;
}

Chunks split_glb(Context& context, const Bytes& bytes) {
  const std::uint64_t length = checked_length(context, bytes);
  Chunks chunks;
  std::uint64_t at = 12;
  for (int number = 0; at < length; ++number) {
    const std::string where = "GLB chunk " + std::to_string(number);
    if (length - at < 8) context.fail(where, "has no room for its header", kDamaged);
    const std::uint64_t size = little_endian(bytes, at);
    const std::uint32_t type = little_endian(bytes, at + 4);
    at += 8;
    if (size > length - at) context.fail(where, "is longer than the file", kDamaged);
    if (number == 0 && type != kJsonChunk) context.fail(where, "must be the JSON", kDamaged);
    if (number > 0 && type == kJsonChunk) context.fail(where, "is a second JSON chunk", kDamaged);
    if (number == 0)
      chunks.json = {reinterpret_cast<const char*>(bytes.data() + at), static_cast<std::size_t>(size)};
    if (number == 1 && type == kBinChunk) {
      chunks.bin = {bytes.data() + at, static_cast<std::size_t>(size)};
      chunks.has_bin = true;
    }
    at += size;
  }
  if (chunks.json.empty()) context.fail("", "the .glb has no JSON", kDamaged);
  return chunks;
}

// Bounds what parsing can cost before it starts: brackets and commas outside strings give the depth
// and a bound on the number of values.
void check_json_size(Context& context, std::string_view text) {
  std::uint64_t values = 1;
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
      continue;
    }
    if (c == '"') in_string = true;
    if (c == '{' || c == '[') ++depth;
    if (c == '}' || c == ']') --depth;
    if (c == '{' || c == '[' || c == ',') ++values;
    if (depth > context.options().max_json_depth) {
      context.fail(
          "",
          "the JSON is nested deeper than " + std::to_string(context.options().max_json_depth) + " levels",
          "no sensible exporter writes such a file");
    }
  }
  if (values > context.options().max_json_values) {
    context.fail("",
                 "the JSON has more than " + std::to_string(context.options().max_json_values) + " values",
                 "split the scene");
  }
}

Json parse(Context& context, std::string_view text) {
  check_json_size(context, text);
  std::string problem;
  Json json = parse_json(text, problem);
  if (problem.empty() && !json.is_object()) problem = "the JSON must be an object";
  if (!problem.empty()) context.fail("", "is not a glTF file: " + problem, kDamaged);
  return json;
}

}  // namespace

Bytes read_file(Context& context, const std::filesystem::path& path, const std::string& where) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) {
    context.fail(where, where.empty() ? "no such file" : "file not found: " + path.string(),
                 where.empty() ? "check the name" : "put it beside the glTF file");
  }
  if (!std::filesystem::is_regular_file(status)) context.fail(where, "is not a regular file");
  const std::uint64_t size = std::filesystem::file_size(path, error);
  if (error) context.fail(where, "cannot be read: " + error.message());
  context.spend_bytes(size, where);
  std::ifstream file(path, std::ios::binary);
  Bytes bytes(static_cast<std::size_t>(size));
  if (!file || !file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size))) {
    context.fail(where, "cannot be read", "check the file's permissions");
  }
  return bytes;
}

namespace {

// The bytes that the document is read from; what is known to be no glTF is refused before it is read whole.
Bytes read_scene(Context& context) {
  const auto& content = context.options().content;
  std::optional<OtherFormat> other;
  if (content) {
    const std::size_t head = std::min<std::size_t>(content->size(), 1024);
    other = other_format({reinterpret_cast<const char*>(content->data()), head}, "");
  } else {
    other = other_format(context.path());
  }
  if (other) context.fail("", other->what, other->advice);
  if (!content) return read_file(context, context.path(), "");
  context.spend_bytes(content->size(), "");
  return *content;
}

}  // namespace

Document read_document(Context& context) {
  Document document;
  document.bytes = read_scene(context);
  if (document.bytes.empty()) context.fail("", "is empty", "name a .gltf or .glb file");
  std::string_view text(reinterpret_cast<const char*>(document.bytes.data()), document.bytes.size());
  if (is_glb(document.bytes)) {
    const Chunks chunks = split_glb(context, document.bytes);
    text = chunks.json;
    document.bin = chunks.bin;
    document.has_bin = chunks.has_bin;
  }
  document.json = parse(context, text);
  return document;
}

}  // namespace caustics::gltf
