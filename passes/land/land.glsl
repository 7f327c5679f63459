// Where light lands that meets no further caster. land.md explains.
UNIFORMS_BEGIN
#include "passes/land/land_uniforms.glsl"
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
#include "passes/shared/caster_triangles.glsl"
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/optics.glsl"
#include "passes/shared/absorption.glsl"
#include "passes/shared/position_texel.glsl"
#include "passes/shared/ray.glsl"
#include "passes/shared/ray_state.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/shown_point.glsl"
#include "passes/shared/light_path.glsl"
#include "passes/shared/fetch_light_path.glsl"

// What the hierarchy says of a ray's way.
struct WayAhead {
  Bool receiver;  // it ends on a receiver
  Bool caster;    // it meets a further caster
  Bool given_up;  // nobody knows
};

WayAhead way_ahead(Vec4 start, Vec4 hit) {
  WayAhead ahead;
  ahead.given_up = has_ended(start) || is_given_up(hit);
  ahead.caster = is_on_caster(hit) && !ahead.given_up;
  ahead.receiver = is_surface(hit) && !is_on_caster(hit) && !ahead.given_up;
  return ahead;
}

// Where the hierarchy has it end.
struct End {
  Vec3 point;
  Float flight;    // metres
  Bool lands;
  Bool seen;       // by the light
};

End end_of(IN(Ray) ray, IN(WayAhead) ahead, Vec4 hit) {
  End end;
  end.flight = hit.z;
  end.point = point_along(ray, hit.z);
  end.lands = ahead.receiver;
  end.seen = Bool(true);
  if (u.can_be_hidden != 0) end.seen = shows_point(receiver_position, u.receiver, end.point);
  return end;
}

Float largest(Vec3 v) { return max_of(max_of(v.x, v.y), v.z); }

// From the last thing that may keep light from its landing to the first.
Float status_of(IN(End) end, IN(WayAhead) ahead, Vec3 carried, Float whole) {
  Vec2 uv = view_uv(u.caustic, view_coordinates(u.caustic, end.point));
  Float status = Float(STATUS_LANDED);
  status = sel(end.seen, status, Float(STATUS_NOT_CONVERGED));
  status = sel(!inside_unit(uv.x, uv.y), Float(STATUS_OUTSIDE), status);
  status = sel(largest(carried) <= whole * 1.0e-6f && whole > 0.0f, Float(STATUS_ABSORBED), status);
  status = sel(end.lands, status, Float(STATUS_MISSED));
  return sel(ahead.given_up || ahead.caster, Float(STATUS_GIVEN_UP), status);
}

// Where the landing moves to in the caustic map with a step of the grid, in parts of the map: the light moves
// on the receiver's plane.
Vec2 step_in_map(IN(LightPath) path, IN(End) end, Vec3 plane, Vec3 moved) {
  Float along = dot3(path.ray.direction, plane);
  Float steep = sel(abs(along) > 1.0e-2f, along, sel(along < 0.0f, Float(-1.0e-2f), Float(1.0e-2f)));
  Vec3 on_plane = moved - path.ray.direction * (dot3(moved, plane) / steep);
  Vec3 q = view_coordinates(u.caustic, end.point);
  Vec3 turned = transform_vector(u.caustic.from_scene, on_plane);
  Int face = view_face(u.caustic, q);
  Vec3 at = in_face(u.caustic, q, face);
  Vec3 step = in_face(u.caustic, turned, face);
  Vec2 result = Vec2(step.x * u.caustic.scale.x, step.y * u.caustic.scale.y);
  if (u.caustic.kind != VIEW_PARALLEL) {
    Float w = max_of(at.z, 1.0e-20f);
    result = Vec2((step.x - at.x / w * step.z) / w * u.caustic.scale.x,
                  (step.y - at.y / w * step.z) / w * u.caustic.scale.y);
  }
  return result;
}

// Water on its bed takes its part of the light down to the landing.
void land_at(Int column, Int row, Vec4 hit, IN(WayAhead) ahead) {
  LightPath path = fetch_light_path(column, row);
  CasterTriangle triangle = fetch_triangle(sel(is_surface(hit), hit.w - 1.0f, Float(0.0f)));
  End end = end_of(path.ray, ahead, hit);
  Vec3 carried = path.flux * sel(end.lands, left_by(path.media.x, end.flight), Vec3(1.0f));
  Float status = status_of(end, ahead, carried, path.whole);
  Vec3 share = Vec3(u.channel_share);
  landing = Vec4(end.point, status);
  landing_flux = Vec4(carried * share, Float(0.0f));
  landing_absorbed = Vec4((path.flux - carried) * share, Float(0.0f));
  Vec3 plane = cross3(triangle.edge1, triangle.edge2);
  plane = normalize_or(plane, -path.ray.direction);
  Vec2 along_x = step_in_map(path, end, plane, path.width_x + path.spread_x * end.flight);
  Vec2 along_y = step_in_map(path, end, plane, path.width_y + path.spread_y * end.flight);
  landing_path = Vec4(path.path, Float(1.0f), Float(0.0f), Float(0.0f));
  landing_footprint = bounded(along_x.x, along_x.y, along_y.x, along_y.y);
  TRACE(landing_point, end.point);
  TRACE(status, status);
}

void main() {
  Int column = floor_to_int(frag_x());
  Int row = floor_to_int(frag_y());
  Vec4 start = texel_fetch(path_start, column, row);
  Vec4 hit = texel_fetch(surface_hit, column, row);
  WayAhead ahead = way_ahead(start, hit);
  Bool ends = (is_under_way(start) || has_ended(start)) && (u.is_last_round != 0 || !ahead.caster);
  discard_if(!ends);
  landing = Vec4(0.0f);
  landing_flux = Vec4(0.0f);
  landing_absorbed = Vec4(0.0f);
  landing_path = Vec4(0.0f);
  landing_footprint = Vec4(0.0f);
  if (any_lane(ends)) land_at(column, row, hit, ahead);
}
#endif
