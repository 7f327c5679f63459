// What one light gives to the surfaces that the camera sees: direct irradiance after shadows, and
// irradiance from its caustics.
UNIFORMS_BEGIN
#include "passes/light_shading/light_shading_uniforms.glsl"
#ifdef HAZE
#include "passes/medium/medium_uniforms.glsl"
#endif
UNIFORMS_END
TEXTURE(0, view_position)
TEXTURE(1, view_normal)
TEXTURE(2, shadow_depth)
TEXTURE(3, caster_position)
TEXTURE(4, receiver_position)
TEXTURE(5, caustic_map)
TEXTURE(6, cascade_map)
TEXTURE(7, pane_transmittance)
TEXTURE(8, far_receiver_position)
TEXTURE(9, far_caustic_map)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, direct)
OUTPUT(1, Vec4, caustic)
#include "passes/shared/cube_atlas.glsl"
#include "passes/shared/view_space.glsl"
#include "passes/shared/light_intensity.glsl"
#include "passes/shared/column.glsl"
#include "passes/shared/surface_plane.glsl"
#ifdef HAZE
#include "passes/shared/optics.glsl"
#include "passes/medium/medium.glsl"
#endif

// The surface's tangent plane in view coordinates, to compare depths where a map's texel is instead of
// where the shaded point is: that leaves nothing of the usual slope for a bias to hide. It is the
// triangle's plane, which is what the maps drew; shading normals lean away from it.
struct TangentPlane {
  Vec3 at;      // the point
  Int face;     // of a cube: the face that sees it
  Vec3 q;       // the point and
  Vec3 normal;  // the normal in that face's axes; in other frames in the frame's
};

// A plane steeper than 1 in 500 against the light counts as that steep: what is left of it is rounding.
Float steep_limited(Float slope) {
  return sel(slope < 0.0f, min_of(slope, Float(-0.002f)), max_of(slope, Float(0.002f)));
}

// Cosine between the plane's normal and the light's axis, or the ray from a light with a position.
Float plane_slope(TangentPlane p) {
  Float slope = p.normal.z;
  if (u.light.w > 0.5f) slope = dot3(p.normal, p.q) / max_of(length3(p.q), 1.0e-20f);
  return slope;
}

// z of the plane at window coordinates; in a perspective view within half and twice the point's own.
Float plane_z(TangentPlane p, Float x, Float y) {
  Float z = p.q.z;
  if (u.light.w > 0.5f) {
    Float along = steep_limited(p.normal.x * x + p.normal.y * y + p.normal.z);
    z = clamp_to(dot3(p.normal, p.q) / along, p.q.z * 0.5f, p.q.z * 2.0f);
  } else {
    // From the point, so that no large numbers cancel.
    z = p.q.z - (p.normal.x * (x - p.q.x) + p.normal.y * (y - p.q.y)) / steep_limited(p.normal.z);
  }
  return z;
}

// Bilinear weights and texels around map coordinates.
struct Corners {
  Int x0;
  Int y0;
  Float fx;
  Float fy;
};

Corners corners_at(Vec2 uv, int width, int height) {
  Corners c;
  Float x = uv.x * float(width) - 0.5f;
  Float y = uv.y * float(height) - 0.5f;
  c.x0 = floor_to_int(x);
  c.y0 = floor_to_int(y);
  c.fx = clamp_to(x - Float(c.x0), 0.0f, 1.0f);
  c.fy = clamp_to(y - Float(c.y0), 0.0f, 1.0f);
  return c;
}

// Window coordinate of a texel's centre; window coordinate 0 of the frame, or of the face, lies at `offset`.
Float window_of(Int texel, int size, float scale, Float offset) {
  return ((Float(texel) + 0.5f) / float(size) - offset) / scale;
}

Bool in_map(Int x, Int y, int width, int height) {
  return x >= 0 && x < width && y >= 0 && y < height;
}

// 1 where an opaque surface at this texel lies before the plane, else 0.
Float occluded(TangentPlane p, Int x, Int y, Float bias) {
  int width = texture_width(shadow_depth);
  int height = texture_height(shadow_depth);
  Vec2 offset = face_offset(p.face, u.shadow_window, u.shadow_range);
  Float z = plane_z(p, window_of(x, width, u.shadow_window.x, offset.x),
                    window_of(y, height, u.shadow_window.y, offset.y));
  Float stored = fetch_clamped(shadow_depth, x, y).x;
  // What lies behind the point cannot shadow it, even where the plane runs on far behind.
  Bool blocked = in_map(x, y, width, height) && stored < min_of(z, p.q.z) - bias;
  return sel(blocked, Float(1.0f), Float(0.0f));
}

Float shadow_share(TangentPlane p) {
  int width = texture_width(shadow_depth);
  int height = texture_height(shadow_depth);
  Vec2 uv = view_uv(p.at, u.shadow_window, u.shadow_range);
  Corners c = corners_at(uv, width, height);
  // A map knows where a surface lies to a texel's extent across the light. What is nearer to the plane
  // than that, measured across the plane, is the surface itself: along the light, the extent over the slope.
  Float slant = 1.0f / max_of(abs(plane_slope(p)), 0.02f);
  Float bias = slant * view_w(p.at, u.shadow_range) *
               max_of(Float(1.0f / (u.shadow_window.x * float(width))),
                      Float(1.0f / (u.shadow_window.y * float(height))));
  Float bottom = occluded(p, c.x0, c.y0, bias) * (1.0f - c.fx) + occluded(p, c.x0 + 1, c.y0, bias) * c.fx;
  Float top = occluded(p, c.x0, c.y0 + 1, bias) * (1.0f - c.fx) +
              occluded(p, c.x0 + 1, c.y0 + 1, bias) * c.fx;
  return sel(view_w(p.at, u.shadow_range) > 0.0f, bottom * (1.0f - c.fy) + top * c.fy, Float(0.0f));
}

// 1 where a caster covers this texel before the point, else 0.
Float covered_by_caster(TangentPlane p, Int x, Int y) {
  Vec4 caster = fetch_clamped(caster_position, x, y);
  Float z = in_face(view_coordinates(u.from_scene, Vec3(caster)), p.face, u.caster_depth).z;
  Bool blocked = in_map(x, y, texture_width(caster_position), texture_height(caster_position)) &&
                 caster.w != 0.0f && z < p.q.z;
  return sel(blocked, Float(1.0f), Float(0.0f));
}

Float caster_share(TangentPlane p) {
  Vec2 uv = view_uv(p.at, u.caster_window, u.caster_depth);
  Corners c = corners_at(uv, texture_width(caster_position), texture_height(caster_position));
  Float bottom = covered_by_caster(p, c.x0, c.y0) * (1.0f - c.fx) +
                 covered_by_caster(p, c.x0 + 1, c.y0) * c.fx;
  Float top = covered_by_caster(p, c.x0, c.y0 + 1) * (1.0f - c.fx) +
              covered_by_caster(p, c.x0 + 1, c.y0 + 1) * c.fx;
  return sel(view_w(p.at, u.caster_depth) > 0.0f, bottom * (1.0f - c.fy) + top * c.fy, Float(0.0f));
}

// What thin panes leave of the direct light.
Vec3 through_panes(TangentPlane p) {
  Vec2 uv = view_uv(p.at, u.pane_window, u.pane_depth);
  Bool inside = inside_unit(uv.x, uv.y) && view_w(p.at, u.pane_depth) > 0.0f;
  return sel(inside, Vec3(fetch_bilinear(pane_transmittance, uv.x, uv.y)), Vec3(1.0f));
}

// Does a receiver map see this point, and not something before it? Two texels' extents may lie between. In the map of
// the farthest receivers nothing must lie behind it either.
Bool receives(Texture receivers, TangentPlane p, bool farthest) {
  Vec2 uv = view_uv(p.at, u.receiver_window, u.receiver_depth);
  int width = texture_width(receivers);
  int height = texture_height(receivers);
  Int x = floor_to_int(uv.x * float(width));
  Int y = floor_to_int(uv.y * float(height));
  Vec4 receiver = fetch_clamped(receivers, x, y);
  Float seen = in_face(view_coordinates(u.from_scene, Vec3(receiver)), p.face, u.receiver_depth).z;
  Vec2 offset = face_offset(p.face, u.receiver_window, u.receiver_depth);
  Float z = plane_z(p, window_of(x, width, u.receiver_window.x, offset.x),
                    window_of(y, height, u.receiver_window.y, offset.y));
  Float extent = view_w(p.at, u.receiver_depth) *
                 max_of(Float(1.0f / (u.receiver_window.x * float(width))),
                        Float(1.0f / (u.receiver_window.y * float(height))));
  Bool near_enough = z <= seen + 2.0f * extent;
  if (farthest) near_enough = near_enough && z >= seen - 2.0f * extent;
  return inside_unit(uv.x, uv.y) && !stands_before_casters(p.at) && receiver.w != 0.0f && near_enough;
}

// Area of a caustic map's texel across the light, at a point on its face: flux in a texel over the receiver's area
// under it is texel area / |n.l|, or solid angle r^2 / |n.l|.
// `in_window`: its area in window units squared.
Float texel_area(Float in_window, Vec3 q, Float distance_squared) {
  Float area = in_window;
  if (u.light.w > 0.5f) {
    Float z = sel(q.z > 0.0f, q.z, Float(1.0f));
    Float x = q.x / z;
    Float y = q.y / z;
    Float squared = 1.0f + x * x + y * y;
    area = in_window / (squared * sqrt(squared)) * distance_squared;
  }
  return area;
}

// The flux at a point in texels of the face that sees it. What landed near a face's border may lie in the guard of
// its neighbour's tile, so the tiles of all faces that reach here add up: at most one along each axis.
Vec3 flux_all_around(Vec3 q) {
  Float own = texel_area(Float(u.caustic_texel.x), in_face(q, cube_face(q), u.caustic_depth), Float(1.0f));
  Vec3 flux = Vec3(0.0f);
  for (int axis = 0; axis < 3; axis++) {
    Float along = q.x;
    if (axis == 1) along = q.y;
    if (axis == 2) along = q.z;
    Int face = sel(along >= 0.0f, Int(2 * axis), Int(2 * axis + 1));
    Vec3 t = in_face(q, face, u.caustic_depth);
    // In the tile, all four texels around: half a texel from its border.
    Bool reaches = t.z > 0.0f && abs(t.x) * u.caustic_window.x <= t.z * u.caustic_texel.y &&
                   abs(t.y) * u.caustic_window.y <= t.z * u.caustic_texel.z;
    if (any_lane(reaches)) {
      Vec2 uv = face_uv(q, face, u.caustic_window, u.caustic_depth);
      Vec3 there = Vec3(fetch_bilinear(caustic_map, uv.x, uv.y));
      Float share = own / texel_area(Float(u.caustic_texel.x), t, Float(1.0f));
      flux = flux + sel(reaches, there * share, Vec3(0.0f));
    }
  }
  return flux;
}

// What a caustic is averaged over for a pixel: half of each side to either side of the point, in view coordinates,
// and by how many samples along each.
struct Footprint {
  Vec3 across;
  Vec3 upward;
  Float columns;
  Float rows;
};

// The step to a neighbouring pixel in view coordinates; none where that pixel shows something else.
Vec3 step_on_surface(Int column, Int row, int dx, int dy, Vec3 position, Vec3 n) {
  Vec3 offset = offset_to_neighbour(view_position, column, row, dx, dy, position);
  Float off_plane = dot3(offset, n);
  Bool same = off_plane * off_plane <= 0.25f * dot3(offset, offset);
  return sel(same, transform_vector(u.from_scene, offset), Vec3(0.0f));
}

// The larger side in the map of a step from a point, texels of the face that sees the point; 0 where the step ends
// behind the light.
Float texels_along(Vec3 at, Vec3 step, vec4 window, int size) {
  Int face = view_face(at, u.caustic_depth);
  Vec3 from = in_face(at, face, u.caustic_depth);
  Vec3 to = in_face(at + step, face, u.caustic_depth);
  Float texels = Float(0.0f);
  if (u.caustic_depth.z > 0.5f) {
    Bool before = from.z > 0.0f && to.z > 0.0f;
    Float near = sel(before, from.z, Float(1.0f));
    Float far = sel(before, to.z, Float(1.0f));
    texels = sel(before, max_of(abs(to.x / far - from.x / near) * window.x, abs(to.y / far - from.y / near) * window.y),
                 Float(0.0f));
  } else {
    texels = max_of(abs(to.x - from.x) * window.x, abs(to.y - from.y) * window.y);
  }
  return min_of(texels * float(size), Float(16384.0f));
}

// How much of a pixel's side of so many texels is left to average over. A texel is the mean over itself, and
// interpolation spreads it over two: together the variance of a box of sqrt 3 texels.
Float spread_of(Float texels) {
  return sqrt(max_of(texels * texels - 3.0f, 0.0f));
}

// A sample more than the texels that the spread spans.
Float samples_over(Float spread) {
  Float whole = Float(floor_to_int(spread));
  Float count = sel(whole < spread, whole + 2.0f, whole + 1.0f);
  return clamp_to(count, 1.0f, u.footprint.x);
}

// Is a point so far inside the cascade that all its light is there?
Bool in_cascade(Vec3 at) {
  Vec2 finer = view_uv(at, u.cascade_window, u.caustic_depth);
  return inside_unit(finer.x - u.cascade_texel.y, finer.y - u.cascade_texel.y) &&
         inside_unit(finer.x + u.cascade_texel.y, finer.y + u.cascade_texel.y);
}

// Of a point that `receives`; the others, and those whose pixel lies beside the map, count once.
Footprint footprint_at(Int column, Int row, Vec3 at, Vec3 position, Vec3 n, Bool receives) {
  Footprint f;
  f.across = step_on_surface(column, row, 1, 0, position, n);
  f.upward = step_on_surface(column, row, 0, 1, position, n);
  int size = texture_width(caustic_map);
  Float columns = texels_along(at, f.across, u.caustic_window, size);
  Float rows = texels_along(at, f.upward, u.caustic_window, size);
  if (u.cascade_texel.z > 0.5f) {
    Bool finer = in_cascade(at);
    columns = sel(finer, texels_along(at, f.across, u.cascade_window, size), columns);
    rows = sel(finer, texels_along(at, f.upward, u.cascade_window, size), rows);
  }
  Vec2 uv = view_uv(at, u.caustic_window, u.caustic_depth);
  Float reach = (columns + rows) / float(size);
  Bool counts = receives && uv.x > -reach && uv.y > -reach && uv.x < reach + 1.0f && uv.y < reach + 1.0f;
  Float wide = sel(counts, spread_of(columns), Float(0.0f));
  Float high = sel(counts, spread_of(rows), Float(0.0f));
  f.across = f.across * (wide / max_of(columns, 1.0f));
  f.upward = f.upward * (high / max_of(rows, 1.0f));
  f.columns = samples_over(wide);
  f.rows = samples_over(high);
  return f;
}

// The irradiance of caustics at a point near p, in view coordinates: flux over area times the cosine. `near` and
// `far` receivers take it or not as p does.
Vec3 caustic_at(Vec3 at, TangentPlane p, Float facing, Float distance_squared, Bool near, Bool far) {
  Vec3 flux = Vec3(0.0f);
  Bool inside = Bool(true);
  Float texel = Float(u.caustic_texel.x);
  if (u.caustic_depth.z > 1.5f) {
    flux = flux_all_around(at);
  } else {
    Vec2 uv = view_uv(at, u.caustic_window, u.caustic_depth);
    inside = inside_unit(uv.x, uv.y);
    flux = Vec3(fetch_bilinear(caustic_map, uv.x, uv.y));
    if (u.cascade_texel.z > 0.5f) {
      Vec2 finer = view_uv(at, u.cascade_window, u.caustic_depth);
      Bool reaches = in_cascade(at);
      flux = sel(reaches, Vec3(fetch_bilinear(cascade_map, finer.x, finer.y)), flux);
      texel = sel(reaches, Float(u.cascade_texel.x), texel);
      inside = inside || reaches;
    }
  }
  if (u.caustic_texel.w > 0.5f) flux = Vec3(flux.x);
  Float area = texel_area(texel, p.q, distance_squared);
  Vec3 caught = sel(near && inside, flux * (facing / area), Vec3(0.0f));
  if (u.cascade_texel.w > 0.5f) {
    Vec2 uv = view_uv(at, u.caustic_window, u.caustic_depth);
    Vec3 behind = Vec3(fetch_bilinear(far_caustic_map, uv.x, uv.y));
    if (u.caustic_texel.w > 0.5f) behind = Vec3(behind.x);
    Float far_area = texel_area(Float(u.caustic_texel.x), p.q, distance_squared);
    caught = caught + sel(far && inside_unit(uv.x, uv.y), behind * (facing / far_area), Vec3(0.0f));
  }
  return caught;
}

// A point and its share of what casters keep from it and give to it.
struct Caught {
  Float shadowed;
  Vec3 irradiance;
};

// The mean over what a pixel sees: at the point alone where that is hardly wider than a texel. The casters' shadow is
// averaged with their light, so that glass that bends nothing leaves no trace.
Caught caught_over(Footprint f, TangentPlane p, Float facing, Float distance_squared, Bool near, Bool far) {
  Caught sum;
  sum.shadowed = Float(0.0f);
  sum.irradiance = Vec3(0.0f);
  for (int j = 0; any_lane(float(j) < f.rows); j++) {
    Float along = (float(j) + 0.5f) / f.rows - 0.5f;
    for (int i = 0; any_lane(float(j) < f.rows && float(i) < f.columns); i++) {
      Bool counts = float(j) < f.rows && float(i) < f.columns;
      TangentPlane there;
      there.at = p.at + f.across * ((float(i) + 0.5f) / f.columns - 0.5f) + f.upward * along;
      there.face = p.face;
      there.q = in_face(there.at, p.face, u.shadow_range);
      there.normal = p.normal;
      Vec3 caught = caustic_at(there.at, p, facing, distance_squared, near, far);
      sum.shadowed = sum.shadowed + sel(counts, caster_share(there), Float(0.0f));
      sum.irradiance = sum.irradiance + sel(counts, caught, Vec3(0.0f));
    }
  }
  Float samples = f.columns * f.rows;
  sum.shadowed = sum.shadowed / samples;
  sum.irradiance = sum.irradiance / samples;
  return sum;
}

void main() {
  Int column = floor_to_int(frag_x());
  Int row = floor_to_int(frag_y());
  Vec4 surface = texel_fetch(view_position, column, row);
  Vec3 n = Vec3(texel_fetch(view_normal, column, row));
  Vec3 position = Vec3(surface);
  Bool visible = surface.w != 0.0f;

  // The light's direction, and what is left of its intensity here: lux across the light.
  Vec3 travel = Vec3(u.light);
  Float reaching = Float(1.0f);
  Float distance_squared = Float(1.0f);
  if (u.light.w > 0.5f) {
    Vec3 path = position - Vec3(u.light);
    distance_squared = max_of(dot3(path, path), 1.0e-20f);
    travel = normalize_or(path, Vec3(u.cone_axis));
    reaching = cone_falloff(travel);
    if (u.intensity.w > 0.0f) {
      // KHR_lights_punctual's window: 1 - (d / range)^4, clamped.
      Float s = distance_squared / (u.intensity.w * u.intensity.w);
      reaching = reaching * clamp_to(1.0f - s * s, 0.0f, 1.0f);
    }
  }
  Float facing = max_of(-dot3(n, travel), 0.0f);
  TangentPlane p;
  p.at = view_coordinates(u.from_scene, position);
  p.face = view_face(p.at, u.shadow_range);
  p.q = in_face(p.at, p.face, u.shadow_range);
  Vec3 plane = plane_normal(view_position, column, row, position, n);
  p.normal = in_face(transform_vector(u.from_scene, plane), p.face, u.shadow_range);

  Caught casters;
  casters.shadowed = Float(0.0f);
  casters.irradiance = Vec3(0.0f);
  if (u.uses.z > 0.5f) {
    Bool near = visible && receives(receiver_position, p, false);
    Bool far = Bool(false);
    if (u.cascade_texel.w > 0.5f) far = visible && receives(far_receiver_position, p, true);
    if (u.footprint.x > 0.5f) {
      Footprint f = footprint_at(column, row, p.at, position, n, near || far);
      casters = caught_over(f, p, facing, distance_squared, near, far);
    } else {
      casters.shadowed = caster_share(p);
      casters.irradiance = caustic_at(p.at, p, facing, distance_squared, near, far);
    }
  }
  caustic = Vec4(Vec3(u.intensity) * casters.irradiance, Float(0.0f));

  Float lit = Float(1.0f);
  Float turned = -dot3(plane, travel);
  Bool away = turned * dot3(plane, n) <= 0.0f;
  if (u.uses.x > 0.5f) lit = sel(away, Float(0.0f), 1.0f - shadow_share(p));
  if (u.uses.y > 0.5f) lit = lit * (1.0f - casters.shadowed);
  Float irradiance = facing * reaching * lit / distance_squared;
  irradiance = sel(visible, irradiance, Float(0.0f));
  Vec3 tint = Vec3(1.0f);
  if (u.uses.w > 0.5f) tint = through_panes(p);
#ifdef HAZE
  tint = tint * transmittance(Vec3(u.extinction), light_way(position, travel, Vec3(u.light), u.light.w > 0.5f));
#endif
  direct = Vec4(Vec3(u.intensity) * tint * irradiance, Float(0.0f));
}
#endif
