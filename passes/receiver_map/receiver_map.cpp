#include "passes/receiver_map/receiver_map.hpp"

namespace caustics {

extern const Shader receiver_map_shader;

std140::ReceiverMap receiver_map_uniforms(const View& view, const Material& material, const LightViews* views) {
  return {
      .view = shader_view(view),
      .column = shader_view(views ? views->column : view),
      .casters_nearest = views ? static_cast<float>(views->casters_nearest) : -1e30f,
      .map_side = view.cube ? view.cube->side : 0,
      .mask = std140::alpha_mask(material),
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
