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

// Whether light, or the camera's rays, meet textures on their way from surface to surface.
bool light_meets_textures(const Effects& effects);
bool sight_meets_textures(const Effects& effects);
// Whether either asks for those of receivers.
bool receivers_are_dressed(const Effects& effects);

// Judges textured_casters, normal_mapped_casters, cut_out_casters, textured_receivers and
// cut_out_receivers.
void add_textured_casters(const Scene& scene, const Settings& settings, Effects& effects);

}  // namespace caustics
