// Which of their materials' textures the casters of a scene are drawn with (docs/materials.md).
#pragma once
#include "pipeline/effects/effects.hpp"

namespace caustics {

// What the caster maps hold besides positions and smooth normals.
enum class CasterDetail : std::uint8_t {
  None,
  Normals,  // normals of normal textures, holes of alpha masks
  Colors,   // these and a colour for each texel
};
CasterDetail caster_detail(const Effects& effects);
// Whether the maps of the casters' back faces need normal textures or alpha masks: they hold no colour.
bool detailed_exits(const Effects& effects);

// Whether light or the camera's rays are followed from surface to surface, and meet textures there.
bool walks_textures(const Effects& effects);

// Judges textured_casters, normal_mapped_casters and cut_out_casters.
void add_textured_casters(const Scene& scene, const Settings& settings, Effects& effects);

}  // namespace caustics
