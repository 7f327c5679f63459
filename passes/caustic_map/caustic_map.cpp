#include "passes/caustic_map/caustic_map.hpp"

#include "pipeline/plan/splat_kernel.hpp"

namespace caustics {

extern const Shader caustic_map_shader;

namespace {

CausticMapUniforms caustic_map_uniforms(const PassContext& context) {
  const FrameUniforms frame = pack(context.frames->caustic);
  const SplatKernel kernel = splat_kernel(*context.settings);
  return {
      .from_scene = frame.from_scene,
      .window = frame.window,
      .depth = frame.depth,
      .kernel = {static_cast<float>(kernel.radius), static_cast<float>(kernel.sharpness),
                 static_cast<float>(1.0 / kernel.mass), static_cast<float>(kernel.point_size)},
      .grid = {context.settings->grid, context.settings->map,
               context.settings->splat == Splat::Cell ? 1 : 0, 0},
  };
}

}  // namespace

Pass caustic_map_pass() {
  return {
      .definition =
          {
              .name = "caustic_map",
              .purpose = "adds up the light that landed, texel by texel",
              .reads = {{.name = "landing", .meaning = "where each grid vertex's light lands"},
                        {.name = "landing_flux", .meaning = "how much of it is left"},
                        {.name = kCellFlux,
                         .meaning = "which cells have taken their quarter of it",
                         .optional = true}},
              .writes = {{.name = "caustic_map",
                          .format = Format::RGBA32F,
                          .meaning = "rgb: flux in the texel, relative to the light's intensity (square "
                                     "metres, or steradians); a: number of cells and splats, by weight",
                          .blend = kAccumulate}},
              .topology = Topology::Points,
              .shader = &caustic_map_shader,
          },
      .called_for_by = [](const Effects& effects) -> std::optional<std::string> {
        if (!effects.active("caustics")) return {};
        return "the landings' flux is gathered for the camera";
      },
      .each = Each::Branch,
      .draws = DrawSet::GridVertices,
      .extent = Extent::Map,
      .uniforms =
          [](const PassContext& context) { return uniform_bytes(caustic_map_uniforms(context)); },
      .owner = Each::Light,
  };
}

}  // namespace caustics
