// Texture coordinates after KHR_texture_transform.
Vec2 transformed_uv(IN(TextureTransform) t, Vec2 uv) {
  return Vec2(t.row0.x * uv.x + t.row0.y * uv.y + t.row0.z, t.row1.x * uv.x + t.row1.y * uv.y + t.row1.z);
}
