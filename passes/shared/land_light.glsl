// Lands light that meets no further caster. Needs absorption.glsl, caster_triangles.glsl,
// light_path.glsl, ray_hit.glsl, shown_point.glsl, view_space.glsl, the texture receiver_position, and the
// uniforms light, receiver, caustic, channel_share, first_receiver and can_be_hidden.

// The texels that a grid vertex's light leaves (passes/walk/walk.md).
struct LandedLight {
  Vec4 at;
  Vec3 flux;
  Vec3 fresnel;
  Vec3 absorbed;
#ifdef HAZE
  Vec3 taken_by_air;
#endif
  Float path;
  Vec4 footprint;
};

LandedLight nothing_landed() {
  LandedLight landed;
  landed.at = Vec4(0.0f);
  landed.flux = Vec3(0.0f);
  landed.fresnel = Vec3(0.0f);
  landed.absorbed = Vec3(0.0f);
#ifdef HAZE
  landed.taken_by_air = Vec3(0.0f);
#endif
  landed.path = Float(0.0f);
  landed.footprint = Vec4(0.0f);
  return landed;
}

// The end of a path.
struct PathEnd {
  Vec3 point;
  Float flight;    // metres
  Bool lands;      // on a receiver
  Bool seen;       // by the light
  Bool given_up;   // nobody knows where
};

// Has light come to the side of a plane that its light cannot shine on itself?
Bool comes_from_behind(IN(Ray) ray, Vec3 point, Vec3 plane) {
  Vec3 travel = Vec3(u.light);
  if (u.receiver.kind != VIEW_PARALLEL) travel = normalize_or(point - Vec3(u.light), ray.direction);
  return dot3(ray.direction, plane) * dot3(travel, plane) < -1.0e-3f;
}

PathEnd end_of(IN(Ray) ray, Vec4 hit, Bool was_ended) {
  PathEnd end;
  end.flight = hit.z;
  end.point = point_along(ray, hit.z);
  end.given_up = was_ended || is_given_up(hit) || is_on_caster(hit);
  end.lands = is_surface(hit) && !end.given_up;
  end.seen = Bool(true);
  if (u.can_be_hidden != 0) end.seen = shows_point(receiver_position, u.receiver, end.point);
  return end;
}

// From the last thing that may keep light from its landing to the first.
Float status_of(IN(PathEnd) end, Vec3 carried, Float whole) {
  Vec2 uv = view_uv(u.caustic, view_coordinates(u.caustic, end.point));
  Float most = max_of(max_of(carried.x, carried.y), carried.z);
  Float status = Float(STATUS_LANDED);
  status = sel(end.seen, status, Float(STATUS_NOT_CONVERGED));
  status = sel(!inside_unit(uv.x, uv.y), Float(STATUS_OUTSIDE), status);
  status = sel(most <= whole * 1.0e-6f && whole > 0.0f, Float(STATUS_ABSORBED), status);
  status = sel(end.lands, status, Float(STATUS_MISSED));
  return sel(end.given_up, Float(STATUS_GIVEN_UP), status);
}

// Where the landing moves to in the caustic map with a step of the grid, in parts of the map: the light moves
// on the receiver's plane.
Vec2 step_in_map(IN(LightPath) path, IN(PathEnd) end, Vec3 plane, Vec3 moved) {
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

// What is left of light at its end. Water on its bed takes its part down to the landing, and the air its own,
// also of light that lands nowhere.
Vec3 carried_to(IN(PathEnd) end, IN(LightPath) path) {
#ifdef HAZE
  Bool in_air = is_in_air(path.media.x) && !end.given_up;
  Vec3 left = left_on_way(path.ray, path.media.x, sel(end.lands, end.flight, Float(1.0e30f)));
  return path.flux * sel(end.lands || in_air, left, Vec3(1.0f));
#else
  return path.flux * sel(end.lands, left_by(path.media.x, end.flight), Vec3(1.0f));
#endif
}

// `hit`: what lies ahead; `was_ended`: the light is followed no further; `lands`: only such light does.
void land_light(IN(LightPath) path, Vec4 hit, Bool was_ended, Bool lands, INOUT(LandedLight) landed) {
  CasterTriangle triangle = fetch_triangle(sel(lands && is_surface(hit), hit.w - 1.0f, Float(0.0f)));
  PathEnd end = end_of(path.ray, hit, was_ended);
  Vec3 plane = normalize_or(cross3(triangle.edge1, triangle.edge2), -path.ray.direction);
  if (u.can_be_hidden > 1) end.seen = end.seen && !comes_from_behind(path.ray, end.point, plane);
  Vec3 carried = carried_to(end, path);
  Float status = status_of(end, carried, path.whole);
  Vec3 share = Vec3(u.channel_share);
  Vec2 x = step_in_map(path, end, plane, path.width_x + path.spread_x * end.flight);
  Vec2 y = step_in_map(path, end, plane, path.width_y + path.spread_y * end.flight);
  Vec4 footprint = Vec4(bounded(x.x), bounded(x.y), bounded(y.x), bounded(y.y));
  landed.at = sel(lands, Vec4(end.point, status), landed.at);
  landed.flux = sel(lands, carried * share, landed.flux);
  Vec3 taken = (path.flux - carried) * share;
#ifdef HAZE
  Bool in_air = is_in_air(path.media.x);
  landed.taken_by_air = sel(lands && in_air, taken + landed.taken_by_air, landed.taken_by_air);
  taken = sel(in_air, Vec3(0.0f), taken);
#endif
  landed.absorbed = sel(lands, taken + landed.absorbed, landed.absorbed);
  landed.path = sel(lands, path.path, landed.path);
  landed.footprint = sel(lands, footprint, landed.footprint);
  TRACE(landing_point, end.point);
  TRACE(status, status);
}
