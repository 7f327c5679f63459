// Blended surfaces before glass. Needs position_texel.glsl and the reads of layer_reads.hpp.

Vec3 behind_layers(Vec3 color, Int column, Int row) {
  Vec4 first = fetch_clamped(first_layer, column, row);
  Vec4 over = fetch_clamped(layers, column, row);
  return sel(is_before_glass(first), Vec3(over) + color * over.w, color);
}
