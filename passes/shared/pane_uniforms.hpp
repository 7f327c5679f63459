// What the passes that draw thin panes get of a pane.
#pragma once
#include "passes/shared/light_uniforms.hpp"
#include "passes/shared/material_uniforms.hpp"
#include "passes/shared/sky_uniforms.hpp"
#include "pipeline/plan/pass.hpp"
#include "pipeline/scene/material_optics.hpp"

namespace caustics {

namespace std140 {
struct Pane {
#include "passes/shared/pane_uniforms.glsl"
};
}  // namespace std140

// Without a light and what shadows it.
inline std140::Pane pane_uniforms(const View& view, const glm::dvec3& eye, const PassContext& context) {
  const Material& m = *context.material;
  const SurfaceRole role = context.surface_role();
  const bool blended = role.blended;
  return {.sky = shader_sky(context.scene->environment),
          .view = shader_view(view),
          .map_side = view.cube.value_or(CubeAtlas{}).side,
          .eye = glm::vec3(eye),
          .forward = glm::vec3(view.forward),
          .color = glm::vec3(m.base_color),
          .ior = m.ior,
          .fresnel = m.fresnel_factor,
          .transmitted = transmission_factor(m),
          .has_transmission = m.transmission_texture.present() ? 1 : 0,
          .transmission_uv = std140::texture_transform(m.transmission_texture),
          .is_covering = m.alpha_mode == AlphaMode::Blend ? 1 : 0,
          .has_layer = role.partly_diffuse ? 1 : 0,
          .has_base_color = m.base_color_texture.present() ? 1 : 0,
          .base_color_uv = std140::texture_transform(m.base_color_texture),
          .alpha_mask = blended ? std140::alpha_mask(m, kCoversAll) : std140::alpha_mask(m),
          .is_blended = blended ? 1 : 0,
          .shadow_view = {},
          .light = {},
          .roughness = m.roughness};
}

}  // namespace caustics
