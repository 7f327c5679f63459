// Shows by itself how the pass walk bends light at a surface.
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

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
#include "tests/walk/shaders/path_outputs.glsl"
#include "tests/walk/shaders/fetch_path.glsl"

void main() {
  Vec4 hit = texel_fetch(hit_ahead, Int(0), Int(0));
  CasterTriangle triangle = fetch_triangle(hit.w - 1.0f);
  LightPath path = path_before();
  Meeting at = meeting_at(triangle, hit, path.ray.direction);
  Material material = fetch_material(caster_materials, triangle.row);
  write_bent(bend_light(path, at, triangle, material, turn_now()), Bool(true));
}
#endif
