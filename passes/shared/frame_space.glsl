// Frames as pipeline/scene/frame.hpp defines them: from_scene, window and depth are a FrameUniforms.

// Frame coordinates of a scene-space point: x, y across, z along the view, metres.
Vec3 frame_coordinates(mat4 from_scene, Vec3 p) {
  Vec4 q = transform_point(from_scene, p);
  return Vec3(q.x, q.y, q.z);
}

// What window coordinates are divided by: z in a perspective frame, else 1.
Float frame_w(Vec3 q, vec4 depth) {
  Float w = Float(1.0f);
  if (depth.z > 0.5f) w = q.z;
  return w;
}

// Map coordinates (u, v) of frame coordinates; (-1, -1) behind a perspective frame's origin.
Vec2 frame_uv(Vec3 q, vec4 window, vec4 depth) {
  Float w = frame_w(q, depth);
  Bool front = w > 0.0f;
  Float safe = sel(front, w, Float(1.0f));
  return sel(front, Vec2(q.x / safe * window.x + window.z, q.y / safe * window.y + window.w),
             Vec2(Float(-1.0f), Float(-1.0f)));
}

// Clip coordinates of frame coordinates, window depth 0 (near) to 1 (far).
Vec4 frame_clip(Vec3 q, vec4 window, vec4 depth) {
  Float w = frame_w(q, depth);
  Float range = Float(depth.y - depth.x);
  Float z = (q.z - depth.x) / range;
  if (depth.z > 0.5f) z = z * depth.y;
  return Vec4(2.0f * (q.x * window.x + window.z * w) - w,
              2.0f * (q.y * window.y + window.w * w) - w, z, w);
}
