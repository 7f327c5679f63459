#include "passes/caustic_map/caustic_map.hpp"

#include "passes/shared/caustic_map_write.hpp"
#include "pipeline/settings/splat_kernel.hpp"

namespace caustics {

extern const Shader caustic_map_shader;

CausticMapUniforms caustic_map_uniforms(const PassContext& context, const View& map) {
  const ViewUniforms view = pack(map);
  const SplatKernel kernel = splat_kernel(*context.settings);
  return {
      .from_scene = view.from_scene,
      .window = view.window,
      .depth = view.depth,
      .kernel = {static_cast<float>(kernel.radius), static_cast<float>(kernel.sharpness),
                 static_cast<float>(1.0 / kernel.mass), static_cast<float>(kernel.point_size)},
      .grid = {context.settings->grid, context.settings->map,
               context.settings->splat == Splat::Cell ? 1 : 0, 0},
  };
}

Pass caustic_map_pass() {
  return {
      .name = "caustic_map",
      .purpose = "adds up the light that landed, texel by texel",
      .reason = "the landings' flux is gathered for the camera",
      .when = {&Effects::caustics},
      .drawn_for = {kBranch, kBranchFar, kBranchCascade},
      .only_lights_with_caustics = true,
      .draws = DrawSet::GridVertices,
      .size = map_size,
      .reads = {{.name = "landing", .meaning = "where each grid vertex's light lands"},
                {.name = "landing_flux", .meaning = "how much of it is left"},
                {.name = kCellFlux, .meaning = "which cells have taken their quarter of it", .optional = true}},
      .writes = {caustic_map_write()},
      .owner = Each::Light,
      .topology = Topology::Points,
      .shaders = {{&caustic_map_shader}},
      .uniforms =
          [](const PassContext& context) {
            const View& map = context.cascade() ? *context.views->cascade : context.views->caustic;
            return uniform_bytes(caustic_map_uniforms(context, map));
          },
  };
}

}  // namespace caustics
