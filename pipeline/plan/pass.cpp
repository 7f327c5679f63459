#include "pipeline/plan/pass.hpp"

#include <algorithm>
#include <set>

#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/validate.hpp"

namespace caustics {

namespace {

bool wanted(Condition condition, const Effects& effects) { return !condition || condition(effects); }

const Shader* shader_of(const Pass& pass, const Effects& effects) {
  const Shader* shader = nullptr;
  for (const Permutation& permutation : pass.shaders)
    if (wanted(permutation.condition, effects)) shader = permutation.shader;
  return shader;
}

}  // namespace

PassDefinition definition_of(const Pass& pass, const Effects& effects, const DrawnFor& drawn_for) {
  PassDefinition definition{.name = std::string(pass.name),
                            .purpose = std::string(pass.purpose),
                            .depth = pass.depth,
                            .topology = pass.topology,
                            .depth_state = pass.depth_state,
                            .cull = pass.cull,
                            .count_samples = pass.count_samples,
                            .shader = shader_of(pass, effects)};
  if (!drawn_for.label.empty()) definition.name += "." + std::string(drawn_for.label);
  for (const Read& read : pass.reads)
    if (wanted(read.only_with, effects))
      definition.reads.push_back({.name = std::string(read.name),
                                  .meaning = std::string(read.meaning),
                                  .of_material = read.of_material,
                                  .optional = read.optional || !read.only_for.empty(),
                                  .only_towards = std::string(read.only_towards)});
  for (const Write& write : pass.writes)
    if (wanted(write.only_with, effects))
      definition.writes.push_back({.name = std::string(write.name),
                                   .format = write.format_by ? write.format_by(effects) : write.format,
                                   .meaning = std::string(write.meaning),
                                   .clear = write.clear,
                                   .blend = write.blend,
                                   .mask = write.mask});
  if (pass.otherwise) pass.otherwise(drawn_for, definition);
  return definition;
}

void validate(const Registry& registry) {
  std::set<std::string_view> names;
  for (const Pass& pass : registry) {
    if (!names.insert(pass.name).second)
      throw Error(ExitCode::InternalError,
                  "pass '" + std::string(pass.name) + "' is registered twice; remove one");
    if (!pass.uniforms)
      throw Error(ExitCode::InternalError,
                  "pass '" + std::string(pass.name) + "' has no uniforms; set `uniforms`");
    for (const DrawnFor& drawn_for : pass.drawn_for) {
      validate(definition_of(pass, {}, drawn_for));
      for (const NamedEffect& named : named_effects()) {
        Effects effects;
        (effects.*named.effect).active = true;
        validate(definition_of(pass, effects, drawn_for));
      }
    }
  }
}

TargetSize grid_size(const Settings& settings, const Effects&, const LightEffects*) {
  return {settings.grid, settings.grid};
}
TargetSize map_size(const Settings& settings, const Effects&, const LightEffects*) {
  return {settings.map, settings.map};
}
TargetSize shadow_size(const Settings& settings, const Effects&, const LightEffects*) {
  return {settings.shadow, settings.shadow};
}

TargetSize receiver_size(const Settings& settings, const Effects& effects, const LightEffects* light) {
  const bool hides = effects.hidden_receivers.active && light && sees_through_window(*light);
  const int side = hides ? 2 * settings.map : settings.map;
  return {side, side};
}

TargetSize beams_size(const Settings& settings, const Effects&, const LightEffects*) {
  return {beams_a_side(settings), beams_a_side(settings)};
}

}  // namespace caustics
