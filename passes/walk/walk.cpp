#include "passes/walk/walk.hpp"

#include <algorithm>
#include <cmath>

#include "passes/landing/landing.hpp"
#include "passes/shared/grid_light_uniforms.hpp"
#include "passes/shared/hierarchy_reads.hpp"
#include "passes/shared/medium_uniforms.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/scene/exact.hpp"

namespace caustics {

extern const Shader walk_shader;
extern const Shader walk_in_medium_shader;

namespace {

// Of the light whose caustic is its whole source's.
const Light* wide_source(const PassContext& context) {
  const bool drawn = context.of_light && context.of_light->size_is_drawn;
  return drawn ? &context.scene->sources[static_cast<std::size_t>(context.light->source)] : nullptr;
}

int light_shape(const PassContext& context) {
  const Light* source = wide_source(context);
  if (!source) return 0;
  if (source->is_ball()) return source->shape == LightShape::Mesh ? 4 : 1;
  if (source->is_rectangle()) return 2;
  return source->is_lamp() ? 5 : 3;
}

void set_size(std140::Walk& block, const PassContext& context) {
  const Light* source = wide_source(context);
  if (!source) return;
  const bool far_away = source->shape == LightShape::Disk;
  block.light_middle = glm::vec3(far_away ? source->direction : source->position);
  block.light_radius = static_cast<float>(source->radius);
  if (far_away) {
    double sine, cosine;
    exact::sin_cos(source->angular_radius, sine, cosine);
    block.light_radius = static_cast<float>(sine / cosine);
  }
  if (source->is_lamp()) {
    if (context.first_point < 0)
      throw Error(ExitCode::InternalError, "the points of light '" + source->name + "' are in no table");
    block.light_points = context.first_point;
    const Mesh& mesh = context.scene->meshes[static_cast<std::size_t>(source->emitter)];
    block.light_radius = static_cast<float>(0.5 * bounds_of(mesh).radius());
  }
  if (!source->is_rectangle()) return;
  block.light_width = glm::vec3(source->width);
  block.light_height = glm::vec3(source->height);
  const double area = exact::length(exact::cross(source->width, source->height));
  block.light_radius = static_cast<float>(std::sqrt(area / exact::kPi));
}

int can_be_hidden(const PassContext& context) {
  if (context.effects->receivers_are_one_plane) return 0;
  const bool parts = context.of_light && context.of_light->lit.behind == LitFromBehind::InFarthest;
  return parts && !context.views->caustic.cube ? 2 : 1;
}

int reads_hit(const PassContext& context) { return context.branch->has_same_start() ? 1 : 0; }

bool some_branch_reads_hits(const Effects& effects) {
  return std::any_of(effects.branches.begin(), effects.branches.end(),
                     [](const Branch& branch) { return branch.has_same_start(); });
}

}  // namespace

std140::Walk walk_uniforms(const PassContext& context) {
  std140::Walk block{};
  set_grid_light(block, context);
  block.receiver = shader_view(context.views->receiver);
  block.caustic = shader_view(context.views->caustic);
  set_size(block, context);
  block.channel_share = context.branch->color;
  block.bend = static_cast<float>(context.branch->bend);
  block.least_share = context.settings->least_share;
  block.bounces = context.settings->bounces;
  block.splits = context.settings->splits;
  block.mirrored_at = context.branch->mirrored_at;
  block.most_steps = most_steps(context.settings->bounces);
  block.first_receiver = context.first_receiver;
  block.touch = context.touch;
  block.rough_from = context.settings->glass_roughness;
  block.first_uv = context.first_uv;
  return block;
}

std::vector<Read> reads_of_walk() {
  return {{.name = "caster_position", .meaning = "grid vertices", .discards_where_zero = true},
          {.name = "caster_normal", .meaning = "their normals and materials"},
          {.name = kCasterMaterials, .meaning = "a row a material"},
          kReadHierarchyNodes,
          kReadHierarchyTriangles,
          kReadHierarchyNormals,
          kReadReaching,
          {.name = "receiver_position", .meaning = "what the light sees that its light can land on"},
          {.name = "second_surface",
           .meaning = "what light meets second, as a branch has found it that comes there alike",
           .texture = "second_hit",
           .optional = true,
           .of_same_start = true},
          kReadCasterTexels};
}

std::vector<Choice> choices_of_walk() {
  return {kIsTinted,
          {"can_be_hidden", can_be_hidden},
          {"draws", [](const PassContext& c) { return c.branch->drawn ? 1 : 0; }},
          {"reads_hit", reads_hit},
          kHasTextures,
          {"has_rough", chosen_by<&Effects::rough_glass>},
          kHasWalls,
          kHasCutOuts,
          {"light_shape", light_shape}};
}

Pass walk_pass() {
  return {
      .name = "walk",
      .purpose = "follows each grid vertex's light from surface to surface, to where it lands",
      .reason = "light goes other ways than through two surfaces",
      .when = {&Effects::caustics, &Effects::further_surfaces},
      .drawn_for = {kBranch},
      .only_lights_with_caustics = true,
      .size = grid_size,
      .reads = reads_of_walk(),
      .writes =
          {{.name = kLanding, .meaning = "xyz: where the light lands, metres, scene space; w: LandingStatus"},
           {.name = kLandingFlux,
            .meaning = "rgb: flux that is left, relative to the light's intensity (square metres, or "
                       "steradians); w: 0"},
           {.name = kLandingFresnel,
            .meaning = "rgb: flux reflected at the surfaces and not followed; w: flux that entered the "
                       "cell"},
           {.name = kLandingAbsorbed, .meaning = "rgb: flux absorbed in the material"},
           {.name = kLandingPath, .meaning = "r: a number for the bodies and events on the light's path"},
           {.name = kLandingFootprint,
            .meaning = "how the landing moves along the grid's rows (xy) and columns (zw), parts of the "
                       "caustic map"},
           {.name = "second_hit",
            .meaning = "what the light meets second. xy: weights of the triangle's second and third "
                       "corner; z: metres to it; w: its number plus 1, 0 where nothing is met, -1 where "
                       "the search took too many steps",
            .needed_if = some_branch_reads_hits},
           {.name = kLandingMedium,
            .meaning = "rgb: flux that the medium takes before the casters, between and behind them",
            .only_with = with<&Effects::medium>}},
      .count_samples = true,
      .shaders = {{&walk_shader, block_of<walk_uniforms>},
                  {&walk_in_medium_shader, block_of<in_medium<walk_uniforms>>, with<&Effects::medium>}},
      .choices = choices_of_walk(),
  };
}

}  // namespace caustics
