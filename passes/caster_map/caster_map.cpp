#include "passes/caster_map/caster_map.hpp"

#include "pipeline/effects/textured_casters.hpp"

namespace caustics {

extern const Shader caster_map_shader;

CasterMapUniforms caster_map_uniforms(const View& view, int material_row) {
  const ViewUniforms f = pack(view);
  return {.from_scene = f.from_scene,
          .window = f.window,
          .depth = f.depth,
          .material = {static_cast<float>(material_row),
                       view.cube ? static_cast<float>(view.cube->side) : 0.0f, 0.0f, 0.0f}};
}

Pass caster_map_pass() {
  return {
      .definition =
          {
              .name = "caster_map",
              .purpose = "turns what the light sees of the casters into a grid of vertices",
              .writes = {{.name = "caster_position",
                          .format = Format::RGBA32F,
                          .meaning = "xyz: position of the caster's surface, metres, scene space; w: 1 a "
                                     "front face, -1 a back face, 0 no caster"},
                         {.name = "caster_normal",
                          .format = Format::RGBA32F,
                          .meaning = "xyz: unit shading normal, outward, scene space; w: row of the "
                                     "material in caster_materials"}},
              .depth = DepthWrite{.name = "caster_depth",
                                  .meaning = "window depth of the nearest surface"},
              .depth_state = {.compare = Compare::Less, .write = true},
              .count_samples = true,
              .shader = &caster_map_shader,
          },
      .called_for_by = [](const Effects& effects) -> std::optional<std::string> {
        if (!effects.caustics.active || caster_detail(effects) != CasterDetail::None) return {};
        return "each texel that a caster covers becomes a grid vertex";
      },
      .each = Each::Light,
      .draws = DrawSet::Casters,
      .extent = Extent::Grid,
      .uniforms =
          [](const PassContext& context) {
            return uniform_bytes(caster_map_uniforms(context.views->caster, context.material_row));
          },
  };
}

}  // namespace caustics
