#include "passes/light_shading/light_shading.hpp"

#include <cmath>
#include <glm/glm.hpp>

#include "passes/medium/medium_uniforms.hpp"
#include "passes/shared/light_uniforms.hpp"
#include "pipeline/settings/splat_kernel.hpp"

namespace caustics {

extern const Shader light_shading_shader;
extern const Shader light_shading_in_medium_shader;

namespace {

// Texels along a cascade's border whose splats may have their middles beyond it, and one for the look-up.
constexpr double kBorder = 1.0;
// Of a caustic over a pixel, along an axis: pixels up to this many texels wide see the mean without gaps. Pixels on one
// surface share its texels, so there are hardly more samples in all than texels, however wide the pixels are.
constexpr float kMostSamples = 64.0f;

struct LightShadingUniforms {
  using vec4 = glm::vec4;
  using mat4 = glm::mat4;
#include "passes/light_shading/light_shading_uniforms.glsl"
};

bool throws_caustic(const PassContext& context) {
  for (const Expectation& e : context.effects->expectations)
    if (e.expected && &context.scene->lights[static_cast<std::size_t>(e.light)] == context.light)
      return true;
  return false;
}

UniformBytes uniforms(const PassContext& context) {
  const LightViews& views = *context.views;
  const Light& light = *context.light;
  const ViewUniforms caster = pack(views.caster), receiver = pack(views.receiver);
  const ViewUniforms caustic = pack(views.caustic), shadow = pack(views.shadow);
  const ViewUniforms panes = pack(views.panes), column = pack(views.column);
  const LightCone cone = light_cone(light);
  const bool directional = light.type == LightType::Directional;
  const bool caustics = context.effects->caustics.active && throws_caustic(context);
  const double texels =
      static_cast<double>(context.settings->map) * static_cast<double>(context.settings->map);
  glm::vec2 reach{0.0f};
  if (const auto& cube = views.caustic.cube)
    reach = glm::vec2(0.5 * glm::dvec2(cube->tile_width() - 1, cube->tile_height() - 1) /
                      static_cast<double>(cube->side));
  const ViewUniforms cascade = pack(views.cascade.value_or(View{}));
  glm::vec4 cascade_texel{0.0f};
  if (views.cascade && caustics)
    cascade_texel = {static_cast<float>(views.cascade->window_area() / texels),
                     static_cast<float>((splat_kernel(*context.settings).radius + kBorder) / context.settings->map),
                     1.0f, 0.0f};
  // Not of lights that see all around.
  if (caustics && context.effects->hidden_receivers.active && !views.caustic.cube) cascade_texel.w = 1.0f;
  return uniform_bytes(LightShadingUniforms{
      .from_scene = shadow.from_scene,
      .caster_window = caster.window,
      .caster_depth = caster.depth,
      .receiver_window = receiver.window,
      .receiver_depth = receiver.depth,
      .caustic_window = caustic.window,
      .caustic_depth = caustic.depth,
      .shadow_window = shadow.window,
      .shadow_range = shadow.depth,
      .pane_window = panes.window,
      .pane_depth = panes.depth,
      .light = glm::vec4(glm::vec3(directional ? views.shadow.forward : light.position),
                         directional ? 0.0f : 1.0f),
      .cone_axis = cone.axis,
      .cone = cone.scale_offset,
      .intensity = glm::vec4(light.color * light.intensity,
                             !directional && std::isfinite(light.range) ? light.range : 0.0f),
      .column = column.window,
      .column_depth = glm::vec4(glm::vec3(column.depth), static_cast<float>(views.casters_nearest)),
      .caustic_texel = {static_cast<float>(views.caustic.window_area() / texels), reach.x, reach.y,
                        context.effects->coloured_caustics.active ? 0.0f : 1.0f},
      .cascade_window = cascade.window,
      .cascade_texel = cascade_texel,
      .uses = {context.effects->occluders.active ? 1.0f : 0.0f, caustics ? 1.0f : 0.0f,
               caustics ? 1.0f : 0.0f, context.effects->thin_panes.active ? 1.0f : 0.0f},
      .footprint = {context.settings->pixel_means ? kMostSamples : 0.0f, 0.0f, 0.0f, 0.0f},
  });
}

PassDefinition definition(const std::string& view, const std::string& name,
                          const std::string& direct, const std::string& caustic) {
  return {
      .name = name,
      .purpose = "adds what one light gives to the surfaces in view, directly and by its caustics",
      .reads = {{.name = view + "_position", .meaning = "the surfaces"},
                {.name = view + "_normal", .meaning = "their normals"},
                {.name = "shadow_depth", .meaning = "what shadows them", .optional = true},
                {.name = "caster_position",
                 .meaning = "the casters, which shadow them too",
                 .optional = true},
                {.name = "receiver_position",
                 .meaning = "which surfaces the caustic map belongs to",
                 .optional = true},
                {.name = "caustic_map", .meaning = "the casters' light", .optional = true},
                {.name = kCascadeMap, .meaning = "a part of it, finer", .optional = true},
                {.name = "pane_transmittance",
                 .meaning = "what thin panes let through",
                 .optional = true},
                {.name = far_texture("receiver_position"),
                 .meaning = "the farthest surfaces that the light sees",
                 .optional = true},
                {.name = far_texture(kCausticMap), .meaning = "the casters' light on these", .optional = true}},
      .writes = {{.name = direct,
                  .meaning = "rgb: direct irradiance after shadows, lux",
                  .blend = kAccumulate},
                 {.name = caustic,
                  .meaning = "rgb: irradiance from caustics, lux",
                  .blend = kAccumulate}},
      .shader = &light_shading_shader,
  };
}

// The same light where a medium takes its share on the way.
Pass in_medium(Pass pass, std::optional<std::string> (*called_for_by)(const Effects&)) {
  pass.definition.name += "_in_medium";
  pass.definition.shader = &light_shading_in_medium_shader;
  pass.called_for_by = called_for_by;
  pass.uniforms = [](const PassContext& context) { return with_medium(uniforms(context), *context.scene); };
  return pass;
}

}  // namespace

Pass light_shading_pass() {
  return {.definition = definition("view", "light_shading", "direct", "caustic"),
          .called_for_by = [](const Effects& effects) -> std::optional<std::string> {
            if (!effects.light.active || effects.medium.active) return {};
            return "the light shines on what the camera sees";
          },
          .each = Each::Light,
          .extent = Extent::Picture,
          .uniforms = uniforms,
          .owner = Each::Frame};
}

Pass wide_shading_pass() {
  return {.definition = definition("wide", "wide_shading", "wide_direct", "wide_caustic"),
          .called_for_by = [](const Effects& effects) -> std::optional<std::string> {
            if (!effects.light.active || !effects.seen_casters.active) return {};
            if (effects.medium.active) return {};
            return "the light shines on what glass shows";
          },
          .each = Each::Light,
          .extent = Extent::Wide,
          .uniforms = uniforms,
          .owner = Each::Frame};
}

Pass light_shading_in_medium_pass() {
  return in_medium(light_shading_pass(), [](const Effects& effects) -> std::optional<std::string> {
    if (!effects.light.active || !effects.medium.active) return {};
    return "the light shines through the medium on what the camera sees";
  });
}

Pass wide_shading_in_medium_pass() {
  return in_medium(wide_shading_pass(), [](const Effects& effects) -> std::optional<std::string> {
    if (!effects.light.active || !effects.seen_casters.active || !effects.medium.active) return {};
    return "the light shines through the medium on what glass shows";
  });
}

}  // namespace caustics
