#include "passes/caster_map/caster_map.hpp"

#include "passes/shared/textured_casters.hpp"
#include "pipeline/effects/textured_casters.hpp"

namespace caustics {

extern const Shader caster_map_shader;
extern const Shader caster_map_detailed_shader;
extern const Shader caster_map_tinted_shader;

std140::CasterMap caster_map_uniforms(const View& view, int material_row, int first_triangle) {
  return {.view = shader_view(view),
          .material_row = material_row,
          .map_side = view.cube.value_or(CubeAtlas{}).side,
          .first_triangle = first_triangle};
}

std140::CasterMap plain_casters(const PassContext& context) {
  return caster_map_uniforms(context.sees_casters(), context.material_row, context.first_triangle);
}

namespace {

bool are_detailed(const Effects& effects) { return caster_detail(effects) != CasterDetail::None; }
bool are_tinted(const Effects& effects) { return caster_detail(effects) == CasterDetail::Colors; }

}  // namespace

Pass caster_map_pass() {
  return {
      .name = "caster_map",
      .purpose =
          "turns what the light sees of the casters into a grid of vertices; shows the camera where they are",
      .reason = "each texel that a caster covers becomes a grid vertex",
      .drawn_for = {{.each = Each::Light, .also = &Effects::caustics}, kCamera, kCameraBeyondPanes},
      .only_lights_with_caustics = true,
      .draws = DrawSet::Casters,
      .size = grid_size,
      .reads = {{.name = "base_color",
                 .meaning = "colour and opacity; alpha masks cut holes",
                 .of_material = true,
                 .only_with = are_detailed},
                {.name = "normal_texture",
                 .meaning = "tangent-space normals",
                 .of_material = true,
                 .only_with = are_detailed},
                {.name = "transmission_texture",
                 .meaning = "r: share that is let through",
                 .of_material = true,
                 .only_with = are_tinted}},
      .writes = {{.name = "caster_position",
                  .meaning =
                      "xyz: position of the caster's surface, metres, scene space; w: 0 no caster, 1, or "
                      "2 + the triangle's number in the hierarchy; negative on a back face"},
                 {.name = kCasterNormal,
                  .meaning =
                      "xyz: unit shading normal, leaned by a normal texture, outward, scene space; w: row of "
                      "the material in caster_materials"},
                 {.name = "caster_tint",
                  .meaning =
                      "rgb: what glass lets through, or metal mirrors at normal incidence, 0..1; w: 1 where "
                      "there is a caster, else 0",
                  .only_with = are_tinted}},
      .depth = DepthWrite{.name = "caster_depth", .meaning = "window depth of the nearest surface"},
      .depth_state = {.compare = Compare::Less, .write = true},
      .count_samples = true,
      .shaders = {{&caster_map_shader, block_of<plain_casters>},
                  {&caster_map_detailed_shader, block_of<textured_casters>, are_detailed},
                  {&caster_map_tinted_shader, block_of<textured_casters>, are_tinted}},
  };
}

}  // namespace caustics
