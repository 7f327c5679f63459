#include "passes/shared/textured_casters.hpp"

#include "pipeline/effects/textured_casters.hpp"
#include "pipeline/scene/material_optics.hpp"

namespace caustics {

std140::TexturedCasters textured_casters_uniforms(const View& view, const Material& material,
                                                  const SurfaceRole& surface, int material_row,
                                                  int first_triangle, bool of_light) {
  const bool mirror = surface.role == Role::Mirror;
  // A metal's reflectance is linear in its base colour: nothing but the factor meets the texture.
  Material colorless = material;
  colorless.base_color = glm::vec4(0.0f);
  return {
      .view = shader_view(view),
      .mask = std140::alpha_mask(material),
      .normal_uv = std140::texture_transform(material.normal_texture),
      .transmission_uv = std140::texture_transform(material.transmission_texture),
      .color_factor = glm::vec3(material.base_color) * (mirror ? material.metallic : 1.0f),
      .normal_scale = material.normal_scale,
      .color_offset = mirror ? metal_reflectance(colorless) : glm::vec3(0.0f),
      .material_row = material_row,
      .has_base_color = material.base_color_texture.present(),
      .has_normal_texture = material.normal_texture.present(),
      .has_transmission = of_light && !mirror && material.transmission_texture.present(),
      .map_side = view.cube.value_or(CubeAtlas{}).side,
      .first_triangle = first_triangle,
  };
}

std140::TexturedCasters textured_casters(const PassContext& context) {
  return textured_casters_uniforms(context.sees_casters(), *context.material,
                                   context.effects->surfaces[static_cast<std::size_t>(context.mesh_index)],
                                   context.material_row, context.first_triangle, context.views != nullptr);
}

}  // namespace caustics
