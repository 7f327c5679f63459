// Blended surfaces that the camera sees directly. Needs position_texel.glsl and the reads of layer_reads.hpp.

// `left`: of their radiance; `is_glass`: the pixel shows glass or metal, behind which no layer is.
Vec3 behind_layers(Vec3 color, Vec3 left, Bool is_glass, Int column, Int row) {
  Vec4 first = fetch_clamped(first_layer, column, row);
  Vec4 over = fetch_clamped(layers, column, row);
  Bool before = is_covered(first) && (is_before_glass(first) || !is_glass);
  return sel(before, Vec3(over) * left + color * over.w, color);
}
