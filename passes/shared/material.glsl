// Material textures: bilinear, repeated, clamped or mirrored by their samplers. Needs wrapped.glsl.

// Along an axis: the two texels whose middles are around a place, and how far it is from the first to the
// other.
struct TexelPair {
  Int a;
  Int b;
  Float between;
};

// `place`: on the picture, 0..1.
TexelPair texels_around(Int side, Float place, Int mode) {
  Float x = place * Float(side) - 0.5f;
  Int first = floor_to_int(x);
  // Mirrored, a border lies beside itself, as where it is clamped.
  Bool repeats = mode == WRAP_REPEAT;
  TexelPair r;
  r.between = clamp_to(x - Float(first), 0.0f, 1.0f);
  r.a = sel(first < 0, sel(repeats, side - 1, Int(0)), first);
  r.b = sel(first + 1 >= side, sel(repeats, Int(0), side - 1), first + 1);
  return r;
}

// Of a picture whose first texel is at (x, y).
Vec4 fetch_around(Texture t, IN(TexelPair) columns, IN(TexelPair) rows, Int x, Int y) {
  Vec4 bottom = fetch_clamped(t, x + columns.a, y + rows.a) * (1.0f - columns.between) +
                fetch_clamped(t, x + columns.b, y + rows.a) * columns.between;
  Vec4 top = fetch_clamped(t, x + columns.a, y + rows.b) * (1.0f - columns.between) +
             fetch_clamped(t, x + columns.b, y + rows.b) * columns.between;
  return bottom * (1.0f - rows.between) + top * rows.between;
}

Vec4 fetch_between(Texture t, IN(TextureTransform) how, Vec2 place) {
  TexelPair columns = texels_around(Int(texture_width(t)), place.x, Int(how.wrap_u));
  TexelPair rows = texels_around(Int(texture_height(t)), place.y, Int(how.wrap_v));
  return fetch_around(t, columns, rows, Int(0), Int(0));
}

// `uv`: after the transform. A sampler may ask for the nearest texel.
Vec4 fetch_wrapped(Texture t, IN(TextureTransform) how, Vec2 uv) {
  Vec2 place = wrapped(how, uv);
  Vec4 texel = Vec4(0.0f);
  if (how.nearest != 0) {
    texel = fetch_nearest(t, place.x, place.y);
  } else {
    texel = fetch_between(t, how, place);
  }
  return texel;
}
