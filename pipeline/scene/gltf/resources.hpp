// What a glTF file refers to by URI: data URIs, and files that must lie in the glTF file's own
// folder. Source: glTF 2.0 section 2.8.
#pragma once
#include <vector>

#include "pipeline/scene/gltf/used.hpp"

namespace caustics::gltf {

// The bytes behind a URI. Refused are other schemes than data:, absolute paths, paths that leave
// the glTF file's folder (also percent-encoded, and through symbolic links), and what is no regular
// file.
Bytes read_uri(Context& context, const Cursor& uri);

// The files under the folder of the glTF file that any "uri" of the document names, used or not, there or
// not.
std::vector<std::filesystem::path> referred_files(const Context& context, const Document& document);

// The contents of all buffers, each exactly byteLength long, or empty: is_meshopt_fallback, or unused. A
// GLB's binary chunk is the first one.
std::vector<Bytes> read_buffers(Context& context, const Document& document, const Used& used);

}  // namespace caustics::gltf
