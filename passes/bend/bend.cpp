#include "passes/bend/bend.hpp"

#include "passes/shared/bend_light_uniforms.hpp"
#include "passes/shared/hierarchy_reads.hpp"

namespace caustics {

extern const Shader bend_shader;

namespace {

std140::Bend bend_uniforms(const PassContext& context) {
  std140::Bend block{};
  set_bend_light(block, context);
  block.first_receiver = context.first_receiver;
  return block;
}

std::vector<Read> bend_reads() {
  std::vector<Read> reads = path_reads();
  reads.push_back({.name = "surface_hit",
                   .meaning = "the surface that the light has met",
                   .surface = OfSurface::Here,
                   .discards_where_zero = true});
  reads.push_back({.name = kCasterMaterials, .meaning = "a row a material"});
  reads.push_back(kReadHierarchyTriangles);
  reads.push_back(kReadHierarchyNormals);
  return reads;
}

}  // namespace

Pass bend_pass() {
  return {
      .name = "bend",
      .purpose = "bends light at a further surface of the casters: refracted, totally reflected or mirrored",
      .reason = "light goes other ways than through two surfaces",
      .when = {&Effects::caustics, &Effects::further_surfaces},
      .drawn_for = {kFurtherSurface},
      .only_lights_with_caustics = true,
      .size = grid_size,
      .reads = bend_reads(),
      .writes = path_writes(),
      .count_samples = true,
      .shaders = {{&bend_shader, block_of<bend_uniforms>}},
      .choices = {kBothWays, kFollowsMirrored},
  };
}

}  // namespace caustics
