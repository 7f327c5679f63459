#include "passes/caustic_map/caustic_map.hpp"

#include "passes/shared/caustic_map_write.hpp"
#include "pipeline/settings/settings.hpp"
#include "pipeline/settings/splat_kernel.hpp"

namespace caustics {

extern const Shader caustic_map_shader;

namespace {

std140::CausticMap caustic_map_uniforms(const PassContext& context) {
  const View& map = context.cascade() ? *context.views->cascade : context.views->caustic;
  const SplatKernel kernel = splat_kernel(*context.settings);
  return {
      .map = shader_view(map),
      .grid_side = context.settings->grid,
      .map_side = context.settings->map,
      .radius = static_cast<float>(kernel.radius),
      .sharpness = static_cast<float>(kernel.sharpness),
      .inverse_mass = static_cast<float>(1.0 / kernel.mass),
      .point_size = static_cast<float>(kernel.point_size),
  };
}

}  // namespace

Pass caustic_map_pass() {
  return {
      .name = "caustic_map",
      .purpose = "adds up the light that landed, texel by texel",
      .reason = "the landings' flux is gathered for the camera",
      .when = {&Effects::caustics},
      .unless = {&Effects::cells, &Effects::further_surfaces},
      .drawn_for = {kBranch, kBranchFar, kBranchCascade},
      .only_lights_with_caustics = true,
      .draws = DrawSet::GridVertices,
      .size = map_size,
      .reads = {{.name = "landing", .meaning = "where each grid vertex's light lands"},
                {.name = "landing_flux", .meaning = "how much of it is left"},
                {.name = kCellFlux,
                 .meaning = "which cells have taken their quarter of it",
                 .optional = true}},
      .writes = {caustic_map_write()},
      .owner = Each::Light,
      .topology = Topology::Points,
      .shaders = {{&caustic_map_shader, block_of<caustic_map_uniforms>}},
      .choices = {{"has_cells",
                   [](const PassContext& c) { return c.settings->splat == Splat::Cell ? 1 : 0; }}},
  };
}

}  // namespace caustics
