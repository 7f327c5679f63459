// What a scene file is that is no glTF, for the person who named it: a model of another program, a picture,
// a zip archive, a folder.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace caustics::gltf {

struct OtherFormat {
  std::string what;    // "this is a Wavefront OBJ file"
  std::string advice;  // what to do, or where the glTF file is
};

// Told by the first bytes, or else by the extension of the name. None where it may be a glTF file.
std::optional<OtherFormat> other_format(std::string_view head, const std::filesystem::path& name);
// Of a file that is there, or a folder: a folder with one glTF file in it names that. None, too, where the
// file is empty or cannot be read.
std::optional<OtherFormat> other_format(const std::filesystem::path& path);

}  // namespace caustics::gltf
