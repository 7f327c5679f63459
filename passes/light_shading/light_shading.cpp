#include "passes/light_shading/light_shading.hpp"

#include <glm/glm.hpp>

#include "passes/shared/hierarchy_reads.hpp"
#include "passes/shared/light_uniforms.hpp"
#include "passes/shared/medium_uniforms.hpp"
#include "pipeline/settings/settings.hpp"
#include "pipeline/settings/splat_kernel.hpp"

namespace caustics::std140 {

struct LightShading {
#include "passes/light_shading/light_shading_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

extern const Shader light_shading_shader;
extern const Shader light_shading_in_medium_shader;

namespace {

// Of a caustic over a pixel, along an axis: pixels up to this many texels wide see the mean without gaps.
// Pixels on one surface share its texels, so there are hardly more samples in all than texels, however wide
// the pixels are. What glass shows is bent by it, or mirrored.
constexpr int kMostSamples = 64, kMostBehindGlass = 8;

int samples_across(const PassContext& context) {
  if (!context.settings->pixel_means) return 0;
  return context.of_picture() ? kMostSamples : kMostBehindGlass;
}

int lights_backs(const PassContext& context) {
  if (!context.of_light) return 0;
  const LitFromBehind behind = context.of_light->lit.behind;
  if (behind == LitFromBehind::No) return 0;
  // Light all around has no map of the farthest receivers.
  return behind == LitFromBehind::InNearest || context.views->caustic.cube ? 2 : 1;
}

int is_layer(const PassContext& context) {
  if (context.of_picture()) return context.layer() > 0 ? 1 : 0;
  return context.effects->layered.active ? 2 : 1;
}

int looks_aside(const PassContext& context) {
  return throws_caustic(context) && context.views->caustic.forward != context.views->shadow.forward;
}

int has_finer_map(const PassContext& context) { return context.views->cascade && throws_caustic(context); }

// Not of lights that see all around.
int receivers_are_layered(const PassContext& context) {
  return throws_caustic(context) && context.effects->hidden_receivers.active && !context.views->caustic.cube;
}

// Of a cube, from a tile's middle to its outermost texels' centres, in map coordinates.
glm::vec2 tile_reach(const View& view) {
  if (!view.cube) return glm::vec2(0.0f);
  return glm::vec2(0.5 * glm::dvec2(view.cube->tile_width() - 1, view.cube->tile_height() - 1) /
                   static_cast<double>(view.cube->side));
}

bool is_beyond_panes(const PassContext& context) {
  return context.drawn_for && context.drawn_for->label == kLightBeyondPanes.label;
}

// Those that the camera sees before all else, or through panes. They mirror meshes that shine as such.
int casters_shine(const PassContext& context) {
  const bool shine = context.of_picture() && context.layer() == 0 && context.effects->highlights.active &&
                     context.effects->seen_casters.active && context.light->emitter < 0;
  return is_beyond_panes(context) ? 2 + (shine ? 0 : 1) : shine ? 1 : 0;
}

std::string_view casters_in_view(const Effects&, const DrawnFor& drawn_for) {
  return drawn_for.label == kLightBeyondPanes.label ? kCastersBeyondPanes : "caster_position.camera";
}

std::string_view normals_in_view(const Effects&, const DrawnFor& drawn_for) {
  return drawn_for.label == kLightBeyondPanes.label ? kNormalsBeyondPanes : "caster_normal.camera";
}

int has_walls(const PassContext& context) {
  return casters_shine(context) == 0 ? 0 : kHasWalls.value(context);
}

// Blended surfaces do not shadow one another.
int has_panes(const PassContext& context) {
  return context.effects->tinted_light.active && context.layer() == 0 ? 1 : 0;
}

std140::LightShading light_shading_uniforms(const PassContext& context) {
  const LightViews& views = *context.views;
  const Settings& settings = *context.settings;
  const bool cascade = has_finer_map(context);
  const View cascade_view = views.cascade.value_or(View{});
  const View camera = context.camera ? *context.camera : View{};
  const double texels = static_cast<double>(settings.map) * static_cast<double>(settings.map);
  const glm::dvec2 part = cascade_view.window_upper - cascade_view.window_lower;
  const glm::dvec2 whole = views.caustic.window_upper - views.caustic.window_lower;
  const glm::dvec2 from = views.caustic.window_lower - cascade_view.window_lower;
  return {
      .light = shader_light(*context.light, views.shadow.forward),
      .caustic_intensity = caustic_intensity(context),
      .shadow_view = shader_view(views.shadow),
      .caster_view = shader_view(views.caster),
      .receiver_view = shader_view(views.receiver),
      .caustic_view = shader_view(views.caustic),
      .caustic_side = static_cast<float>(context.settings->map),
      .cascade_view = shader_view(cascade_view),
      .pane_view = shader_view(views.panes),
      .column = shader_view(views.column),
      .casters_nearest = static_cast<float>(views.casters_nearest),
      .caustic_texel_area = static_cast<float>(views.caustic.window_area() / texels),
      .cascade_texel_area = cascade ? static_cast<float>(cascade_view.window_area() / texels) : 0.0f,
      .cascade_border = cascade ? static_cast<float>(cascade_border(settings) / settings.map) : 0.0f,
      .cascade_from = cascade ? glm::vec2(from / part) : glm::vec2(0.0f),
      .cascade_step = cascade ? glm::vec2(whole / part / static_cast<double>(settings.map)) : glm::vec2(0.0f),
      .tile_reach = tile_reach(views.caustic),
      .eye = camera.origin,
      .forward = camera.forward,
      .is_perspective = camera.perspective ? 1 : 0,
  };
}

}  // namespace

Pass light_shading_pass() {
  return {
      .name = "light_shading",
      .purpose = "adds what one light gives to the surfaces in view, directly and by its caustics",
      .reason = "the light shines on what the camera sees",
      .when = {&Effects::light},
      .drawn_for = with_layers({kLight, kLightBehind, kLightMirrored, kLightBeyondPanes}),
      .reads = {{.name = "view_position",
                 .meaning = "the surfaces",
                 .layers_discard_where_zero = true,
                 .hidden_discard_where_zero = true},
                {.name = "view_normal", .meaning = "their normals"},
                {.name = "shadow_depth", .meaning = "what shadows them", .optional = true},
                {.name = "caster_position",
                 .meaning = "the casters, which shadow them too",
                 .optional = true},
                {.name = "receiver_position",
                 .meaning = "which surfaces the caustic map belongs to",
                 .optional = true,
                 .only_towards = "caustic"},
                {.name = kCausticMap,
                 .meaning = "the casters' light",
                 .optional = true,
                 .only_towards = "caustic"},
                {.name = "cascade_map",
                 .meaning = "a part of it, finer",
                 .texture = kCascadeMap,
                 .optional = true,
                 .only_towards = "caustic"},
                {.name = "pane_transmittance", .meaning = "what thin panes let through", .optional = true},
                {.name = "far_receiver_position",
                 .meaning = "the farthest surfaces that the light sees",
                 .texture = "receiver_position.far",
                 .optional = true,
                 .only_towards = "caustic"},
                {.name = "far_caustic_map",
                 .meaning = "the casters' light on these",
                 .texture = "caustic_map.far",
                 .optional = true,
                 .only_towards = "caustic"},
                {.name = "view_specular",
                 .meaning = "how the surfaces mirror",
                 .optional = true,
                 .of_picture = true,
                 .only_towards = "highlight"},
                {.name = "view_caster_position",
                 .meaning = "the glass and metal in view",
                 .texture_by = casters_in_view,
                 .optional = true,
                 .only_towards = "caster_highlight"},
                {.name = "view_caster_normal",
                 .meaning = "its normals and materials",
                 .texture_by = normals_in_view,
                 .optional = true,
                 .only_towards = "caster_highlight"},
                {.name = kCasterMaterials,
                 .meaning = "indices, roughness, tint",
                 .optional = true,
                 .only_towards = "caster_highlight",
                 .needed_with = &Effects::seen_casters},
                {.name = "view_lift",
                 .meaning = "how far they bulge over their triangles",
                 .optional = true,
                 .of_picture = true,
                 .needed_with = &Effects::smooth_shading}},
      .writes = {{.name = "direct",
                  .meaning = "rgb: direct irradiance after shadows, lux",
                  .blend = kAccumulate,
                  .not_for = kLightBeyondPanes.label},
                 {.name = "caustic",
                  .meaning = "rgb: irradiance from caustics, lux",
                  .blend = kAccumulate,
                  .needed_if = with<&Effects::caustics>,
                  .not_for = kLightBeyondPanes.label},
                 {.name = "highlight",
                  .meaning = "rgb: radiance that the surface mirrors of the lights, nit",
                  .blend = kAccumulate,
                  .needed_if = with<&Effects::highlights>,
                  .not_for = kLightBeyondPanes.label},
                 {.name = "caster_highlight",
                  .meaning = "rgb: the same of glass and metal before it",
                  .blend = kAccumulate,
                  .needed_if = with<&Effects::seen_casters>}},
      .owner = Each::Frame,
      .shaders = {{&light_shading_shader, block_of<light_shading_uniforms>},
                  {&light_shading_in_medium_shader, block_of<in_medium<light_shading_uniforms>>,
                   with<&Effects::medium>}},
      .choices = {{"has_shadow_map", chosen_by<&Effects::occluders>},
                  {"has_lift", of_picture<&Effects::smooth_shading>},
                  {"has_panes", has_panes},
                  {"has_caustic", throws_caustic},
                  {"looks_aside", looks_aside},
                  {"lights_backs", lights_backs},
                  {"has_cascade", has_finer_map},
                  {"receivers_are_layered", receivers_are_layered},
                  {"caustic_is_grey",
                   [](const PassContext& c) { return c.effects->coloured_caustics.active ? 0 : 1; }},
                  {"has_highlights", of_picture<&Effects::highlights>},
                  {"is_layer", is_layer},
                  {"casters_shine", casters_shine},
                  {"has_walls", has_walls},
                  {"samples_across", samples_across}},
  };
}

}  // namespace caustics
