// KHR_texture_transform and an alpha mask, as uniforms. Include before UNIFORMS_BEGIN; texture_transform()
// and alpha_mask() in passes/shared/material_uniforms.hpp fill them.
struct TextureTransform {
  vec3 row0;  // u' = row0 . (u, v, 1)
  vec3 row1;  // v' = row1 . (u, v, 1)
};

// glTF's alpha mask: a surface is cut out where opacity, times the texture's alpha if there is one, is below
// the cutoff.
struct AlphaMask {
  TextureTransform uv;
  float opacity;  // the base colour's alpha
  float cutoff;   // 0 in opaque materials
  int textured;   // 1: the base colour texture's alpha counts
};
