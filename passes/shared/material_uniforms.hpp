// A material's texture transforms and alpha mask, as shaders get them (passes/shared/texture_transform.glsl).
#pragma once
#include "pipeline/scene/scene.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

#define CONSTANT(name, value) inline constexpr int name = value;
#include "passes/shared/texture_transform.glsl"
#undef CONSTANT

static_assert(WRAP_REPEAT == static_cast<int>(Wrap::Repeat) && WRAP_CLAMP == static_cast<int>(Wrap::Clamp) &&
              WRAP_MIRROR == static_cast<int>(Wrap::Mirror));

inline TextureTransform texture_transform(const caustics::TextureUse& use) {
  const glm::mat3& m = use.uv_transform;
  return {.row0 = glm::vec3(m[0][0], m[1][0], m[2][0]),
          .wrap_u = static_cast<int>(use.wrap_u),
          .row1 = glm::vec3(m[0][1], m[1][1], m[2][1]),
          .wrap_v = static_cast<int>(use.wrap_v),
          .nearest = use.nearest ? 1 : 0};
}

inline SurfaceTexture surface_texture(const caustics::TextureUse& use) {
  return {.uv = texture_transform(use), .levels = use.present() ? use.levels : 0};
}

// `cutoff`: 0 for no mask.
inline AlphaMask alpha_mask(const caustics::Material& material, float cutoff) {
  const bool masked = cutoff > 0.0f;
  return {.uv = texture_transform(material.base_color_texture),
          .opacity = material.base_color.a,
          .cutoff = cutoff,
          .textured = masked && material.base_color_texture.present() ? 1 : 0};
}

inline AlphaMask alpha_mask(const caustics::Material& material) {
  return alpha_mask(material, material.alpha_mode == AlphaMode::Mask ? material.alpha_cutoff : 0.0f);
}

}  // namespace caustics::std140
