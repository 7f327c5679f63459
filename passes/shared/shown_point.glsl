// Does a map of positions show the surface at p itself, to eight texels' extents? Needs view_space.glsl and
// position_texel.glsl.
Bool shows_point(Texture positions, IN(View) view, Vec3 p) {
  Vec3 q = view_coordinates(view, p);
  Vec2 uv = view_uv(view, q);
  Vec4 seen = fetch_nearest(positions, uv.x, uv.y);
  Float w = view_w(view, q);
  Float extent = w / (view.scale.x * float(texture_width(positions)));
  Float z = view_coordinates(view, Vec3(seen)).z;
  return w > 0.0f && inside_unit(uv.x, uv.y) && is_covered(seen) && abs(z - q.z) <= 8.0f * extent;
}
