// The irradiance of caustics at a point: flux in a texel of the caustic map over the texel's area on the
// receiver. Needs tangent_plane.glsl.

// Does a receiver map see this point, and not something before it? Two texels' extents may lie between. In
// the map of the farthest receivers nothing must lie behind it either.
Bool receives(Texture receivers, IN(TangentPlane) p, bool farthest) {
  Vec2 uv = view_uv(u.receiver_view, p.at);
  Int x = floor_to_int(uv.x * float(texture_width(receivers)));
  Int y = floor_to_int(uv.y * float(texture_height(receivers)));
  Vec4 receiver = fetch_clamped(receivers, x, y);
  Float seen = in_face(u.receiver_view, view_coordinates(u.receiver_view, Vec3(receiver)), p.face).z;
  Float z = plane_z(p, window_at(receivers, u.receiver_view, p.face, x, y));
  Float extent = view_w(u.receiver_view, p.at) * texel_side(receivers, u.receiver_view);
  Bool near_enough = z <= seen + 2.0f * extent;
  if (farthest) near_enough = near_enough && z >= seen - 2.0f * extent;
  return inside_unit(uv.x, uv.y) && !stands_before_casters(u.column, u.casters_nearest, p.at) &&
         is_covered(receiver) && near_enough;
}

// Whose light a point takes: that of the receivers nearest to the light, and of the farthest.
struct Reception {
  Bool near;
  Bool far;
};

Reception reception_of(IN(SurfacePoint) surface, IN(TangentPlane) p) {
  Reception takes;
  takes.near = surface.visible && receives(receiver_position, p, false);
  takes.far = Bool(false);
  if (u.receivers_are_layered != 0) takes.far = surface.visible && receives(far_receiver_position, p, true);
  return takes;
}

// Area of a caustic map's texel across the light, at a point on its face: flux in a texel over the receiver's
// area under it is texel area / |n.l|, or solid angle r^2 / |n.l|. `in_window`: its area in window units
// squared.
Float texel_area(Float in_window, Vec3 q, Float distance_squared) {
  Float area = in_window;
  if (u.light.has_position != 0) {
    Float z = sel(q.z > 0.0f, q.z, Float(1.0f));
    Float x = q.x / z;
    Float y = q.y / z;
    Float squared = 1.0f + x * x + y * y;
    area = in_window / (squared * sqrt(squared)) * distance_squared;
  }
  return area;
}

// What a caustic map holds at a point.
struct Deposit {
  Vec3 flux;         // in a texel, relative to the light's intensity
  Float texel_area;  // that texel's, window units squared
  Bool inside;       // the map reaches here
};

// The flux at a point in texels of the face that sees it. What landed near a face's border may lie in the
// guard of its neighbour's tile, so the tiles of all faces that reach here add up: at most one along each
// axis.
Vec3 flux_all_around(Vec3 q) {
  Float in_window = Float(u.caustic_texel_area);
  Float own = texel_area(in_window, in_face(u.caustic_view, q, cube_face(q)), Float(1.0f));
  Vec3 flux = Vec3(0.0f);
  for (int axis = 0; axis < 3; axis++) {
    Float along = q.x;
    if (axis == 1) along = q.y;
    if (axis == 2) along = q.z;
    Int face = sel(along >= 0.0f, Int(2 * axis), Int(2 * axis + 1));
    Vec3 t = in_face(u.caustic_view, q, face);
    // In the tile, all four texels around: half a texel from its border.
    Bool reaches = t.z > 0.0f && abs(t.x) * u.caustic_view.scale.x <= t.z * u.tile_reach.x &&
                   abs(t.y) * u.caustic_view.scale.y <= t.z * u.tile_reach.y;
    if (any_lane(reaches)) {
      Vec2 uv = face_uv(u.caustic_view, q, face);
      Vec3 there = Vec3(fetch_bilinear(caustic_map, uv.x, uv.y));
      Float share = own / texel_area(in_window, t, Float(1.0f));
      flux = flux + sel(reaches, there * share, Vec3(0.0f));
      TRACE(caustic_map_at, Vec3(uv.x, uv.y, share));
    }
  }
  return flux;
}

// Is a texel of the caustic map so far inside the cascade that all its light is there? Points in it take
// their light from the cascade, and no others do: so none is shown twice.
Bool is_in_cascade(Int column, Int row) {
  Float x = Float(column) * u.cascade_step.x + u.cascade_from.x;
  Float y = Float(row) * u.cascade_step.y + u.cascade_from.y;
  return inside_unit(x - u.cascade_border, y - u.cascade_border) &&
         inside_unit(x + (u.cascade_step.x + u.cascade_border), y + (u.cascade_step.y + u.cascade_border));
}

// Is a point in the cascade, or so far beside it, in its coordinates?
Bool is_near_cascade(Vec3 at, Vec2 beside) {
  Vec2 finer = view_uv(u.cascade_view, at);
  return inside_unit((finer.x + beside.x) / (beside.x * 2.0f + 1.0f),
                     (finer.y + beside.y) / (beside.y * 2.0f + 1.0f));
}

Bool cascade_shows(Vec2 uv) {
  return is_in_cascade(floor_to_int(uv.x * u.caustic_side), floor_to_int(uv.y * u.caustic_side));
}

// Returns the bilinear weight of a texel of the caustic map at a point, which is given in texels from the
// first texel's middle; 0 for a texel that the cascade shows.
Float weight_beside(Int column, Int row, Float x, Float y) {
  Float weight = (1.0f - abs(x - Float(column))) * (1.0f - abs(y - Float(row)));
  Int last = Int(texture_width(caustic_map) - 1);
  Bool shown = is_in_cascade(clamp_to(column, Int(0), last), clamp_to(row, Int(0), last));
  return sel(shown, Float(0.0f), weight);
}

// The caustic map's flux at a point, which the cascade does not show.
Vec3 flux_beside_cascade(Vec2 uv) {
  Float x = uv.x * u.caustic_side - 0.5f;
  Float y = uv.y * u.caustic_side - 0.5f;
  Int column = floor_to_int(x);
  Int row = floor_to_int(y);
  Float all = Float(0.0f);
  for (int k = 0; k < 4; k++) all = all + weight_beside(column + (k & 1), row + k / 2, x, y);
  Vec3 sum = Vec3(0.0f);
  for (int k = 0; k < 4; k++) {
    Float share = weight_beside(column + (k & 1), row + k / 2, x, y) / max_of(all, 1.0e-4f);
    sum = sum + Vec3(fetch_clamped(caustic_map, column + (k & 1), row + k / 2)) * share;
    TRACE(caustic_map_at, Vec3((Float(column + (k & 1)) + 0.5f) / u.caustic_side,
                               (Float(row + k / 2) + 0.5f) / u.caustic_side, share));
  }
  return sum;
}

// A map of one channel has the same flux in all.
Vec3 flux_by_channel(Vec3 flux) {
  Vec3 all = flux;
  if (u.caustic_is_grey != 0) all = Vec3(flux.x);
  return all;
}

// By the caustic map, or by the cascade where that has the point.
Deposit deposit_at(Vec3 at) {
  Deposit d;
  d.inside = Bool(true);
  d.texel_area = Float(u.caustic_texel_area);
  if (u.caustic_view.kind == VIEW_CUBE) {
    d.flux = flux_all_around(at);
  } else {
    Vec2 uv = view_uv(u.caustic_view, at);
    d.inside = inside_unit(uv.x, uv.y);
    Bool reaches = Bool(false);
    Bool beside = Bool(false);
    if (u.has_cascade != 0) {
      reaches = cascade_shows(uv);
      beside = !reaches && is_near_cascade(at, Vec2(u.cascade_step.x, u.cascade_step.y));
    }
    d.flux = Vec3(0.0f);
    if (any_lane(!beside)) {
      d.flux = Vec3(fetch_bilinear(caustic_map, uv.x, uv.y));
      TRACE(caustic_map_at, Vec3(uv.x, uv.y, Float(1.0f)));
    }
    if (u.has_cascade != 0) {
      Vec2 finer = view_uv(u.cascade_view, at);
      if (any_lane(beside)) d.flux = sel(beside, flux_beside_cascade(uv), d.flux);
      if (any_lane(reaches)) {
        d.flux = sel(reaches, Vec3(fetch_bilinear(cascade_map, finer.x, finer.y)), d.flux);
        TRACE(cascade_map_at, Vec3(finer.x, finer.y, Float(1.0f)));
      }
      d.texel_area = sel(reaches, Float(u.cascade_texel_area), d.texel_area);
      d.inside = d.inside || reaches;
    }
  }
  d.flux = flux_by_channel(d.flux);
  return d;
}

// The same of the map of the farthest receivers.
Deposit far_deposit_at(Vec3 at) {
  Deposit d;
  Vec2 uv = view_uv(u.caustic_view, at);
  d.inside = inside_unit(uv.x, uv.y);
  d.texel_area = Float(u.caustic_texel_area);
  d.flux = flux_by_channel(Vec3(fetch_bilinear(far_caustic_map, uv.x, uv.y)));
  TRACE(far_caustic_map_at, Vec3(uv.x, uv.y, Float(1.0f)));
  return d;
}

// The irradiance of caustics at a point near `q`, both in view coordinates: flux over area times the cosine.
Vec3 caustic_at(Vec3 at, Vec3 q, IN(Incidence) light, IN(Reception) takes) {
  Deposit d = deposit_at(at);
  Float area = texel_area(d.texel_area, q, light.distance_squared);
  Float per_flux = light.facing / area;
  Vec3 irradiance = sel(takes.near && d.inside, d.flux * per_flux, Vec3(0.0f));
  TRACE(irradiance_of_flux, per_flux);
  TRACE(irradiance, irradiance);
  if (u.receivers_are_layered != 0) {
    Deposit behind = far_deposit_at(at);
    Float far_area = texel_area(behind.texel_area, q, light.distance_squared);
    Float far_per_flux = light.facing / far_area;
    Vec3 added = sel(takes.far && behind.inside, behind.flux * far_per_flux, Vec3(0.0f));
    irradiance = irradiance + added;
    TRACE(irradiance_of_flux, far_per_flux);
    TRACE(irradiance, added);
  }
  return irradiance;
}
