#include <algorithm>
#include <array>
#include <string_view>

#include "pipeline/scene/gltf/check.hpp"
#include "pipeline/scene/gltf/compressed.hpp"

namespace caustics::gltf {

namespace {

constexpr std::array<std::string_view, 16> kSupported = {"KHR_materials_transmission",
                                                         "KHR_materials_ior",
                                                         "KHR_materials_volume",
                                                         "KHR_materials_dispersion",
                                                         "KHR_materials_unlit",
                                                         "KHR_materials_emissive_strength",
                                                         "KHR_materials_variants",
                                                         "KHR_lights_punctual",
                                                         "KHR_mesh_quantization",
                                                         "KHR_texture_transform",
                                                         "EXT_mesh_gpu_instancing",
                                                         "KHR_node_visibility",
                                                         "KHR_xmp_json_ld",
                                                         "KHR_texture_basisu",
                                                         kMeshopt,
                                                         kDraco};

// Extensions that change how light looks on a surface but neither geometry nor refraction: a file
// that requires them still makes a meaningful scene.
constexpr std::array<std::string_view, 9> kHarmless = {
    "KHR_materials_specular",   "KHR_materials_clearcoat",
    "KHR_materials_sheen",      "KHR_materials_iridescence",
    "KHR_materials_anisotropy", "KHR_materials_diffuse_transmission",
    "KHR_animation_pointer",    "KHR_materials_pbrSpecularGlossiness",
    "KHR_audio_emitter"};

template <std::size_t N>
bool contains(const std::array<std::string_view, N>& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

std::string advice_for(std::string_view name) {
  if (name.find("meshopt") != std::string_view::npos) {
    return "re-export without meshopt compression: gltf-transform copy in.glb out.glb";
  }
  if (name.find("webp") != std::string_view::npos || name.find("avif") != std::string_view::npos) {
    return "re-export with PNG or JPEG textures";
  }
  return "re-export without this extension";
}

void check_version(Context& context, const Cursor& root) {
  const Cursor asset = root.member("asset");
  const Cursor version = asset.member("version");
  const std::string text = version.string();
  if (text.compare(0, 2, "2.") != 0) {
    version.fail("is \"" + text + "\", only glTF 2.0 can be read", "export it as glTF 2.0");
  }
  const Cursor least = asset.member("minVersion");
  if (least.present() && least.string() != "2.0") {
    least.fail("is \"" + least.string() + "\", only glTF 2.0 can be read", "export it as glTF 2.0");
  }
  if (text != "2.0") context.note("asset.version is " + text + "; read as 2.0.");
}

}  // namespace

void check_extensions(Context& context, const Document& document) {
  const Cursor root = document.root(context);
  check_version(context, root);
  const Cursor required = root.member("extensionsRequired");
  std::vector<std::string> ignored;
  for (std::size_t i = 0; i < required.size(); ++i) {
    const std::string name = required.element(i).string();
    const bool undecoded =
        (name == kMeshopt && !has_meshopt_decoder()) || (name == kDraco && !has_draco_decoder());
    if (undecoded) fail_without_decoder(required.element(i), name);
    if (contains(kSupported, name)) continue;
    if (!contains(kHarmless, name)) {
      required.element(i).fail("the extension " + name + " is not supported", advice_for(name));
    }
    ignored.push_back(name);
  }
  const Cursor used = root.member("extensionsUsed");
  for (std::size_t i = 0; i < used.size(); ++i) {
    const std::string name = used.element(i).string();
    if (name == "KHR_materials_variants") context.note("Material variants: the base one is shown.");
    if (name == "KHR_texture_basisu")
      context.note(
          "Basis textures cannot be read: where nothing else is there, surfaces have none; "
          "re-export with PNG or JPEG textures.");
    if (contains(kSupported, name)) continue;
    ignored.push_back(name);
  }
  for (const std::string& name : ignored) context.note("The extension " + name + " is ignored.");
}

}  // namespace caustics::gltf
