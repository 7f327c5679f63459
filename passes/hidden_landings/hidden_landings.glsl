// Landings on receivers that others hide from the light, for its second caustic map. hidden_landings.md
// explains.
UNIFORMS_BEGIN
#include "passes/hidden_landings/hidden_landings_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, landed_before)
TEXTURE(1, flux_before)
TEXTURE(2, fresnel_before)
TEXTURE(3, absorbed_before)
TEXTURE(4, path_before)
TEXTURE(5, footprint_before)
TEXTURE(6, receiver_position)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, landing)
OUTPUT(1, Vec4, landing_flux)
OUTPUT(2, Vec4, landing_fresnel)
OUTPUT(3, Vec4, landing_absorbed)
OUTPUT(4, Vec4, landing_path)
OUTPUT(5, Vec4, landing_footprint)
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/landing_status.glsl"
#include "passes/shared/position_texel.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/shown_point.glsl"

void main() {
  Int column = floor_to_int(frag_x());
  Int row = floor_to_int(frag_y());
  Vec4 before = texel_fetch(landed_before, column, row);
  Bool hidden = has_status(before, STATUS_NOT_CONVERGED);
  discard_if(!(hidden && shows_point(receiver_position, u.receiver, Vec3(before))));
  landing = Vec4(Vec3(before), Float(STATUS_LANDED));
  landing_flux = texel_fetch(flux_before, column, row);
  landing_fresnel = texel_fetch(fresnel_before, column, row);
  landing_absorbed = texel_fetch(absorbed_before, column, row);
  landing_path = texel_fetch(path_before, column, row);
  landing_footprint = texel_fetch(footprint_before, column, row);
}
#endif
