// A material's texture transforms and alpha mask, as shaders get them (passes/shared/texture_transform.glsl).
#pragma once
#include "pipeline/scene/scene.hpp"
#include "pipeline/shader/std140.hpp"

namespace caustics::std140 {

#include "passes/shared/texture_transform.glsl"

inline TextureTransform texture_transform(const caustics::TextureUse& use) {
  const glm::mat3& m = use.uv_transform;
  return {.row0 = glm::vec3(m[0][0], m[1][0], m[2][0]), .row1 = glm::vec3(m[0][1], m[1][1], m[2][1])};
}

inline AlphaMask alpha_mask(const caustics::Material& material) {
  const bool masked = material.alpha_mode == AlphaMode::Mask;
  return {.uv = texture_transform(material.base_color_texture),
          .opacity = material.base_color.a,
          .cutoff = masked ? material.alpha_cutoff : 0.0f,
          .textured = masked && material.base_color_texture.present() ? 1 : 0};
}

}  // namespace caustics::std140
