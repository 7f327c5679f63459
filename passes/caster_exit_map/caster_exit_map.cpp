#include "passes/caster_exit_map/caster_exit_map.hpp"

#include "passes/caster_map/caster_map.hpp"
#include "passes/shared/textured_casters.hpp"
#include "pipeline/effects/textured_casters.hpp"

namespace caustics {

extern const Shader caster_exit_map_shader;
extern const Shader caster_exit_map_detailed_shader;

Pass caster_exit_map_pass() {
  return {
      .name = "caster_exit_map",
      .purpose = "finds the surface through which light leaves a solid caster again",
      .reason = "light leaves solid casters through a second surface",
      .when = {&Effects::exit_surface},
      .drawn_for = {{.each = Each::Light, .also = &Effects::caustics}},
      .only_lights_with_caustics = true,
      .draws = DrawSet::SolidCasters,
      .size = grid_size,
      .reads = {{.name = "base_color",
                 .meaning = "opacity; alpha masks cut holes",
                 .of_material = true,
                 .only_with = detailed_exits},
                {.name = "normal_texture",
                 .meaning = "tangent-space normals",
                 .of_material = true,
                 .only_with = detailed_exits}},
      .writes =
          {{.name = "caster_exit_position",
            .meaning = "xyz: position of the nearest back face, metres, scene space; w: 1 "
                       "where there is one, else 0"},
           {.name = "caster_exit_normal",
            .meaning =
                "xyz: unit shading normal, leaned by a normal texture, outward, scene space; w: 1 where "
                "there is one, else 0"}},
      .depth = DepthWrite{.name = "caster_exit_depth", .meaning = "window depth of the nearest back face"},
      .depth_state = {.compare = Compare::Less, .write = true},
      .cull = Cull::Front,
      .shaders = {{&caster_exit_map_shader, block_of<plain_casters>},
                  {&caster_exit_map_detailed_shader, block_of<textured_casters>, detailed_exits}},
  };
}

}  // namespace caustics
