#include "passes/shadow_map/shadow_map.hpp"

#include "passes/receiver_map/receiver_map.hpp"

namespace caustics {

extern const Shader shadow_map_shader;

Pass shadow_map_pass() {
  return {
      .name = "shadow_map",
      .purpose = "finds what the light meets first, so that the rest lies in shadow",
      .reason = "opaque surfaces may shadow one another",
      .when = {&Effects::light, &Effects::occluders},
      .drawn_for = {kLight},
      .draws = DrawSet::Shadowing,
      .size = shadow_size,
      .reads = {{.name = "base_color",
                 .meaning = "the material's base colour; alpha masks cut holes",
                 .of_material = true}},
      .writes = {{.name = "shadow_depth",
                  .format = Format::R32F,
                  .meaning = "distance of the nearest opaque surface along the light's axis, "
                             "metres; 1e30 where there is none",
                  .clear = {1e30f, 0.0f, 0.0f, 0.0f}}},
      .depth =
          DepthWrite{.name = "shadow_window_depth", .meaning = "window depth of the nearest opaque surface"},
      .depth_state = {.compare = Compare::Less, .write = true},
      .shaders = {{&shadow_map_shader, block_of<[](const PassContext& c) {
                     return receiver_map_uniforms(c.views->shadow, *c.material);
                   }>}},
  };
}

}  // namespace caustics
