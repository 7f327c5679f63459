// Shows by itself how the pass walk lands light that meets no further caster.
#include "passes/shared/light_cone.glsl"
UNIFORMS_BEGIN
#include "passes/walk/walk_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, start_before)
TEXTURE(1, direction_before)
TEXTURE(2, flux_before)
TEXTURE(3, media_before)
TEXTURE(4, width_before)
TEXTURE(5, spread_before)
TEXTURE(6, hit_ahead)
TEXTURE(7, caster_materials)
TEXTURE(8, hierarchy_triangles)
TEXTURE(9, hierarchy_normals)
TEXTURE(10, receiver_position)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, landing)
OUTPUT(1, Vec4, landing_flux)
OUTPUT(2, Vec4, landing_absorbed)
OUTPUT(3, Vec4, landing_path)
OUTPUT(4, Vec4, landing_footprint)
#include "passes/shared/axes_across.glsl"
#include "passes/shared/caster_material.glsl"
#include "passes/shared/position_texel.glsl"
#include "passes/shared/meeting.glsl"
#include "passes/shared/caster_triangles.glsl"
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/optics.glsl"
#include "passes/shared/ray.glsl"
#include "passes/shared/absorption.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/shown_point.glsl"
#include "passes/shared/light_path.glsl"
#include "passes/shared/hit_texel.glsl"
#include "passes/shared/land_light.glsl"
#include "tests/walk/shaders/fetch_path.glsl"

void main() {
  LandedLight landed = nothing_landed();
  LightPath path = path_before();
  Bool was_ended = path.own == -2.0f;
  land_light(path, texel_fetch(hit_ahead, Int(0), Int(0)), was_ended, Bool(true), landed);
  landing = landed.at;
  landing_flux = Vec4(landed.flux, Float(0.0f));
  landing_absorbed = Vec4(landed.absorbed, Float(0.0f));
  landing_path = Vec4(landed.path, Float(0.0f), Float(0.0f), Float(0.0f));
  landing_footprint = landed.footprint;
}
#endif
