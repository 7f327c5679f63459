// The surface's tangent plane in view coordinates, to compare depths where a map's texel is instead of
// where the shaded point is: that leaves nothing of the usual slope for a bias to hide. It is the
// triangle's plane, which is what the maps drew; shading normals lean away from it.
struct TangentPlane {
  Vec3 at;      // the point
  Int face;     // of a cube: the face that sees it
  Vec3 q;       // the point and
  Vec3 normal;  // the normal in that face's axes; in other views in the view's
};

TangentPlane tangent_plane(IN(View) view, Vec3 position, Vec3 normal) {
  TangentPlane p;
  p.at = view_coordinates(view, position);
  p.face = view_face(view, p.at);
  p.q = in_face(view, p.at, p.face);
  p.normal = in_face(view, transform_vector(view.from_scene, normal), p.face);
  return p;
}

// A plane steeper than 1 in 500 against the light counts as that steep: what is left of it is rounding.
Float steep_limited(Float slope) {
  return sel(slope < 0.0f, min_of(slope, Float(-0.002f)), max_of(slope, Float(0.002f)));
}

// Cosine between the plane's normal and the light's axis, or the ray from a light with a position.
Float plane_slope(IN(TangentPlane) p) {
  Float slope = p.normal.z;
  if (u.light.has_position != 0) slope = dot3(p.normal, p.q) / max_of(length3(p.q), 1.0e-20f);
  return slope;
}

// z of the plane at window coordinates; in a perspective view within half and twice the point's own.
Float plane_z(IN(TangentPlane) p, Vec2 at) {
  Float z = p.q.z;
  if (u.light.has_position != 0) {
    Float along = steep_limited(p.normal.x * at.x + p.normal.y * at.y + p.normal.z);
    z = clamp_to(dot3(p.normal, p.q) / along, p.q.z * 0.5f, p.q.z * 2.0f);
  } else {
    // From the point, so that no large numbers cancel.
    z = p.q.z - (p.normal.x * (at.x - p.q.x) + p.normal.y * (at.y - p.q.y)) / steep_limited(p.normal.z);
  }
  return z;
}

// Window coordinates of a texel's centre, in a cube those of a face: window coordinate 0 lies at the face's
// offset.
Vec2 window_at(Texture map, IN(View) view, Int face, Int x, Int y) {
  Vec2 offset = face_offset(view, face);
  return Vec2(((Float(x) + 0.5f) / float(texture_width(map)) - offset.x) / view.scale.x,
              ((Float(y) + 0.5f) / float(texture_height(map)) - offset.y) / view.scale.y);
}

// The larger side of a map's texel, in window units.
Float texel_side(Texture map, IN(View) view) {
  return max_of(Float(1.0f / (view.scale.x * float(texture_width(map)))),
                Float(1.0f / (view.scale.y * float(texture_height(map)))));
}
