// What w means in a texture of positions or normals: 0 where there is no surface, negative on a back face.
Bool is_covered(Vec4 texel) { return texel.w != 0.0f; }
Bool is_back_face(Vec4 texel) { return texel.w < 0.0f; }
// Of a caster: its triangle's number in the hierarchy; -1: it is not there.
Float triangle_number(Vec4 texel) { return abs(texel.w) - 2.0f; }
// Of a blended surface: does it lie before glass or metal?
Bool is_before_glass(Vec4 texel) { return texel.w > 1.5f; }
// Is it what glass or a pane scatters? That adds to what `glass` shows there.
Bool is_on_glass(Vec4 texel) { return texel.w > 2.5f; }
// Of what only glass shows: is it blended?
Bool is_blended(Vec4 texel) { return texel.w > 1.5f; }
// Of an interpolated texel: were all four covered?
Bool is_fully_covered(Vec4 texel) { return texel.w > 0.999f; }
