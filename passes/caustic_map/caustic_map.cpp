#include "passes/caustic_map/caustic_map.hpp"

#include "passes/shared/caustic_map_write.hpp"
#include "pipeline/settings/splat_kernel.hpp"

namespace caustics {

extern const Shader caustic_map_shader;

namespace {

// The flux is gathered where there is any, in as many channels as it has.
std::optional<std::string> called_for(const Effects& effects, bool coloured) {
  if (!effects.caustics.active || effects.coloured_caustics.active != coloured) return {};
  return "the landings' flux is gathered for the camera";
}
std::optional<std::string> called_for_coloured(const Effects& e) { return called_for(e, true); }
std::optional<std::string> called_for_grey(const Effects& e) { return called_for(e, false); }

}  // namespace

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

namespace {

Pass caustic_map_pass(bool coloured) {
  return {
      .definition =
          {
              .name = coloured ? "caustic_map" : "caustic_map_grey",
              .purpose = "adds up the light that landed, texel by texel",
              .reads = {{.name = "landing", .meaning = "where each grid vertex's light lands"},
                        {.name = "landing_flux", .meaning = "how much of it is left"},
                        {.name = kCellFlux,
                         .meaning = "which cells have taken their quarter of it",
                         .optional = true}},
              .writes = {caustic_map_write(coloured)},
              .topology = Topology::Points,
              .shader = &caustic_map_shader,
          },
      .called_for_by = coloured ? called_for_coloured : called_for_grey,
      .each = Each::Branch,
      .draws = DrawSet::GridVertices,
      .extent = Extent::Map,
      .uniforms =
          [](const PassContext& context) {
            return uniform_bytes(caustic_map_uniforms(context, context.views->caustic));
          },
      .owner = Each::Light,
  };
}

}  // namespace

Pass caustic_map_pass() { return caustic_map_pass(true); }
Pass caustic_map_grey_pass() { return caustic_map_pass(false); }

}  // namespace caustics
