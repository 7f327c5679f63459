#include <algorithm>
#include <array>
#include <string_view>

#include "pipeline/scene/gltf/check.hpp"
#include "pipeline/scene/gltf/compressed.hpp"

namespace caustics::gltf {

namespace {

constexpr std::array<std::string_view, 19> kSupported = {"KHR_materials_transmission",
                                                         "KHR_materials_specular",
                                                         "KHR_materials_ior",
                                                         "KHR_materials_volume",
                                                         "KHR_materials_dispersion",
                                                         "KHR_materials_unlit",
                                                         "KHR_materials_emissive_strength",
                                                         "KHR_materials_variants",
                                                         "KHR_lights_punctual",
                                                         "KHR_mesh_quantization",
                                                         "KHR_texture_transform",
                                                         "EXT_texture_webp",
                                                         "EXT_mesh_gpu_instancing",
                                                         "KHR_node_visibility",
                                                         "KHR_xmp_json_ld",
                                                         "KHR_xmp",
                                                         "KHR_texture_basisu",
                                                         kMeshopt,
                                                         kDraco};

struct Harmless {
  std::string_view name;
  std::string_view instead;  // what is drawn, for people
};

// Extensions that change how light looks on a surface but neither geometry nor refraction: a file
// that requires them still makes a meaningful scene.
constexpr std::array<Harmless, 9> kHarmless = {
    {{"KHR_materials_clearcoat", "Clear coat is left out"},
     {"KHR_materials_sheen", "Sheen is left out: cloth has no bright rim"},
     {"KHR_materials_iridescence", "Iridescence is left out: thin films show no colours"},
     {"KHR_materials_anisotropy", "Anisotropy is left out: highlights are round"},
     {"KHR_materials_diffuse_transmission",
      "Diffuse transmission is left out: leaves and paper let no light through"},
     {"KHR_materials_volume_scatter", "Scattering in volumes is left out: they are clear"},
     {"KHR_materials_pbrSpecularGlossiness",
      "Specular-glossiness is shown as metal without diffuse colour, or as diffuse that mirrors by its ior"},
     {"KHR_animation_pointer", "Animated properties of materials, lights and cameras stay as they are"},
     {"KHR_audio_emitter", "Sound is left out"}}};

const Harmless* find_harmless(std::string_view name) {
  const auto* const found = std::find_if(kHarmless.begin(), kHarmless.end(),
                                         [&](const Harmless& harmless) { return harmless.name == name; });
  return found == kHarmless.end() ? nullptr : found;
}

bool is_supported(std::string_view name) {
  return std::find(kSupported.begin(), kSupported.end(), name) != kSupported.end();
}

std::string advice_for(std::string_view name) {
  if (name.find("meshopt") != std::string_view::npos) {
    return "re-export without meshopt compression: gltf-transform copy in.glb out.glb";
  }
  if (name.find("avif") != std::string_view::npos) {
    return "re-export with PNG or JPEG textures";
  }
  return "re-export without this extension";
}

void check_version(Context& context, const Cursor& root) {
  const Cursor asset = root.member("asset");
  const Cursor version = asset.member("version");
  // As drafts of glTF 1.0 wrote it.
  if (version.present() && version.json().is<double>())
    version.fail("is " + version.json().described() + ", only glTF 2.0 can be read", "export it as glTF 2.0");
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
    if (is_supported(name)) continue;
    if (!find_harmless(name)) {
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
    if (is_supported(name)) continue;
    ignored.push_back(name);
  }
  for (const std::string& name : ignored) {
    const Harmless* const harmless = find_harmless(name);
    context.note(harmless ? std::string(harmless->instead) + " (" + name + ")."
                          : "The extension " + name + " is ignored.");
  }
}

}  // namespace caustics::gltf
