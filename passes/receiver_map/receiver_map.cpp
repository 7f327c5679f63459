#include "passes/receiver_map/receiver_map.hpp"

#include "pipeline/scene/material_optics.hpp"

namespace caustics {

extern const Shader receiver_map_shader;

std140::ReceiverMap receiver_map_uniforms(const View& view, const Material& material,
                                          const LightViews* views) {
  return {
      .view = shader_view(view),
      .column = shader_view(views ? views->column : view),
      .casters_nearest = views ? static_cast<float>(views->casters_nearest) : -1e30f,
      .map_side = view.cube ? view.cube->side : 0,
      .mask = std140::alpha_mask(material, opaque_from(material)),
  };
}

namespace {

std140::ReceiverMap uniforms_of(const PassContext& context) {
  std140::ReceiverMap block =
      receiver_map_uniforms(context.views->receiver, *context.material, context.views);
  if (!context.farthest() || !context.of_light) return block;
  const OutwardSides sides = context.of_light->lit.hidden_sides;
  block.without_towards = sides == OutwardSides::Away ? 1 : 0;
  block.without_away = sides == OutwardSides::Towards ? 1 : 0;
  return block;
}

}  // namespace

Pass receiver_map_pass() {
  return {
      .name = "receiver_map",
      .purpose =
          "finds what lies behind the casters, seen from the light: the nearest of it, and the farthest",
      .reason = "the casters' light must know where it lands",
      .when = {&Effects::caustics},
      .drawn_for = {kLight, kLightFar},
      .only_lights_with_caustics = true,
      .draws = DrawSet::Receivers,
      .size = receiver_size,
      .reads = {{.name = "base_color",
                 .meaning = "the material's base colour; alpha masks cut holes",
                 .of_material = true}},
      .writes = {{.name = "receiver_position",
                  .meaning = "xyz: position of the nearest (far: the farthest) receiver behind the casters' "
                             "top, metres, scene space; w: 1 where there is one, else 0"}},
      .depth = DepthWrite{.name = "receiver_depth", .meaning = "its window depth"},
      .depth_state = {.compare = Compare::Less, .write = true},
      // The last receiver instead of the first: what the nearest hide.
      .states = {{.label = kLightFar.label, .depth_clear = 0.0f, .depth_compare = Compare::Greater}},
      .shaders = {{&receiver_map_shader, block_of<uniforms_of>}},
  };
}

}  // namespace caustics
