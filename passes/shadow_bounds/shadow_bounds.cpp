#include "passes/shadow_bounds/shadow_bounds.hpp"

#include "passes/shared/light_uniforms.hpp"

namespace caustics::std140 {

struct ShadowBounds {
#include "passes/shadow_bounds/shadow_bounds_uniforms.glsl"
};

}  // namespace caustics::std140

namespace caustics {

extern const Shader shadow_bounds_shader;

namespace {

// A side. 64 blocks are 32 texels of a shadow map of 2048.
constexpr int kBlocks = 64;

}  // namespace

Pass shadow_bounds_pass() {
  return {
      .name = "shadow_bounds",
      .purpose = "bounds the depths in blocks of a light's maps, so that haze finds its edges",
      .reason = "the medium scatters the light between its shadows",
      .when = {&Effects::scattering},
      .drawn_for = {kLight},
      .size =
          [](const Settings&, const Effects&, const LightEffects*) {
            return TargetSize{kBlocks, kBlocks};
          },
      .reads = {{.name = "shadow_depth", .meaning = "opaque surfaces", .optional = true},
                {.name = "caster_position", .meaning = "casters", .optional = true},
                {.name = "pane_transmittance", .meaning = "what thin panes let through", .optional = true}},
      .writes = {{.name = "shadow_bounds",
                  .meaning = "x, y: least and largest depth of the block's texels of shadow_depth, metres; "
                             "1e30 where there is no surface"},
                 {.name = "caster_bounds",
                  .meaning = "x, y: likewise, of the casters' depth along the light"},
                 {.name = "pane_bounds",
                  .meaning = "y: by how much pane_transmittance differs within the block, in the channel in "
                             "which it differs most"}},
      .shaders = {{&shadow_bounds_shader, block_of<[](const PassContext& c) {
                     return std140::ShadowBounds{.caster_view = shader_view(c.views->caster),
                                                 .blocks = kBlocks};
                   }>}},
      .choices = {{"has_shadow_map", chosen_by<&Effects::occluders>},
                  {"has_caustic", throws_caustic},
                  {"has_panes", chosen_by<&Effects::tinted_light>}},
  };
}

}  // namespace caustics
