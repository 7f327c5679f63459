#include "passes/land/land.hpp"

#include "passes/landing/landing.hpp"
#include "passes/shared/hierarchy_reads.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

extern const Shader land_shader;

namespace {

std140::Land land_uniforms(const PassContext& context) {
  return {.receiver = shader_view(context.views->receiver),
          .caustic = shader_view(context.views->caustic),
          .channel_share = context.branch->color,
          .first_receiver = context.first_receiver};
}

std::vector<Read> land_reads() {
  std::vector<Read> reads = path_reads();
  reads.push_back(
      {.name = "surface_hit", .meaning = "what lies ahead of the light", .surface = OfSurface::Here});
  reads.push_back({.name = kCasterMaterials, .meaning = "a row a material"});
  reads.push_back(kReadHierarchyTriangles);
  reads.push_back(kReadHierarchyNormals);
  reads.push_back({.name = "receiver_position", .meaning = "what the light sees that its light can land on"});
  return reads;
}

}  // namespace

Pass land_pass() {
  return {
      .name = "land",
      .purpose = "finds where light lands that meets no further caster",
      .reason = "light goes other ways than through two surfaces",
      .when = {&Effects::caustics, &Effects::further_surfaces},
      .drawn_for = {kSurfaceAhead},
      .only_lights_with_caustics = true,
      .size = grid_size,
      .reads = land_reads(),
      .writes = {{.name = kLanding,
                  .meaning = "xyz: where the light lands, metres, scene space; w: LandingStatus",
                  .keeps = true},
                 {.name = kLandingFlux,
                  .meaning = "rgb: flux that is left, relative to the light's intensity (square metres, or "
                             "steradians); w: 0",
                  .keeps = true},
                 {.name = kLandingAbsorbed,
                  .meaning = "rgb: flux absorbed in the material",
                  .blend = kAccumulate,
                  .keeps = true},
                 {.name = kLandingPath,
                  .meaning = "r: a number for the bodies and events on the light's path",
                  .keeps = true},
                 {.name = kLandingFootprint,
                  .meaning =
                      "how the landing moves along the grid's rows (xy) and columns (zw), parts of the "
                      "caustic map",
                  .keeps = true}},
      .shaders = {{&land_shader, block_of<land_uniforms>}},
      .choices = {{"can_be_hidden",
                   [](const PassContext& c) { return c.effects->receivers_are_one_plane ? 0 : 1; }},
                  {"is_last_round",
                   [](const PassContext& c) { return c.surface > c.settings->bounces ? 1 : 0; }}},
  };
}

}  // namespace caustics
