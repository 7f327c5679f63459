// Where texture coordinates lie on the picture, 0..1, by the sampler's wrap modes (glTF 2.0, 5.26).
Float wrapped_along(Float c, int mode) {
  Float place = c - floor(c);
  if (mode == WRAP_CLAMP) place = clamp_to(c, 0.0f, 1.0f);
  if (mode == WRAP_MIRROR) {
    Float turns = c * 0.5f - floor(c * 0.5f);
    place = min_of(turns, 1.0f - turns) * 2.0f;
  }
  return place;
}

Vec2 wrapped(IN(TextureTransform) how, Vec2 uv) {
  return Vec2(wrapped_along(uv.x, how.wrap_u), wrapped_along(uv.y, how.wrap_v));
}
