// Between scene space, view coordinates and maps (pipeline/shader/view.glsl). Needs cube_atlas.glsl.

// View coordinates of a scene-space point: x, y across, z along the view, metres.
Vec3 view_coordinates(IN(View) view, Vec3 p) {
  Vec4 q = transform_point(view.from_scene, p);
  return Vec3(q.x, q.y, q.z);
}

// The face of a cube that sees q; of other views the only one.
Int view_face(IN(View) view, Vec3 q) {
  Int face = Int(FACE_FORWARD);
  if (view.kind == VIEW_CUBE) face = cube_face(q);
  return face;
}

// View coordinates, or a direction in the view's axes, as a face sees them: its z is along the face.
Vec3 in_face(IN(View) view, Vec3 q, Int face) {
  Vec3 turned = q;
  if (view.kind == VIEW_CUBE) turned = cube_turned(q, face);
  return turned;
}

// What window coordinates are divided by: z in a perspective view, z of its own face in a cube, else 1.
Float view_w(IN(View) view, Vec3 q) {
  Float w = Float(1.0f);
  if (view.kind == VIEW_PERSPECTIVE) w = q.z;
  if (view.kind == VIEW_CUBE) w = max_of(max_of(abs(q.x), abs(q.y)), abs(q.z));
  return w;
}

// Where window coordinate 0 of a face lies in the map.
Vec2 face_offset(IN(View) view, Int face) {
  Vec2 offset = Vec2(Float(view.offset.x), Float(view.offset.y));
  if (view.kind == VIEW_CUBE) {
    Vec2 middle = cube_middle(face);
    offset = Vec2(middle.x * view.offset.x, middle.y * view.offset.y);
  }
  return offset;
}

// Map coordinates (u, v) of view coordinates on a given face; (-1, -1) behind it.
Vec2 face_uv(IN(View) view, Vec3 q, Int face) {
  Vec3 t = cube_turned(q, face);
  Bool front = t.z > 0.0f;
  Float safe = sel(front, t.z, Float(1.0f));
  Vec2 offset = face_offset(view, face);
  return sel(front, Vec2(t.x / safe * view.scale.x + offset.x, t.y / safe * view.scale.y + offset.y),
             Vec2(Float(-1.0f), Float(-1.0f)));
}

// Map coordinates (u, v) of view coordinates; (-1, -1) behind a perspective view's origin.
Vec2 view_uv(IN(View) view, Vec3 q) {
  Vec2 uv = Vec2(Float(0.0f), Float(0.0f));
  if (view.kind == VIEW_CUBE) {
    uv = face_uv(view, q, cube_face(q));
  } else {
    Float w = view_w(view, q);
    Bool front = w > 0.0f;
    Float safe = sel(front, w, Float(1.0f));
    uv = sel(front,
             Vec2(q.x / safe * view.scale.x + view.offset.x, q.y / safe * view.scale.y + view.offset.y),
             Vec2(Float(-1.0f), Float(-1.0f)));
  }
  return uv;
}

// Clip coordinates of view coordinates, window depth 0 (near) to 1 (far). Of a cube: in the tile of the face
// that is drawn, view.face; what reaches over its border is for outside_tile.
Vec4 view_clip(IN(View) view, Vec3 q) {
  Int face = Int(view.face);
  Vec3 t = in_face(view, q, face);
  Vec2 offset = face_offset(view, face);
  Float w = Float(1.0f);
  if (view.kind != VIEW_PARALLEL) w = t.z;
  Float range = Float(view.far - view.near);
  Float z = (t.z - view.near) / range;
  if (view.kind != VIEW_PARALLEL) z = z * view.far;
  return Vec4(2.0f * (t.x * view.scale.x + offset.x * w) - w,
              2.0f * (t.y * view.scale.y + offset.y * w) - w, z, w);
}
