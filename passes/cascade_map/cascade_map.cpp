#include "passes/cascade_map/cascade_map.hpp"

#include "passes/caustic_map/caustic_map.hpp"
#include "passes/shared/caustic_map_write.hpp"

namespace caustics {

extern const Shader cascade_cells_shader;

namespace {

bool has_cascade(const Effects& effects, int light) {
  return !effects.lights[static_cast<std::size_t>(light)].cascade.empty();
}

std::optional<std::string> called_for(const Effects& effects, bool coloured) {
  if (!effects.cascades.active || effects.coloured_caustics.active != coloured) return {};
  return "most of the light falls on little of its map";
}
std::optional<std::string> called_for_coloured(const Effects& e) { return called_for(e, true); }
std::optional<std::string> called_for_grey(const Effects& e) { return called_for(e, false); }

// Cells only where landings are joined to them.
template <std::optional<std::string> (*called_for)(const Effects&)>
std::optional<std::string> with_cells(const Effects& effects) {
  if (!effects.cells.active) return {};
  return called_for(effects);
}

CascadeMapUniforms cells_uniforms(const PassContext& context) {
  const View& map = context.views->caustic;
  const View& cascade = *context.views->cascade;
  const double texels = context.settings->map;
  const glm::dvec2 size = map.window_upper - map.window_lower;
  const glm::dvec2 part = cascade.window_upper - cascade.window_lower;
  const glm::dvec2 offset = (map.window_lower - cascade.window_lower) / part * texels;
  return {.from_map = glm::vec4(glm::vec2(size / part), glm::vec2(offset)),
          .grid = {context.settings->grid - 1, context.settings->map, 0, 0}};
}

Pass cells_pass(bool coloured) {
  return {
      .definition =
          {
              .name = coloured ? "cascade_cells" : "cascade_cells_grey",
              .purpose = "adds up the light of the cells once more, where it is dense, in finer texels",
              .reads = {{.name = kCellNear, .meaning = "each cell's lower corners in the caustic map"},
                        {.name = kCellFar, .meaning = "its upper corners"},
                        {.name = kCellFlux, .meaning = "its flux"}},
              .writes = {caustic_map_write(coloured, kCascadeMap)},
              .shader = &cascade_cells_shader,
          },
      .called_for_by = coloured ? with_cells<called_for_coloured> : with_cells<called_for_grey>,
      .each = Each::Branch,
      .draws = DrawSet::GridCellQuads,
      .extent = Extent::Map,
      .uniforms = [](const PassContext& context) { return uniform_bytes(cells_uniforms(context)); },
      .light_needs = has_cascade,
      .owner = Each::Light,
  };
}

// The caustic map's own pass, through the cascade's window.
Pass points_pass(bool coloured) {
  Pass pass = coloured ? caustic_map_pass() : caustic_map_grey_pass();
  pass.definition.name = coloured ? "cascade_map" : "cascade_map_grey";
  pass.definition.purpose = "adds up the light that landed where it is dense, in finer texels";
  pass.definition.writes = {caustic_map_write(coloured, kCascadeMap)};
  pass.called_for_by = coloured ? called_for_coloured : called_for_grey;
  pass.uniforms = [](const PassContext& context) {
    return uniform_bytes(caustic_map_uniforms(context, *context.views->cascade));
  };
  pass.light_needs = has_cascade;
  return pass;
}

}  // namespace

Pass cascade_cells_pass() { return cells_pass(true); }
Pass cascade_cells_grey_pass() { return cells_pass(false); }
Pass cascade_map_pass() { return points_pass(true); }
Pass cascade_map_grey_pass() { return points_pass(false); }

}  // namespace caustics
