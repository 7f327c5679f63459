#include "passes/caustic_footprints/caustic_footprints.hpp"

#include <algorithm>

#include "passes/shared/caustic_map_write.hpp"
#include "pipeline/settings/settings.hpp"
#include "pipeline/settings/splat_kernel.hpp"

namespace caustics {

extern const Shader caustic_footprints_shader;

namespace {

// Texels that a footprint may span in a cascade: as wide as in the whole map it would cost more than it
// shows.
constexpr double kLargestInCascade = 16.0;

std140::CausticFootprints footprints_uniforms(const PassContext& context) {
  const View& map = context.views->caustic;
  const View& drawn = context.cascade() ? *context.views->cascade : map;
  const double texels = context.settings->map;
  const glm::dvec2 part = drawn.window_upper - drawn.window_lower;
  const glm::dvec2 times = (map.window_upper - map.window_lower) / part;
  const glm::dvec2 offset = (map.window_lower - drawn.window_lower) / part;
  return {.map = shader_view(map),
          .scale = glm::vec2(times * texels),
          .offset = glm::vec2(offset * texels),
          .largest =
              static_cast<float>(std::min(kLargestFootprint * std::max(times.x, times.y), kLargestInCascade)),
          .grid_side = context.settings->grid,
          .map_side = context.settings->map,
          .is_part = context.cascade() ? 1 : 0};
}

}  // namespace

Pass caustic_footprints_pass() {
  return {
      .name = "caustic_footprints",
      .purpose = "adds up the light that no cell has taken, spread as its own differentials have it",
      .reason = "light that has no neighbour on the same path keeps its own width",
      .when = {&Effects::caustics, &Effects::cells, &Effects::further_surfaces},
      .drawn_for = {kBranch, kBranchFar, kBranchCascade},
      .only_lights_with_caustics = true,
      .draws = DrawSet::GridVertices,
      .size = map_size,
      .reads = {{.name = kLanding, .meaning = "where each grid vertex's light lands"},
                {.name = kLandingFlux, .meaning = "how much of it is left"},
                {.name = kLandingFootprint, .meaning = "how wide it is there"},
                {.name = kCellFlux, .meaning = "which cells have taken their quarter of it"}},
      .writes = {caustic_map_write()},
      .owner = Each::Light,
      .topology = Topology::Rectangles,
      .zero_outside_quad = 0,
      .shaders = {{&caustic_footprints_shader, block_of<footprints_uniforms>}},
  };
}

}  // namespace caustics
