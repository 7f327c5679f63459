#include "passes/occluder_depth/occluder_depth.hpp"

#include "passes/receiver_map/receiver_map.hpp"

namespace caustics {

extern const Shader occluder_depth_shader;

Pass occluder_depth_pass() {
  return {
      .definition =
          {
              .name = "occluder_depth",
              .purpose = "keeps casters that lie in the shadow of opaque surfaces out of the caster map",
              .reads = {{.name = "base_color",
                         .meaning = "the material's base colour; alpha masks cut holes",
                         .of_material = true}},
              .depth = DepthWrite{.name = "caster_depth",
                                  .meaning = "window depth of the nearest opaque surface, later of "
                                             "the nearest surface"},
              .depth_state = {.compare = Compare::Less, .write = true},
              .shader = &occluder_depth_shader,
          },
      .called_for_by = [](const Effects& effects) -> std::optional<std::string> {
        if (!effects.caustics.active || !effects.occluders.active) return {};
        return "opaque surfaces may stand between a light and a caster";
      },
      .each = Each::Light,
      .draws = DrawSet::Receivers,
      .extent = Extent::Grid,
      .uniforms =
          [](const PassContext& context) {
            return uniform_bytes(receiver_map_uniforms(context.views->caster, *context.material));
          },
  };
}

}  // namespace caustics
