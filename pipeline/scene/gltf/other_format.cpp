#include "pipeline/scene/gltf/other_format.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>
#include <vector>

#include "pipeline/gpu/text.hpp"

namespace caustics::gltf {

namespace {

namespace fs = std::filesystem;

enum class Family { Model, Blend, Picture, Radiance, Archive };

struct KnownFormat {
  std::string_view name;
  Family family;
  std::vector<std::string_view> magic;  // how such files begin; none: by the extension alone
  std::vector<std::string_view> extensions;
};

const std::vector<KnownFormat>& formats() {
  using namespace std::literals;
  static const std::vector<KnownFormat> list = {
      {"a Wavefront OBJ file", Family::Model, {}, {".obj"}},
      {"a PLY file", Family::Model, {"ply\n", "ply\r"}, {".ply"}},
      {"an STL file", Family::Model, {"solid "}, {".stl"}},
      {"an FBX file", Family::Model, {"Kaydara FBX Binary", "; FBX "}, {".fbx"}},
      {"a USD file", Family::Model, {"PXR-USDC", "#usda "}, {".usd", ".usda", ".usdc", ".usdz"}},
      {"a 3D Studio file", Family::Model, {}, {".3ds"}},
      {"a COLLADA file", Family::Model, {}, {".dae"}},
      {"a Blender file", Family::Blend, {"BLENDER"}, {".blend"}},
      {"a PNG picture", Family::Picture, {"\x89PNG"}, {".png"}},
      {"a JPEG picture", Family::Picture, {"\xff\xd8\xff"}, {".jpg", ".jpeg"}},
      {"a TIFF picture", Family::Picture, {"II*\0"sv, "MM\0*"sv}, {".tif", ".tiff"}},
      {"a Radiance HDR picture", Family::Radiance, {"#?RADIANCE", "#?RGBE"}, {".hdr"}},
      {"an OpenEXR picture", Family::Radiance, {"\x76\x2f\x31\x01"}, {".exr"}},
      {"a zip archive", Family::Archive, {"PK\3\4", "PK\5\6"}, {".zip"}},
  };
  return list;
}

std::string advice_for(Family family) {
  std::string reads = "caustics reads glTF 2.0 (.glb, .gltf): ";
  switch (family) {
    case Family::Model:
      return reads + "convert it with Blender: File > Import, then File > Export > glTF 2.0";
    case Family::Blend:
      return reads + "open it in Blender: File > Export > glTF 2.0";
    case Family::Picture:
      return reads + "name the scene, and -o for the picture to write";
    case Family::Radiance:
      return reads + "name the scene, and this picture with --environment to light it";
    case Family::Archive:
      return reads + "unpack it and name the glTF file in it";
  }
  return reads;
}

bool is_gltf_name(const fs::path& path) {
  const std::string extension = lower_extension(path);
  return extension == ".glb" || extension == ".gltf";
}

OtherFormat folder(const fs::path& path) {
  std::vector<fs::path> scenes;
  std::error_code error;
  for (fs::directory_iterator entry(path, error), end; !error && entry != end; entry.increment(error))
    if (is_gltf_name(entry->path()) && entry->is_regular_file(error)) scenes.push_back(entry->path());
  if (scenes.size() == 1) return {"this is a folder", "name the glTF file in it: " + scenes[0].string()};
  const std::string count =
      scenes.empty() ? "with no glTF file (.glb, .gltf) in it" : "with several glTF files in it";
  return {"this is a folder " + count, "name a glTF file"};
}

// OBJ has no mark: lines of known words after comments.
bool looks_like_obj(std::string_view head) {
  constexpr std::array<std::string_view, 8> kWords = {"mtllib ", "usemtl ", "o ",  "g ",
                                                      "v ",      "vn ",     "vt ", "s "};
  while (!head.empty()) {
    const std::string_view line = head.substr(0, head.find('\n'));
    head.remove_prefix(std::min(line.size() + 1, head.size()));
    if (line.empty() || line[0] == '#' || line[0] == '\r') continue;
    return std::any_of(kWords.begin(), kWords.end(),
                       [&](std::string_view word) { return line.substr(0, word.size()) == word; });
  }
  return false;
}

bool is_of(const KnownFormat& format, std::string_view head) {
  if (format.name == "a Wavefront OBJ file") return looks_like_obj(head);
  if (format.name == "a COLLADA file") return head.find("<COLLADA") != std::string_view::npos;
  return std::any_of(format.magic.begin(), format.magic.end(),
                     [&](std::string_view magic) { return head.substr(0, magic.size()) == magic; });
}

// A binary .glb, or text whose first character may begin a JSON object.
bool may_be_gltf(std::string_view head) {
  if (head.substr(0, 4) == "glTF") return true;
  const std::size_t first = head.find_first_not_of(" \t\r\n\xef\xbb\xbf");
  return first != std::string_view::npos && head[first] == '{';
}

OtherFormat said(const KnownFormat& format) {
  return {"this is " + std::string(format.name), advice_for(format.family)};
}

}  // namespace

std::optional<OtherFormat> other_format(std::string_view head, const fs::path& name) {
  if (head.empty() || may_be_gltf(head)) return std::nullopt;
  const std::string extension = lower_extension(name);
  const auto by_name = std::find_if(formats().begin(), formats().end(), [&](const KnownFormat& format) {
    return std::find(format.extensions.begin(), format.extensions.end(), extension) !=
           format.extensions.end();
  });
  if (extension == ".usdz") return said(*by_name);  // by its first bytes a zip archive
  const auto by_content = std::find_if(formats().begin(), formats().end(),
                                       [&](const KnownFormat& format) { return is_of(format, head); });
  if (by_content != formats().end()) return said(*by_content);
  if (by_name != formats().end()) return said(*by_name);
  return std::nullopt;
}

std::optional<OtherFormat> other_format(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) return folder(path);
  if (!fs::is_regular_file(path, error)) return std::nullopt;
  std::string head(1024, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  return other_format(head, path);
}

}  // namespace caustics::gltf
