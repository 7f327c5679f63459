// Material textures: bilinear, repeated in both directions.
Vec4 fetch_repeat(Texture t, Float u, Float v) {
  Float x = (u - floor(u)) * Float(texture_width(t)) - 0.5f;
  Float y = (v - floor(v)) * Float(texture_height(t)) - 0.5f;
  Int x0 = floor_to_int(x);
  Int y0 = floor_to_int(y);
  Float fx = clamp_to(x - Float(x0), 0.0f, 1.0f);
  Float fy = clamp_to(y - Float(y0), 0.0f, 1.0f);
  Int width = Int(texture_width(t));
  Int height = Int(texture_height(t));
  Int xa = sel(x0 < 0, width - 1, x0);
  Int ya = sel(y0 < 0, height - 1, y0);
  Int xb = sel(xa + 1 >= width, Int(0), xa + 1);
  Int yb = sel(ya + 1 >= height, Int(0), ya + 1);
  Vec4 bottom = fetch_clamped(t, xa, ya) * (1.0f - fx) + fetch_clamped(t, xb, ya) * fx;
  Vec4 top = fetch_clamped(t, xa, yb) * (1.0f - fx) + fetch_clamped(t, xb, yb) * fx;
  return bottom * (1.0f - fy) + top * fy;
}

// Texture coordinates after KHR_texture_transform: rows of a matrix times (u, v, 1).
Vec2 transformed_uv(vec4 row0, vec4 row1, Vec2 uv) {
  return Vec2(row0.x * uv.x + row0.y * uv.y + row0.z, row1.x * uv.x + row1.y * uv.y + row1.z);
}
