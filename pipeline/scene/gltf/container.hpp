// The outer shell of a glTF file: reading it, splitting a .glb into its chunks, parsing the JSON.
// Source: glTF 2.0 sections 4 (GLB) and 2.7 (JSON encoding).
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/scene/gltf/cursor.hpp"

namespace caustics::gltf {

using Bytes = std::vector<std::uint8_t>;

struct Document {
  Bytes bytes;                        // the whole file
  std::span<const std::uint8_t> bin;  // the GLB's binary chunk, inside `bytes`
  bool has_bin = false;
  Json json;

  Cursor root(const Context& context) const { return {context, &json, ""}; }
};

// Reads a regular file of at most the bytes that are left in the context's budget. `where` is the
// JSON path that refers to it, for messages.
Bytes read_file(Context& context, const std::filesystem::path& path, const std::string& where);

Document read_document(Context& context);

}  // namespace caustics::gltf
