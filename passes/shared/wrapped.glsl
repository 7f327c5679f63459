// Where texture coordinates lie on the picture, 0..1, by the sampler's wrap modes (glTF 2.0, 5.26).
Float wrapped_along(Float c, Int mode) {
  Float turns = c * 0.5f - floor(c * 0.5f);
  Float place = sel(mode == WRAP_MIRROR, min_of(turns, 1.0f - turns) * 2.0f, c - floor(c));
  return sel(mode == WRAP_CLAMP, clamp_to(c, 0.0f, 1.0f), place);
}

Vec2 wrapped(IN(TextureTransform) how, Vec2 uv) {
  return Vec2(wrapped_along(uv.x, Int(how.wrap_u)), wrapped_along(uv.y, Int(how.wrap_v)));
}
