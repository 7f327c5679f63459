// What stands between the light and a surface: opaque surfaces, casters, thin panes. Needs
// tangent_plane.glsl.

// The four texels around map coordinates, from (x0, y0) on, and how far the coordinates are from that one's
// centre.
struct Corners {
  Int x0;
  Int y0;
  Float fx;
  Float fy;
};

Corners corners_at(Texture map, Vec2 uv) {
  Corners c;
  Float x = uv.x * float(texture_width(map)) - 0.5f;
  Float y = uv.y * float(texture_height(map)) - 0.5f;
  c.x0 = floor_to_int(x);
  c.y0 = floor_to_int(y);
  c.fx = clamp_to(x - Float(c.x0), 0.0f, 1.0f);
  c.fy = clamp_to(y - Float(c.y0), 0.0f, 1.0f);
  return c;
}

// Bilinear interpolation between the four texels' values, named by column and row.
Float interpolated(IN(Corners) c, Float v00, Float v10, Float v01, Float v11) {
  Float bottom = v00 * (1.0f - c.fx) + v10 * c.fx;
  Float top = v01 * (1.0f - c.fx) + v11 * c.fx;
  return bottom * (1.0f - c.fy) + top * c.fy;
}

Bool in_map(Texture map, Int x, Int y) {
  return x >= 0 && x < texture_width(map) && y >= 0 && y < texture_height(map);
}

// 1 where an opaque surface at this texel lies before the plane, else 0.
Float occluded(IN(TangentPlane) p, Int x, Int y, Float bias) {
  Float z = plane_z(p, window_at(shadow_depth, u.shadow_view, p.face, x, y));
  Float stored = fetch_clamped(shadow_depth, x, y).x;
  // What lies behind the point cannot shadow it, even where the plane runs on far behind.
  Bool blocked = in_map(shadow_depth, x, y) && stored < min_of(z, p.q.z) - bias;
  return sel(blocked, Float(1.0f), Float(0.0f));
}

// The share of a point's light that opaque surfaces take.
Float shadow_share(IN(TangentPlane) p) {
  Corners c = corners_at(shadow_depth, view_uv(u.shadow_view, p.at));
  // A map knows where a surface lies to a texel's extent across the light. What is nearer to the plane
  // than that, measured across the plane, is the surface itself: along the light, the extent over the slope.
  Float slant = 1.0f / max_of(abs(plane_slope(p)), 0.02f);
  Float bias = slant * view_w(u.shadow_view, p.at) * texel_side(shadow_depth, u.shadow_view);
  Float share = interpolated(c, occluded(p, c.x0, c.y0, bias), occluded(p, c.x0 + 1, c.y0, bias),
                             occluded(p, c.x0, c.y0 + 1, bias), occluded(p, c.x0 + 1, c.y0 + 1, bias));
  return sel(view_w(u.shadow_view, p.at) > 0.0f, share, Float(0.0f));
}

// 1 where a caster covers this texel before z, else 0.
Float covered_by_caster(Int x, Int y, Int face, Float z) {
  Vec4 caster = fetch_clamped(caster_position, x, y);
  Float caster_z = in_face(u.caster_view, view_coordinates(u.caster_view, Vec3(caster)), face).z;
  Bool blocked = in_map(caster_position, x, y) && is_covered(caster) && caster_z < z;
  return sel(blocked, Float(1.0f), Float(0.0f));
}

// How much nearer than a place a caster has to be: what glass scatters lies on it, and the map knows that to
// a texel's extent, or its diagonal.
Float caster_bias(IN(TangentPlane) p, Vec3 at) {
  Float bias = Float(0.0f);
  if (u.is_layer != 0) {
    Float slant = 1.5f / max_of(abs(plane_slope(p)), 0.02f);
    bias = slant * view_w(u.caster_view, at) * texel_side(caster_position, u.caster_view);
  }
  return bias;
}

// The share of the light that casters take from a place on a plane, in view coordinates.
Float caster_share(IN(TangentPlane) p, Vec3 at) {
  Corners c = corners_at(caster_position, view_uv(u.caster_view, at));
  Bool reaches = c.x0 >= -1 && c.x0 < texture_width(caster_position) && c.y0 >= -1 &&
                 c.y0 < texture_height(caster_position) && view_w(u.caster_view, at) > 0.0f;
  Float share = Float(0.0f);
  if (any_lane(reaches)) {
    Int face = p.face;
    Float z = in_face(u.caster_view, at, face).z - caster_bias(p, at);
    Float within = interpolated(
        c, covered_by_caster(c.x0, c.y0, face, z), covered_by_caster(c.x0 + 1, c.y0, face, z),
        covered_by_caster(c.x0, c.y0 + 1, face, z), covered_by_caster(c.x0 + 1, c.y0 + 1, face, z));
    share = sel(reaches, within, share);
  }
  return share;
}

// Does light come to this place before it has passed the caster that covers it? What that sends on lands
// elsewhere.
Bool stands_before_caster(IN(TangentPlane) p) {
  Vec2 uv = view_uv(u.caster_view, p.at);
  Int x = floor_to_int(uv.x * float(texture_width(caster_position)));
  Int y = floor_to_int(uv.y * float(texture_height(caster_position)));
  Float z = p.q.z - caster_bias(p, p.at);
  Bool covers = in_map(caster_position, x, y) && is_covered(fetch_clamped(caster_position, x, y));
  return covers && view_w(u.caster_view, p.at) > 0.0f && covered_by_caster(x, y, p.face, z) == 0.0f;
}

// What thin panes leave of the light at a point in view coordinates.
Vec3 through_panes(Vec3 at) {
  Vec2 uv = view_uv(u.pane_view, at);
  Bool inside = inside_unit(uv.x, uv.y) && view_w(u.pane_view, at) > 0.0f;
  return sel(inside, Vec3(fetch_bilinear(pane_transmittance, uv.x, uv.y)), Vec3(1.0f));
}
