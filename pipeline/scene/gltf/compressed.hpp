// Geometry that a file holds in compressed form, unpacked into buffers of the model before anything is built
// from it. Sources: EXT_meshopt_compression, KHR_draco_mesh_compression.
//
// The data are not trusted: sizes are checked before the decoders see them, memory for what is unpacked is
// spent from the budget of bytes, and what decoders make of damaged data is checked like any other file's.
#pragma once
#include <string_view>

#include "pipeline/scene/gltf/context.hpp"
#include "pipeline/scene/gltf/model.hpp"

namespace caustics::gltf {

inline constexpr const char* kMeshopt = "EXT_meshopt_compression";
inline constexpr const char* kDraco = "KHR_draco_mesh_compression";

bool has_meshopt_decoder();
bool has_draco_decoder();

// Says which decoder this build lacks, and what to do.
[[noreturn]] void fail_without_decoder(const Cursor& where, std::string_view extension);

// A buffer that need not be there, because its views have compressed data in another.
bool is_meshopt_fallback(const Cursor& buffer);

// Used views with meshopt data get the buffers that those unpack to.
void unpack_views(Context& context, const Document& document, const Used& used, Model& model);
// Primitives whose accessors are empty shells get those of their Draco data.
void unpack_primitives(Context& context, const Document& document, Model& model);

// The filters of EXT_meshopt_compression: `data` holds elements of `stride` bytes, 4 or 8 (octahedral), 8
// (quaternion), or a multiple of 4 (exponential). Written here, since the library's differ between
// processors.
void decode_octahedral(Bytes& data, std::size_t stride);
void decode_quaternion(Bytes& data);
void decode_exponential(Bytes& data);

}  // namespace caustics::gltf
