// Reads glTF materials. Missing members take the specifications' defaults; factors beyond their
// range are clamped with a note; what is no number is refused. Sources: glTF 2.0 section 3.9;
// KHR_materials_transmission, _ior, _volume, _dispersion, _unlit, _emissive_strength.
#pragma once
#include <vector>

#include "pipeline/scene/gltf/textures.hpp"

namespace caustics::gltf {

struct Materials {
  std::vector<Material> list;  // those of the file, then glTF's default material
  std::vector<int> uv_sets;    // the TEXCOORD_n that each one's textures are placed with
  int fallback() const { return static_cast<int>(list.size()) - 1; }
};

// Unused materials become glTF's default. The images of the used ones are looked at before any is decoded
// (Textures::fit).
Materials read_materials(Context& context, const Document& document, const Used& used, Textures& textures);

}  // namespace caustics::gltf
