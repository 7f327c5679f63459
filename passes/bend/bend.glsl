// Light at each further surface: refracted, totally reflected or mirrored; absorbed on the stretch just gone.
// bend.md explains.
UNIFORMS_BEGIN
#include "passes/bend/bend_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, path_start)
TEXTURE(1, path_direction)
TEXTURE(2, path_flux)
TEXTURE(3, path_media)
TEXTURE(4, path_width)
TEXTURE(5, path_spread)
TEXTURE(6, surface_hit)
TEXTURE(7, caster_materials)
TEXTURE(8, hierarchy_triangles)
TEXTURE(9, hierarchy_normals)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
#include "passes/shared/ray_outputs.glsl"
#include "passes/shared/axes_across.glsl"
#include "passes/shared/caster_material.glsl"
#include "passes/shared/caster_triangles.glsl"
#include "passes/shared/optics.glsl"
#include "passes/shared/absorption.glsl"
#include "passes/shared/ray.glsl"
#include "passes/shared/ray_state.glsl"
#include "passes/shared/refraction.glsl"
#include "passes/shared/light_path.glsl"
#include "passes/shared/fetch_light_path.glsl"
#include "passes/shared/media.glsl"
#include "passes/shared/interface.glsl"
#include "passes/shared/bend_light.glsl"

void bend_at(Int column, Int row, Vec4 hit, Bool met) {
  CasterTriangle triangle = fetch_triangle(sel(met, hit.w - 1.0f, Float(0.0f)));
  LightPath path = fetch_light_path(column, row);
  Meeting at = meeting_at(triangle, hit, path.ray.direction);
  Material material = fetch_material(caster_materials, triangle.row);
  TRACE(surface_point, at.point);
  TRACE(surface_normal, at.outward);
  bend_light(path, at, triangle, material, met);
}

void main() {
  Int column = floor_to_int(frag_x());
  Int row = floor_to_int(frag_y());
  Vec4 hit = texel_fetch(surface_hit, column, row);
  Bool met = is_on_caster(hit);
  discard_if(!met);
  if (any_lane(met)) bend_at(column, row, hit, met);
}
#endif
