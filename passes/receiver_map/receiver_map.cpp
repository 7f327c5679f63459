#include "passes/receiver_map/receiver_map.hpp"

namespace caustics {

extern const Shader receiver_map_shader;

ReceiverMapUniforms receiver_map_uniforms(const View& view, const Material& material,
                                          const LightViews* views) {
  const ViewUniforms f = pack(view);
  const glm::mat3& uv = material.base_color_texture.uv_transform;
  const ViewUniforms column = views ? pack(views->column) : f;
  const float nearest = views ? static_cast<float>(views->casters_nearest) : -1e30f;
  const bool masked = material.alpha_mode == AlphaMode::Mask;
  return {
      .from_scene = f.from_scene,
      .window = f.window,
      .depth = f.depth,
      .alpha = {material.base_color.a, masked ? material.alpha_cutoff : 0.0f,
                masked && material.base_color_texture.present() ? 1.0f : 0.0f,
                view.cube ? static_cast<float>(view.cube->side) : 0.0f},
      .uv_row0 = {uv[0][0], uv[1][0], uv[2][0], 0.0f},
      .uv_row1 = {uv[0][1], uv[1][1], uv[2][1], 0.0f},
      .column = column.window,
      .column_depth = glm::vec4(glm::vec3(column.depth), nearest),
  };
}

Pass receiver_map_pass() {
  return {
      .definition =
          {
              .name = "receiver_map",
              .purpose = "finds what lies behind the casters, seen from the light",
              .reads = {{.name = "base_color",
                         .meaning = "the material's base colour; alpha masks cut holes",
                         .of_material = true}},
              .writes = {{.name = "receiver_position",
                          .format = Format::RGBA32F,
                          .meaning = "xyz: position of the nearest receiver behind the casters' "
                                     "top, metres, scene space; w: 1 where there is one, else 0"}},
              .depth = DepthWrite{.name = "receiver_depth",
                                  .meaning = "window depth of the nearest receiver"},
              .depth_state = {.compare = Compare::Less, .write = true},
              .shader = &receiver_map_shader,
          },
      .called_for_by = [](const Effects& effects) -> std::optional<std::string> {
        if (!effects.caustics.active) return {};
        return "the casters' light must know where it lands";
      },
      .each = Each::Light,
      .draws = DrawSet::Receivers,
      .extent = Extent::Receiver,
      .uniforms =
          [](const PassContext& context) {
            return uniform_bytes(
                receiver_map_uniforms(context.views->receiver, *context.material, context.views));
          },
  };
}

}  // namespace caustics
