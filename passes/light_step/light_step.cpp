#include "passes/light_step/light_step.hpp"

#include "passes/shared/hierarchy_reads.hpp"
#include "passes/walk/walk.hpp"
#include "pipeline/effects/branches.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

extern const Shader light_step_shader;

namespace {

std140::LightStep light_step_uniforms(const PassContext& context) {
  return {.bend = static_cast<float>(context.branch->bend),
          .most_steps = most_steps(0),
          .first_receiver = context.first_receiver,
          .touch = context.touch,
          .rough_from = context.settings->glass_roughness,
          .first_uv = context.first_uv};
}

int meets_textures(const PassContext& context) {
  return caster_detail(*context.effects) != CasterDetail::None ? 1 : 0;
}

}  // namespace

Pass light_step_pass() {
  return {
      .name = "light_step",
      .purpose = "takes rays of light to the next surface that each meets, and both its ways from there",
      .reason = "pilots follow light all its way",
      .drawn_for = {kRays},
      .reads = {{.name = "rays",
                 .meaning = "four blocks of rows, from the bottom. xyz: where each ray starts, metres, scene "
                            "space, w: number of the triangle that it starts on, plus 1; xyz: direction, "
                            "unit, w: 1 where there is a ray; the bodies that it is in; xy: drawn between 0 "
                            "and 1, for rough glass"},
                {.name = kCasterMaterials, .meaning = "a row a material"},
                kReadHierarchyNodes,
                kReadHierarchyTriangles,
                kReadHierarchyNormals,
                kReadCasterTexels},
      .writes =
          {{.name = "met",
            .meaning = "xyz: what it meets, metres, scene space; w: the triangle's number plus 1, 0 where "
                       "nothing is met, -1 where the search took too many steps"},
           {.name = "left", .meaning = "rgb: share that is left on the way there; w: 1 from outside, 0"},
           {.name = "mirrored_way", .meaning = "xyz: direction, unit; w: share of what comes that goes back"},
           {.name = "mirrored_light", .meaning = "rgb: of what goes back, what is left; w: 0"},
           {.name = "crossing_way", .meaning = "xyz: direction, unit; w: 1 where the surface has a hole"},
           {.name = "crossing_light", .meaning = "rgb: of what crosses, what is left; w: 0"},
           {.name = "crossing_media", .meaning = "the bodies that it is in behind the surface"}},
      .shaders = {{&light_step_shader, block_of<light_step_uniforms>}},
      .choices = {{"has_textures", meets_textures},
                  {"has_rough", chosen_by<&Effects::rough_glass>},
                  kHasWalls,
                  kHasCutOuts},
  };
}

}  // namespace caustics
