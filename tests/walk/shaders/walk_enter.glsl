// Shows by itself how the pass walk begins: the light at a grid vertex's surface.
#include "passes/shared/light_cone.glsl"
UNIFORMS_BEGIN
#include "passes/walk/walk_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, caster_position)
TEXTURE(1, caster_normal)
TEXTURE(2, caster_materials)
TEXTURE(3, hierarchy_triangles)
TEXTURE(4, hierarchy_normals)
TEXTURE(5, reaching)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
#include "tests/walk/shaders/path_outputs.glsl"
#include "passes/shared/cone_falloff.glsl"
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/grid_light.glsl"
#include "passes/shared/way_draw.glsl"
#include "passes/shared/wide_light.glsl"
#include "passes/shared/enter_light.glsl"

void main() {
  Int column = floor_to_int(frag_x());
  Int row = floor_to_int(frag_y());
  Float drawn = Float(0.0f);
  if (u.light_shape != 0) drawn = first_facet_draw(Float(column), Float(row));
  Arrival arrival = arrival_at(column, row, drawn);
  Material material = fetch_material(caster_materials, arrival.material);
  write_bent(bend_light(arrival.path, arrival.at, arrival.triangle, material, turn_now()), arrival.covered);
}
#endif
