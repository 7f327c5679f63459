#include "passes/impostor_map/impostor_map.hpp"

#include "passes/receiver_map/receiver_map.hpp"
#include "pipeline/scene/cube_view.hpp"

namespace caustics {

extern const Shader impostor_map_shader;

namespace {

View impostor_view(const PassContext& context) {
  View view = with_atlas(context.effects->impostors, context.width);
  view.face = context.face;
  return view;
}

}  // namespace

Pass impostor_map_pass() {
  return {
      .name = "impostor_map",
      .purpose = "finds the receivers all around the casters",
      .reason = "landings are looked up around the casters",
      .when = {&Effects::distance_impostors},
      .draws = DrawSet::Receivers,
      .size = map_size,
      .reads = {{.name = "base_color",
                 .meaning = "the material's base colour; alpha masks cut holes",
                 .of_material = true}},
      .writes = {{.name = "impostor_position",
                  .meaning = "six tiles. xyz: position of the nearest receiver, metres, scene space; "
                             "w: its distance from the casters' centre, metres, 0 where there is none"}},
      .depth = DepthWrite{.name = "impostor_depth", .meaning = "window depth of the nearest receiver"},
      .depth_state = {.compare = Compare::Less, .write = true},
      .shaders = {{&impostor_map_shader, block_of<[](const PassContext& c) {
                     return receiver_map_uniforms(impostor_view(c), *c.material);
                   }>}},
      .all_around = impostor_view,
  };
}

}  // namespace caustics
