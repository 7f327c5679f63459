// glTF's alpha mask: is the base colour's alpha below the cutoff here? Nearest texel, repeated.
// Expects the texture base_color and the uniforms alpha, uv_row0, uv_row1.
Bool cut_out(Vec2 uv) {
  Float u1 = u.uv_row0.x * uv.x + u.uv_row0.y * uv.y + u.uv_row0.z;
  Float v1 = u.uv_row1.x * uv.x + u.uv_row1.y * uv.y + u.uv_row1.z;
  Float opacity = Float(u.alpha.x);
  if (u.alpha.z > 0.5f) {
    Vec4 texel = fetch_nearest(base_color, u1 - floor(u1), v1 - floor(v1));
    opacity = opacity * texel.w;
  }
  return opacity < u.alpha.y;
}
