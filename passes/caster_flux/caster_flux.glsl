// Adds up the light on all covered grid vertices: a point for each column of the grid, all into one texel.
#include "passes/shared/light_cone.glsl"
UNIFORMS_BEGIN
#include "passes/caster_flux/caster_flux_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, caster_position)
VARYING_FLAT(0, Vec2, sums)

#ifdef VERTEX_STAGE
#include "passes/shared/cone_falloff.glsl"
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/position_texel.glsl"
#include "passes/shared/splat.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/grid_light.glsl"

void main() {
  Int column = vertex_id();
  Float flux = Float(0.0f);
  Float count = Float(0.0f);
  for (int row = 0; row < u.grid_side; row++) {
    Vec4 position = texel_fetch(caster_position, column, Int(row));
    GridCell cell = cell_of(column, Int(row), is_covered(position));
    Incident light = light_onto(cell, Vec3(position));
    flux = flux + light.flux;
    count = count + sel(cell.covered && !cell.guard, Float(1.0f), Float(0.0f));
  }
  sums = Vec2(flux, count);
  set_position(splat_position(Vec4(0.0f, 0.0f, 0.5f, 1.0f), Bool(true)));
  set_point_size(Float(1.0f));
}
#else
OUTPUT(0, Vec4, caster_flux)

void main() { caster_flux = Vec4(sums.x, sums.y, Float(0.0f), Float(0.0f)); }
#endif
