// Adds every grid vertex that landed, or stopped on its way and is drawn there, to the caustic map: one
// texel, or a Gaussian integrated over texels. Where cells are drawn, only what they leave.
UNIFORMS_BEGIN
#include "passes/caustic_map/caustic_map_uniforms.glsl"
UNIFORMS_END
TEXTURE(0, landing)
TEXTURE(1, landing_flux)
TEXTURE(2, cell_flux)
VARYING_FLAT(0, Vec3, flux)
VARYING_FLAT(3, Vec2, centre)

#ifdef VERTEX_STAGE
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/landing_status.glsl"
#include "passes/shared/quarters_left.glsl"
#include "passes/shared/splat.glsl"
#include "passes/shared/view_space.glsl"

void main() {
  Int id = vertex_id();
  Int row = id / Int(u.grid_side);
  Int column = id - row * Int(u.grid_side);
  Vec4 place = texel_fetch(landing, column, row);
  Vec4 carried = texel_fetch(landing_flux, column, row);
  Bool drawn = has_status(place, STATUS_LANDED) || has_status(place, STATUS_STOPPED);
  Float part = Float(1.0f);
  if (u.has_cells != 0) part = quarters_left(column, row) * 0.25f;
  drawn = drawn && part > 0.0f;
  // The guard vertices of a cube's caster map carry nothing.
  if (u.map.kind == VIEW_CUBE) drawn = drawn && max_of(max_of(carried.x, carried.y), carried.z) > 0.0f;
  Vec3 q = view_coordinates(u.map, Vec3(place));
  Vec2 uv = view_uv(u.map, q);
  flux = Vec3(carried) * part;
  centre = Vec2(uv.x * float(u.map_side), uv.y * float(u.map_side));
  // One texel is meant where there is no kernel: its middle is drawn, for a place on a border would be
  // rounded to either side of it, and off the map at the map's.
  Float last = Float(float(u.map_side)) - 0.5f;
  if (u.radius == 0.0f) {
    centre = Vec2(clamp_to(floor(centre.x) + 0.5f, 0.5f, last), clamp_to(floor(centre.y) + 0.5f, 0.5f, last));
    uv = centre * (1.0f / float(u.map_side));
  }
  // The middle of the depth range: a splat is never clipped by depth.
  Vec4 at = Vec4(2.0f * uv.x - 1.0f, 2.0f * uv.y - 1.0f, Float(0.5f), Float(1.0f));
  set_position(splat_position(at, drawn));
  set_point_size(Float(u.point_size));
}
#else
OUTPUT(0, Vec4, caustic_map)

// The share of the kernel that falls on the texel around x, along one axis: the Gaussian's integral
// from texel edge to texel edge, cut at the radius, over the mass inside it. Over all texels the
// shares add up to 1 whatever the centre, because neighbouring integrals share their edges.
Float share(Float offset) {
  Float radius = Float(u.radius);
  Float from = clamp_to(offset - 0.5f, -radius, radius);
  Float to = clamp_to(offset + 0.5f, -radius, radius);
  return 0.5f * (erf_of(to * u.sharpness) - erf_of(from * u.sharpness)) * u.inverse_mass;
}

void main() {
  Float weight = Float(1.0f);
  if (u.radius > 0.0f) weight = share(frag_x() - centre.x) * share(frag_y() - centre.y);
  caustic_map = Vec4(flux * weight, weight);
}
#endif
