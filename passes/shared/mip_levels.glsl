// A material's textures as the camera sees them: of a texture's levels (pipeline/scene/mip_levels.hpp) those
// whose texels are about as large as what is seen, between two of them mixed. Needs material.glsl,
// transformed_uv.glsl.

// Where a pixel looks on the mesh's texture coordinates, and how far u and v reach over what it sees there.
struct SeenUv {
  Vec2 at;
  Vec2 reach;
};

// A side of a level.
Int level_side(int side, Int level) {
  return max_of(floor_to_int(float(side) * exp2_of_whole(-level)), Int(1));
}

// `place`: on the picture, 0..1.
Vec4 fetch_finest(Texture t, IN(SurfaceTexture) use, Vec2 place) {
  TexelPair columns = texels_around(Int(texture_width(t)), place.x, Int(use.uv.wrap_u));
  TexelPair rows = texels_around(Int(texture_height(t)), place.y, Int(use.uv.wrap_v));
  if (use.uv.nearest != 0) {
    columns.between = floor(columns.between + 0.5f);
    rows.between = floor(rows.between + 0.5f);
  }
  return fetch_around(t, columns, rows, Int(0), Int(0));
}

Vec4 fetch_level(Texture t, Texture coarser, IN(SurfaceTexture) use, Int level, Vec2 place) {
  Bool finest = level < 1;
  Vec4 texel = Vec4(Float(0.0f), Float(0.0f), Float(0.0f), Float(0.0f));
  if (any_lane(finest)) texel = fetch_finest(t, use, place);
  if (any_lane(!finest)) {
    Int width = level_side(texture_width(t), level);
    Int height = level_side(texture_height(t), level);
    Int x = sel(level > 1, level_side(texture_width(t), Int(1)), Int(0));
    Int y = Int(0);
    for (int k = 2; any_lane(level > k); k++)
      y = y + sel(level > k, level_side(texture_height(t), Int(k)), Int(0));
    TexelPair columns = texels_around(width, place.x, Int(use.uv.wrap_u));
    TexelPair rows = texels_around(height, place.y, Int(use.uv.wrap_v));
    texel = sel(finest, texel, fetch_around(coarser, columns, rows, x, y));
  }
  return texel;
}

// Texels of level 0 that what is seen is long.
Float texels_seen(Texture t, IN(TextureTransform) transform, Vec2 reach) {
  Float along_u = abs(Float(transform.row0.x)) * reach.x + abs(Float(transform.row0.y)) * reach.y;
  Float along_v = abs(Float(transform.row1.x)) * reach.x + abs(Float(transform.row1.y)) * reach.y;
  return max_of(along_u * float(texture_width(t)), along_v * float(texture_height(t)));
}

Vec4 fetch_seen(Texture t, Texture coarser, IN(SurfaceTexture) use, IN(SeenUv) seen) {
  Vec2 place = wrapped(use.uv, transformed_uv(use.uv, seen.at));
  Vec4 texel = Vec4(Float(0.0f), Float(0.0f), Float(0.0f), Float(0.0f));
  if (use.levels > 1) {
    Float texels = clamp_to(texels_seen(t, use.uv, seen.reach), 1.0f, exp2_of_whole(Int(use.levels - 1)));
    // The exponent of IEEE 754: 2^level <= texels < 2^(level + 1).
    Int level = floatBitsToInt(texels) / 8388608 - 127;
    Float beyond = texels * exp2_of_whole(-level) - 1.0f;
    texel = fetch_level(t, coarser, use, level, place);
    Bool between = beyond > 0.0f;
    if (any_lane(between)) {
      Vec4 next = fetch_level(t, coarser, use, level + 1, place);
      texel = sel(between, texel * (1.0f - beyond) + next * beyond, texel);
    }
  } else {
    texel = fetch_finest(t, use, place);
  }
  return texel;
}
