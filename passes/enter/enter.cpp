#include "passes/enter/enter.hpp"

#include "passes/shared/bend_light_uniforms.hpp"
#include "passes/shared/grid_light_uniforms.hpp"
#include "passes/shared/hierarchy_reads.hpp"

namespace caustics {

extern const Shader enter_shader;

namespace {

std140::Enter enter_uniforms(const PassContext& context) {
  std140::Enter block{};
  set_grid_light(block, context);
  set_bend_light(block, context);
  return block;
}

}  // namespace

Pass enter_pass() {
  return {
      .name = "enter",
      .purpose = "sends each grid vertex's light through the first surface that it meets, or off it",
      .reason = "light goes other ways than through two surfaces",
      .when = {&Effects::caustics, &Effects::further_surfaces},
      .drawn_for = {kFirstSurface},
      .only_lights_with_caustics = true,
      .size = grid_size,
      .reads = {{.name = "caster_position", .meaning = "grid vertices", .discards_where_zero = true},
                {.name = "caster_normal", .meaning = "their normals and materials"},
                {.name = kCasterTriangle, .meaning = "their triangles"},
                {.name = kCasterMaterials, .meaning = "a row a material"},
                kReadHierarchyTriangles,
                kReadHierarchyNormals,
                kReadReaching},
      .writes = path_writes(),
      .count_samples = true,
      .shaders = {{&enter_shader, block_of<enter_uniforms>}},
      .choices = {kBothWays, kFollowsMirrored, kIsTinted},
  };
}

}  // namespace caustics
