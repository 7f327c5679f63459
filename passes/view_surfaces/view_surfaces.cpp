#include "passes/view_surfaces/view_surfaces.hpp"

#include <glm/glm.hpp>

namespace caustics {

extern const Shader view_surfaces_shader;

namespace {

struct ViewSurfacesUniforms {
  using vec4 = glm::vec4;
  using mat4 = glm::mat4;
#include "passes/view_surfaces/view_surfaces_uniforms.glsl"
};

glm::vec4 row(const TextureUse& use, int index) {
  const glm::mat3& m = use.uv_transform;
  return {m[0][index], m[1][index], m[2][index], 0.0f};
}

UniformBytes uniforms(const View& view, const Material& m) {
  const ViewUniforms f = pack(view);
  const auto used = [](const TextureUse& use) { return use.present() ? 1.0f : 0.0f; };
  return uniform_bytes(ViewSurfacesUniforms{
      .from_scene = f.from_scene,
      .window = f.window,
      .depth = f.depth,
      .base_factor = m.base_color,
      .alpha = {m.base_color.a, m.alpha_mode == AlphaMode::Mask ? m.alpha_cutoff : 0.0f, 0.0f, 0.0f},
      .emissive_factor = glm::vec4(m.emissive, 0.0f),
      .uses = {used(m.base_color_texture), used(m.normal_texture), used(m.emissive_texture),
               m.normal_scale},
      .uv_row0 = row(m.base_color_texture, 0),
      .uv_row1 = row(m.base_color_texture, 1),
      .normal_row0 = row(m.normal_texture, 0),
      .normal_row1 = row(m.normal_texture, 1),
      .emissive_row0 = row(m.emissive_texture, 0),
      .emissive_row1 = row(m.emissive_texture, 1),
  });
}

PassDefinition definition(const std::string& view, const std::string& purpose) {
  return {
      .name = view + "_surfaces",
      .purpose = purpose,
      .reads = {{.name = "base_color", .meaning = "albedo and opacity", .of_material = true},
                {.name = "normal_texture", .meaning = "tangent-space normals", .of_material = true},
                {.name = "emissive", .meaning = "light of its own", .of_material = true}},
      .writes = {{.name = view + "_position",
                  .meaning = "xyz: position of the first opaque surface, metres, scene space; w: 1 "
                             "where there is one, else 0"},
                 {.name = view + "_normal",
                  .meaning = "xyz: unit shading normal on the camera's side, scene space; w: depth "
                             "along the camera's axis, metres"},
                 {.name = view + "_albedo", .meaning = "rgb: diffuse albedo, linear"},
                 {.name = view + "_emission", .meaning = "rgb: emitted radiance, nit"}},
      .depth = DepthWrite{.name = view + "_window_depth", .meaning = "window depth"},
      .depth_state = {.compare = Compare::Less, .write = true},
      .shader = &view_surfaces_shader,
  };
}

}  // namespace

Pass view_surfaces_pass() {
  return {.definition = definition("view", "finds the first opaque surface in each pixel"),
          .called_for_by = [](const Effects&) -> std::optional<std::string> {
            return "the camera looks at the scene";
          },
          .each = Each::Frame,
          .draws = DrawSet::Receivers,
          .extent = Extent::Picture,
          .uniforms =
              [](const PassContext& c) { return uniforms(*c.camera, *c.material); }};
}

Pass wide_surfaces_pass() {
  return {.definition = definition("wide", "finds the opaque surfaces around the picture, which "
                                           "glass in it can show"),
          .called_for_by = [](const Effects& effects) -> std::optional<std::string> {
            if (!effects.seen_casters.active) return {};
            return "glass shows what lies beyond the picture's edges";
          },
          .each = Each::Frame,
          .draws = DrawSet::Receivers,
          .extent = Extent::Wide,
          .uniforms =
              [](const PassContext& c) { return uniforms(*c.surroundings, *c.material); }};
}

}  // namespace caustics
