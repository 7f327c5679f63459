// What uniforms say of textures and an alpha mask. Include before UNIFORMS_BEGIN;
// passes/shared/material_uniforms.hpp fills them.

// How a texture goes on beyond its picture, along an axis: Wrap in pipeline/scene/scene.hpp.
CONSTANT(WRAP_REPEAT, 0)
CONSTANT(WRAP_CLAMP, 1)
CONSTANT(WRAP_MIRROR, 2)

// KHR_texture_transform, and the sampler's wrap modes and filter.
struct TextureTransform {
  vec3 row0;  // u' = row0 . (u, v, 1)
  int wrap_u;
  vec3 row1;  // v' = row1 . (u, v, 1)
  int wrap_v;
  int nearest;  // 1: near by it is not interpolated
};

// A texture that the camera sees on a surface.
struct SurfaceTexture {
  TextureTransform uv;
  int levels;  // of its mip map; 0: there is no such texture
};

// glTF's alpha mask: a surface is cut out where opacity, times the texture's alpha if there is one, is below
// the cutoff.
struct AlphaMask {
  TextureTransform uv;
  float opacity;  // the base colour's alpha
  float cutoff;   // 0 in opaque materials
  int textured;   // 1: the base colour texture's alpha counts
};
