// Material textures: bilinear, repeated in both directions.

// The four texels whose middles are around a place: columns and rows, and how far it is from the first to the
// others.
struct TexelsAround {
  Int xa;
  Int xb;
  Int ya;
  Int yb;
  Float fx;
  Float fy;
};

TexelsAround texels_around(Int width, Int height, Vec2 uv) {
  Float x = (uv.x - floor(uv.x)) * Float(width) - 0.5f;
  Float y = (uv.y - floor(uv.y)) * Float(height) - 0.5f;
  Int x0 = floor_to_int(x);
  Int y0 = floor_to_int(y);
  TexelsAround r;
  r.fx = clamp_to(x - Float(x0), 0.0f, 1.0f);
  r.fy = clamp_to(y - Float(y0), 0.0f, 1.0f);
  r.xa = sel(x0 < 0, width - 1, x0);
  r.ya = sel(y0 < 0, height - 1, y0);
  r.xb = sel(r.xa + 1 >= width, Int(0), r.xa + 1);
  r.yb = sel(r.ya + 1 >= height, Int(0), r.ya + 1);
  return r;
}

// Of a picture whose first texel is at (x, y).
Vec4 fetch_around(Texture t, IN(TexelsAround) r, Int x, Int y) {
  Vec4 bottom = fetch_clamped(t, x + r.xa, y + r.ya) * (1.0f - r.fx) +
                fetch_clamped(t, x + r.xb, y + r.ya) * r.fx;
  Vec4 top = fetch_clamped(t, x + r.xa, y + r.yb) * (1.0f - r.fx) +
             fetch_clamped(t, x + r.xb, y + r.yb) * r.fx;
  return bottom * (1.0f - r.fy) + top * r.fy;
}

Vec4 fetch_repeat(Texture t, Float u, Float v) {
  TexelsAround around = texels_around(Int(texture_width(t)), Int(texture_height(t)), Vec2(u, v));
  return fetch_around(t, around, Int(0), Int(0));
}

// Texture coordinates after KHR_texture_transform: rows of a matrix times (u, v, 1).
Vec2 transformed_uv(vec4 row0, vec4 row1, Vec2 uv) {
  return Vec2(row0.x * uv.x + row0.y * uv.y + row0.z, row1.x * uv.x + row1.y * uv.y + row1.z);
}
