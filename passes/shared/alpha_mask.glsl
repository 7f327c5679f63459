// glTF's alpha mask: is the base colour's alpha below the cutoff here? Nearest texel. Expects the texture
// base_color. Needs wrapped.glsl.
Bool cut_out(IN(AlphaMask) mask, Vec2 uv) {
  Float u = mask.uv.row0.x * uv.x + mask.uv.row0.y * uv.y + mask.uv.row0.z;
  Float v = mask.uv.row1.x * uv.x + mask.uv.row1.y * uv.y + mask.uv.row1.z;
  Float opacity = Float(mask.opacity);
  if (mask.textured != 0) {
    Vec2 place = wrapped(mask.uv, Vec2(u, v));
    Vec4 texel = fetch_nearest(base_color, place.x, place.y);
    opacity = opacity * texel.w;
  }
  return opacity < mask.cutoff;
}
