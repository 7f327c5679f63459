#include "passes/textured_casters/textured_casters.hpp"

#include "pipeline/scene/material_optics.hpp"
#include "pipeline/effects/textured_casters.hpp"

namespace caustics {

extern const Shader detailed_casters_shader;
extern const Shader tinted_casters_shader;
extern const Shader detailed_exits_shader;

namespace {

glm::vec4 row(const TextureUse& use, int index) {
  const glm::mat3& m = use.uv_transform;
  return {m[0][index], m[1][index], m[2][index], 0.0f};
}

UniformBytes drawn_into(const View& view, const PassContext& context) {
  const Role role = context.effects->surfaces[static_cast<std::size_t>(context.mesh_index)].role;
  return uniform_bytes(textured_casters_uniforms(view, *context.material, role, context.material_row));
}
UniformBytes light_uniforms(const PassContext& context) {
  return drawn_into(context.views->caster, context);
}
UniformBytes view_uniforms(const PassContext& context) { return drawn_into(*context.camera, context); }

const TextureRead kBaseColor{.name = "base_color",
                             .meaning = "colour and opacity; alpha masks cut holes",
                             .of_material = true};
const TextureRead kNormalTexture{.name = "normal_texture",
                                 .meaning = "tangent-space normals",
                                 .of_material = true};
const TextureRead kTransmission{.name = "transmission_texture",
                                .meaning = "r: share that is let through",
                                .of_material = true};

ColorWrite positions(const std::string& name) {
  return {.name = name,
          .format = Format::RGBA32F,
          .meaning = "xyz: position of the caster's surface, metres, scene space; w: 1 a front face, -1 a "
                     "back face, 0 no caster"};
}
ColorWrite normals(const std::string& name) {
  return {.name = name,
          .format = Format::RGBA32F,
          .meaning = "xyz: unit normal, leaned by the normal texture, outward, scene space; w: row of the "
                     "material in caster_materials"};
}
ColorWrite tints(const std::string& name) {
  return {.name = name,
          .format = Format::RGBA32F,
          .meaning = "rgb: what glass lets through, or metal mirrors at normal incidence, 0..1; w: 1 where "
                     "there is a caster, else 0"};
}

// The casters nearest to the eye of a frame whose textures start with `prefix`.
PassDefinition nearest(const std::string& name, const std::string& prefix, bool tinted, bool counted) {
  PassDefinition definition{
      .name = name,
      .purpose = tinted ? "finds the nearest casters with the normals and colours of their textures"
                        : "finds the nearest casters with the normals and holes of their textures",
      .reads = {kBaseColor, kNormalTexture},
      .writes = {positions(prefix + "_position"), normals(prefix + "_normal")},
      .depth = DepthWrite{.name = prefix + "_depth", .meaning = "window depth of the nearest surface"},
      .depth_state = {.compare = Compare::Less, .write = true},
      .count_samples = counted,
      .shader = tinted ? &tinted_casters_shader : &detailed_casters_shader};
  if (!tinted) return definition;
  definition.reads.push_back(kTransmission);
  definition.writes.push_back(tints(prefix + "_tint"));
  return definition;
}

PassDefinition exits(const std::string& name, const std::string& prefix) {
  return {.name = name,
          .purpose = "finds the surface through which light leaves solid casters, with its textures' normals "
                     "and holes",
          .reads = {kBaseColor, kNormalTexture},
          .writes = {{.name = prefix + "_position",
                      .format = Format::RGBA32F,
                      .meaning = "xyz: position of the nearest back face, metres, scene space; w: 1 where "
                                 "there is one, else 0"},
                     {.name = prefix + "_normal",
                      .format = Format::RGBA32F,
                      .meaning = "xyz: unit normal, leaned by the normal texture, outward, scene space; w: 1 "
                                 "where there is one, else 0"}},
          .depth = DepthWrite{.name = prefix + "_depth",
                              .meaning = "window depth of the nearest back face"},
          .depth_state = {.compare = Compare::Less, .write = true},
          .cull = Cull::Front,
          .shader = &detailed_exits_shader};
}

std::optional<std::string> when(bool condition, const std::string& reason) {
  if (!condition) return {};
  return reason;
}

std::optional<std::string> detailed(const Effects& effects) {
  return when(caster_detail(effects) == CasterDetail::Normals, "casters have normal textures or holes");
}
std::optional<std::string> tinted(const Effects& effects) {
  return when(caster_detail(effects) == CasterDetail::Colors, "casters have colour textures");
}

}  // namespace

TexturedCastersUniforms textured_casters_uniforms(const View& view, const Material& material, Role role,
                                                  int material_row) {
  const ViewUniforms f = pack(view);
  const auto used = [](const TextureUse& use) { return use.present() ? 1.0f : 0.0f; };
  const bool mirror = role == Role::Mirror;
  const bool masked = material.alpha_mode == AlphaMode::Mask;
  // A metal's reflectance is linear in its base colour: nothing but the factor meets the texture.
  Material colorless = material;
  colorless.base_color = glm::vec4(0.0f);
  const glm::vec3 offset = mirror ? metal_reflectance(colorless) : glm::vec3(0.0f);
  const glm::vec3 factor = glm::vec3(material.base_color) * (mirror ? material.metallic : 1.0f);
  return {
      .from_scene = f.from_scene,
      .window = f.window,
      .depth = f.depth,
      .material = {static_cast<float>(material_row), material.normal_scale,
                   view.cube ? static_cast<float>(view.cube->side) : 0.0f, 0.0f},
      .color_factor = glm::vec4(factor, 0.0f),
      .color_offset = glm::vec4(offset, 0.0f),
      .uses = {used(material.base_color_texture), used(material.normal_texture),
               mirror ? 0.0f : used(material.transmission_texture), 0.0f},
      .alpha = {material.base_color.a, masked ? material.alpha_cutoff : 0.0f,
                masked ? used(material.base_color_texture) : 0.0f, 0.0f},
      .uv_row0 = row(material.base_color_texture, 0),
      .uv_row1 = row(material.base_color_texture, 1),
      .normal_row0 = row(material.normal_texture, 0),
      .normal_row1 = row(material.normal_texture, 1),
      .transmission_row0 = row(material.transmission_texture, 0),
      .transmission_row1 = row(material.transmission_texture, 1),
  };
}

Pass detailed_caster_map_pass() {
  return {.definition = nearest("detailed_caster_map", "caster", false, true),
          .called_for_by = [](const Effects& e) { return e.caustics.active ? detailed(e) : std::nullopt; },
          .each = Each::Light,
          .draws = DrawSet::Casters,
          .extent = Extent::Grid,
          .uniforms = light_uniforms};
}

Pass tinted_caster_map_pass() {
  return {.definition = nearest("tinted_caster_map", "caster", true, true),
          .called_for_by = [](const Effects& e) { return e.caustics.active ? tinted(e) : std::nullopt; },
          .each = Each::Light,
          .draws = DrawSet::Casters,
          .extent = Extent::Grid,
          .uniforms = light_uniforms};
}

Pass detailed_exit_map_pass() {
  return {.definition = exits("detailed_exit_map", "caster_exit"),
          .called_for_by = [](const Effects& effects) -> std::optional<std::string> {
            return when(effects.caustics.active && effects.exit_surface.active &&
                            detailed_exits(effects),
                        "solid casters may have normal textures or holes");
          },
          .each = Each::Light,
          .draws = DrawSet::SolidCasters,
          .extent = Extent::Grid,
          .uniforms = light_uniforms};
}

Pass detailed_view_casters_pass() {
  return {.definition = nearest("detailed_view_casters", "view_caster", false, false),
          .called_for_by = [](const Effects& e) { return e.seen_casters.active ? detailed(e) : std::nullopt; },
          .draws = DrawSet::Casters,
          .extent = Extent::Picture,
          .uniforms = view_uniforms};
}

Pass tinted_view_casters_pass() {
  return {.definition = nearest("tinted_view_casters", "view_caster", true, false),
          .called_for_by = [](const Effects& e) { return e.seen_casters.active ? tinted(e) : std::nullopt; },
          .draws = DrawSet::Casters,
          .extent = Extent::Picture,
          .uniforms = view_uniforms};
}

Pass detailed_view_exits_pass() {
  return {.definition = exits("detailed_view_exits", "view_exit"),
          .called_for_by = [](const Effects& effects) -> std::optional<std::string> {
            return when(effects.seen_casters.active && effects.exit_surface.active &&
                            detailed_exits(effects),
                        "solid casters may have normal textures or holes");
          },
          .draws = DrawSet::SolidCasters,
          .extent = Extent::Picture,
          .uniforms = view_uniforms};
}

}  // namespace caustics
