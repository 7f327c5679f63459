// glTF's alpha mask: is the base colour's alpha below the cutoff here? Nearest texel, repeated. Expects the
// texture base_color.
Bool cut_out(IN(AlphaMask) mask, Vec2 uv) {
  Float u = mask.uv.row0.x * uv.x + mask.uv.row0.y * uv.y + mask.uv.row0.z;
  Float v = mask.uv.row1.x * uv.x + mask.uv.row1.y * uv.y + mask.uv.row1.z;
  Float opacity = Float(mask.opacity);
  if (mask.textured != 0) {
    Vec4 texel = fetch_nearest(base_color, u - floor(u), v - floor(v));
    opacity = opacity * texel.w;
  }
  return opacity < mask.cutoff;
}
