#include "passes/occluder_depth/occluder_depth.hpp"

#include "passes/receiver_map/receiver_map.hpp"

namespace caustics {

extern const Shader occluder_depth_shader;

Pass occluder_depth_pass() {
  return {
      .name = "occluder_depth",
      .purpose = "keeps casters that lie in the shadow of opaque surfaces out of the caster map",
      .reason = "opaque surfaces may stand between a light and a caster",
      .when = {&Effects::caustics, &Effects::occluders},
      .drawn_for = {kLight},
      .only_lights_with_caustics = true,
      .draws = DrawSet::Receivers,
      .size = grid_size,
      .reads = {{.name = "base_color",
                 .meaning = "the material's base colour; alpha masks cut holes",
                 .of_material = true}},
      .depth =
          DepthWrite{.name = "caster_depth",
                     .meaning = "window depth of the nearest opaque surface, later of the nearest surface"},
      .depth_state = {.compare = Compare::Less, .write = true},
      .shaders = {{&occluder_depth_shader, block_of<[](const PassContext& c) {
                     return receiver_map_uniforms(c.views->caster, *c.material);
                   }>}},
  };
}

}  // namespace caustics
