// The first surface that each pixel hits, glass included, for the picture's layers.
UNIFORMS_BEGIN
#include "passes/first_hit/first_hit_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, view_position)
TEXTURE(1, view_normal)
TEXTURE(2, direct)
TEXTURE(3, caustic)
TEXTURE(4, view_caster_position)
TEXTURE(5, view_caster_normal)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, aov_direct)
OUTPUT(1, Vec4, aov_caustic)
OUTPUT(2, Vec4, aov_position)
OUTPUT(3, Vec4, aov_normal)
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/position_texel.glsl"

void main() {
  Int column = floor_to_int(frag_x());
  Int row = floor_to_int(frag_y());
  Vec4 surface = texel_fetch(view_position, column, row);
  Vec4 normal = texel_fetch(view_normal, column, row);
  Float surface_z = normal.w;
  // What the picture lacks is one texel of zeros.
  Vec4 caster = fetch_clamped(view_caster_position, column, row);
  Vec4 caster_normal = fetch_clamped(view_caster_normal, column, row);
  Float z = view_coordinates(u.view, Vec3(caster)).z;
  Bool glass = is_covered(caster) && (!is_covered(surface) || z < surface_z);
  Vec3 toward = sel(is_back_face(caster), -Vec3(caster_normal), Vec3(caster_normal));
  Vec4 nothing = Vec4(0.0f);
  aov_direct = sel(glass, nothing, fetch_clamped(direct, column, row));
  aov_caustic = sel(glass, nothing, fetch_clamped(caustic, column, row));
  aov_position = sel(glass, Vec4(Vec3(caster), Float(1.0f)), surface);
  aov_normal = sel(glass, Vec4(toward, z), normal);
}
#endif
