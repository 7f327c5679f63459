#include "passes/caster_exit_map/caster_exit_map.hpp"

#include "passes/caster_map/caster_map.hpp"
#include "pipeline/effects/textured_casters.hpp"

namespace caustics {

extern const Shader caster_exit_map_shader;

Pass caster_exit_map_pass() {
  return {
      .definition =
          {
              .name = "caster_exit_map",
              .purpose = "finds the surface through which light leaves a solid caster again",
              .writes = {{.name = "caster_exit_position",
                          .format = Format::RGBA32F,
                          .meaning = "xyz: position of the nearest back face, metres, scene space; w: 1 "
                                     "where there is one, else 0"},
                         {.name = "caster_exit_normal",
                          .format = Format::RGBA32F,
                          .meaning = "xyz: unit shading normal, outward, scene space; w: 1 where there "
                                     "is one, else 0"}},
              .depth = DepthWrite{.name = "caster_exit_depth",
                                  .meaning = "window depth of the nearest back face"},
              .depth_state = {.compare = Compare::Less, .write = true},
              .cull = Cull::Front,
              .shader = &caster_exit_map_shader,
          },
      .called_for_by = [](const Effects& effects) -> std::optional<std::string> {
        if (!effects.caustics.active || !effects.exit_surface.active || detailed_exits(effects)) return {};
        return "light leaves solid casters through a second surface";
      },
      .each = Each::Light,
      .draws = DrawSet::SolidCasters,
      .extent = Extent::Grid,
      .uniforms =
          [](const PassContext& context) {
            return uniform_bytes(caster_map_uniforms(context.views->caster, context.material_row));
          },
  };
}

}  // namespace caustics
