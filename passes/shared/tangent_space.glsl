// Normal textures (glTF 2.0, 3.9.3).

// A texel's normal in tangent space: 0..1 stands for -1..1, x and y are scaled. Not of unit length.
Vec3 tangent_space_normal(Vec4 texel, Float scale) {
  return Vec3((texel.x * 2.0f - 1.0f) * scale, (texel.y * 2.0f - 1.0f) * scale, texel.z * 2.0f - 1.0f);
}

// That normal in scene space, of unit length: around the unit normal n, by the vertex's tangent (w:
// handedness).
Vec3 leaned_normal(Vec3 n, Vec4 tangent, Vec3 local) {
  Vec3 raw = Vec3(tangent);
  Vec3 t = normalize_or(raw - n * dot3(n, raw), Vec3(1.0f, 0.0f, 0.0f));
  Vec3 b = cross3(n, t) * tangent.w;
  return normalize_or(t * local.x + b * local.y + n * local.z, n);
}
