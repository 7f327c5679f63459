#include "passes/textured_casters/textured_casters.hpp"

#include "pipeline/scene/material_optics.hpp"
#include "pipeline/effects/textured_casters.hpp"

namespace caustics {

namespace {

glm::vec4 row(const TextureUse& use, int index) {
  const glm::mat3& m = use.uv_transform;
  return {m[0][index], m[1][index], m[2][index], 0.0f};
}

}  // namespace

TexturedCastersUniforms textured_casters_uniforms(const View& view, const Material& material, Role role,
                                                  int material_row) {
  const ViewUniforms f = pack(view);
  const auto used = [](const TextureUse& use) { return use.present() ? 1.0f : 0.0f; };
  const bool mirror = role == Role::Mirror;
  const bool masked = material.alpha_mode == AlphaMode::Mask;
  // A metal's reflectance is linear in its base colour: nothing but the factor meets the texture.
  Material colorless = material;
  colorless.base_color = glm::vec4(0.0f);
  const glm::vec3 offset = mirror ? metal_reflectance(colorless) : glm::vec3(0.0f);
  const glm::vec3 factor = glm::vec3(material.base_color) * (mirror ? material.metallic : 1.0f);
  return {
      .from_scene = f.from_scene,
      .window = f.window,
      .depth = f.depth,
      .material = {static_cast<float>(material_row), material.normal_scale,
                   view.cube ? static_cast<float>(view.cube->side) : 0.0f, 0.0f},
      .color_factor = glm::vec4(factor, 0.0f),
      .color_offset = glm::vec4(offset, 0.0f),
      .uses = {used(material.base_color_texture), used(material.normal_texture),
               mirror ? 0.0f : used(material.transmission_texture), 0.0f},
      .alpha = {material.base_color.a, masked ? material.alpha_cutoff : 0.0f,
                masked ? used(material.base_color_texture) : 0.0f, 0.0f},
      .uv_row0 = row(material.base_color_texture, 0),
      .uv_row1 = row(material.base_color_texture, 1),
      .normal_row0 = row(material.normal_texture, 0),
      .normal_row1 = row(material.normal_texture, 1),
      .transmission_row0 = row(material.transmission_texture, 0),
      .transmission_row1 = row(material.transmission_texture, 1),
  };
}

}  // namespace caustics
