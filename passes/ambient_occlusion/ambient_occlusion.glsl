// The mean of ambient_rays over 4 x 4 texels on the same surface, which have all its directions.
TEXTURE(0, ambient_rays)
TEXTURE(1, view_normal)

#ifdef VERTEX_STAGE
#include "passes/shared/full_screen.glsl"
#else
OUTPUT(0, Vec4, ambient_occlusion)
#include "passes/shared/position_texel.glsl"
#include "passes/shared/same_surface.glsl"

void main() {
  Int column = floor_to_int(frag_x());
  Int row = floor_to_int(frag_y());
  Vec4 own = texel_fetch(ambient_rays, column, row);
  Vec3 position = Vec3(own);
  Vec3 normal = Vec3(fetch_clamped(view_normal, column * 4 + 2, row * 4 + 2));
  Float sum = Float(0.0f);
  Float weights = Float(0.0f);
  // At the picture's edge too 4 x 4 of their own.
  Int first_column = clamp_to(column - 2, Int(0), max_of(Int(texture_width(ambient_rays) - 4), Int(0)));
  Int first_row = clamp_to(row - 2, Int(0), max_of(Int(texture_height(ambient_rays) - 4), Int(0)));
  for (int j = 0; j < 4; j++)
    for (int i = 0; i < 4; i++) {
      Vec4 other = fetch_clamped(ambient_rays, first_column + i, first_row + j);
      Float weight = same_surface(position, normal, other);
      sum = sum + other.w * weight;
      weights = weights + weight;
    }
  Bool covered = is_covered(own);
  Float mean = sum / sel(covered, weights, Float(1.0f));
  ambient_occlusion = sel(covered, Vec4(position, mean), Vec4(0.0f));
}
#endif
