#include "pipeline/plan/pass.hpp"

#include <algorithm>
#include <set>

#include "pipeline/gpu/error.hpp"
#include "pipeline/gpu/validate.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

namespace {

// Of the farthest receivers only those count that others hide, where it is known which these are.
bool may_be_hidden(const DrawnFor& drawn_for, std::size_t mesh, const LightEffects* light) {
  if (drawn_for.receivers != ReceiverLayer::Farthest || !light) return true;
  return light->lit.hidden.empty() || light->lit.hidden[mesh];
}

}  // namespace

bool draws_mesh(DrawSet draws, const DrawnFor& drawn_for, const Effects& effects, std::size_t mesh,
                const LightEffects* light) {
  const SurfaceRole& role = effects.surfaces[mesh];
  switch (draws) {
    case DrawSet::Receivers:
      return drawn_for.layer > 0 ? is_layered(role)
                                 : role.role == Role::Receiver && may_be_hidden(drawn_for, mesh, light);
    case DrawSet::Casters:
      return is_caster(role.role) || (drawn_for.with_panes && role.role == Role::ThinPane);
    case DrawSet::Shadowing:
      return role.role == Role::Receiver || (light && light->casters_shadow && is_caster(role.role));
    case DrawSet::SolidCasters:
      return role.role == Role::Refractor && role.two_interfaces;
    case DrawSet::LightTinters:
      return tints_light(role);
    case DrawSet::FullScreen:
    case DrawSet::GridVertices:
    case DrawSet::GridColumns:
    case DrawSet::GridCells:
    case DrawSet::Beams:
      return false;
  }
  return false;
}

namespace {

// Texels by which a plane is known well enough: between them its points are interpolated without error, and
// only its edges are as wide as a texel.
constexpr int kSideOfPlane = 512;

bool wanted(Condition condition, const Effects& effects) { return !condition || condition(effects); }

Permutation permutation_of(const Pass& pass, const Effects& effects) {
  Permutation chosen;
  for (const Permutation& permutation : pass.shaders)
    if (wanted(permutation.condition, effects)) chosen = permutation;
  return chosen;
}

void set_state(PassDefinition& definition, const InstanceState& state) {
  if (definition.depth && state.depth_clear) definition.depth->clear = *state.depth_clear;
  if (state.depth_compare) definition.depth_state.compare = *state.depth_compare;
  for (ColorWrite& write : definition.writes)
    if (state.blend) write.blend = *state.blend;
}

[[noreturn]] void refuse(const Pass& pass, const std::string& why) {
  throw Error(ExitCode::InternalError, "pass '" + std::string(pass.name) + "': " + why);
}

std::string quoted(std::string_view name) { return "'" + std::string(name) + "'"; }

void validate_block(const Pass& pass, const Permutation& permutation) {
  if (!permutation.shader) refuse(pass, "has a permutation without a shader; set `shader`");
  const Shader& shader = *permutation.shader;
  if (shader.uniform_bytes && permutation.block.size != shader.uniform_bytes())
    refuse(pass, "its uniform block has " + std::to_string(permutation.block.size) +
                     " bytes, that of its shader " + quoted(shader.name) + " " +
                     std::to_string(shader.uniform_bytes()) +
                     "; give `block_of` a function that returns the struct of that text");
  for (const ShaderChoice& asked : choices_of(shader))
    if (std::none_of(pass.choices.begin(), pass.choices.end(),
                     [&](const Choice& choice) { return choice.name == asked.name; }))
      refuse(pass, "its shader " + quoted(shader.name) + " asks the choice " + quoted(asked.name) +
                       ", which nothing makes; add it to `choices`");
}

void validate_choice(const Pass& pass, const Choice& choice) {
  const auto asks = [&](const Permutation& permutation) {
    const auto asked = choices_of(*permutation.shader);
    return std::any_of(asked.begin(), asked.end(),
                       [&](const ShaderChoice& other) { return other.name == choice.name; });
  };
  if (std::none_of(pass.shaders.begin(), pass.shaders.end(), asks))
    refuse(pass, "makes the choice " + quoted(choice.name) +
                     ", which its shader does not ask; declare it by CHOICE and ask it, or remove it");
}

void validate_state(const Pass& pass, const InstanceState& state) {
  if (std::none_of(pass.drawn_for.begin(), pass.drawn_for.end(),
                   [&](const DrawnFor& drawn_for) { return drawn_for.label == state.label; }))
    refuse(pass, "has a state for " + quoted(state.label) +
                     ", for which it is not drawn; add that to `drawn_for` or remove the state");
}

}  // namespace

std::string_view layer_label(int layer) {
  static constexpr std::string_view kLabels[kMostLayers] = {"layer 1", "layer 2", "layer 3", "layer 4"};
  return kLabels[layer - 1];
}

std::vector<DrawnFor> with_layers(std::vector<DrawnFor> drawn_for) {
  const Each each = drawn_for.front().each;
  for (int layer = 1; layer <= kMostLayers; ++layer)
    drawn_for.push_back({.each = each,
                         .label = layer_label(layer),
                         .layer = layer,
                         .also = layer > 1 ? &Effects::blended_layers : &Effects::layered,
                         .reason = "the camera sees blended surfaces"});
  return drawn_for;
}

UniformBytes Pass::uniforms(const PassContext& context) const {
  static const Effects none;
  const Permutation permutation = permutation_of(*this, context.effects ? *context.effects : none);
  UniformBytes bytes = permutation.block.fill ? permutation.block.fill(context) : UniformBytes{};
  for (const ShaderChoice& asked : choices_of(*permutation.shader))
    for (const Choice& choice : choices)
      if (choice.name == asked.name) {
        const int value = choice.value(context);
        std::memcpy(&bytes[asked.offset], &value, sizeof value);
      }
  return bytes;
}

int throws_caustic(const PassContext& context) {
  if (!context.effects->caustics.active) return 0;
  const std::vector<Expectation>& all = context.effects->expectations;
  return std::any_of(all.begin(), all.end(), [&](const Expectation& e) {
    return e.expected && &context.scene->lights[static_cast<std::size_t>(e.light)] == context.light;
  });
}

PassDefinition definition_of(const Pass& pass, const Effects& effects, const DrawnFor& drawn_for) {
  const bool is_layer = drawn_for.layer > 0;
  const bool is_hidden = drawn_for.camera != CameraView::Picture;
  PassDefinition definition{.name = std::string(pass.name),
                            .purpose = std::string(pass.purpose),
                            .depth = pass.depth,
                            .topology = pass.topology,
                            .zero_outside_quad = pass.zero_outside_quad,
                            .depth_state = pass.depth_state,
                            .cull = pass.cull,
                            .count_samples = pass.count_samples && (is_layer || !pass.has_layers()),
                            .shader = permutation_of(pass, effects).shader};
  if (!drawn_for.label.empty()) definition.name += "." + std::string(drawn_for.label);
  for (const Read& read : pass.reads)
    if (wanted(read.only_with, effects))
      definition.reads.push_back({.name = std::string(read.name),
                                  .meaning = std::string(read.meaning),
                                  .of_material = read.of_material,
                                  .optional = read.optional || !read.only_for.empty(),
                                  .discards_where_zero = read.discards_where_zero ||
                                                         (is_layer && read.layers_discard_where_zero) ||
                                                         (is_hidden && read.hidden_discard_where_zero),
                                  .only_towards = std::string(read.only_towards)});
  for (const Write& write : pass.writes)
    if (wanted(write.only_with, effects))
      definition.writes.push_back({.name = std::string(write.name),
                                   .format = write.format_by ? write.format_by(effects) : write.format,
                                   .meaning = std::string(write.meaning),
                                   .clear = write.clear,
                                   .blend = write.blend,
                                   .mask = write.mask});
  for (const InstanceState& state : pass.states)
    if (state.label == drawn_for.label) set_state(definition, state);
  return definition;
}

void validate(const Registry& registry) {
  std::set<std::string_view> names;
  for (const Pass& pass : registry) {
    if (!names.insert(pass.name).second) refuse(pass, "is registered twice; remove one");
    for (const DrawnFor& drawn_for : pass.drawn_for) {
      validate(definition_of(pass, {}, drawn_for));
      for (const NamedEffect& named : named_effects()) {
        Effects effects;
        (effects.*named.effect).active = true;
        validate(definition_of(pass, effects, drawn_for));
      }
    }
    for (const Permutation& permutation : pass.shaders) validate_block(pass, permutation);
    for (const Choice& choice : pass.choices) validate_choice(pass, choice);
    for (const InstanceState& state : pass.states) validate_state(pass, state);
  }
}

bool is_of_camera(const Pass& pass, const DrawnFor& drawn_for) {
  return drawn_for.each != Each::Water && drawn_for.each != Each::Rays &&
         (!pass.size || is_of_casters_in_view(drawn_for));
}

TargetSize picture_size(const Settings& settings, CameraView camera) {
  if (camera == CameraView::Picture) return {settings.width, settings.height};
  return {(settings.width + 1) / 2, (settings.height + 1) / 2};
}

TargetSize coarser(TargetSize size, int times) {
  return {(size.width + times - 1) / times, (size.height + times - 1) / times};
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
  const int side =
      effects.receivers_are_one_plane ? std::min<int>(settings.map, kSideOfPlane) : int{settings.map};
  return hides ? TargetSize{2 * side, 2 * side} : TargetSize{side, side};
}

TargetSize beams_size(const Settings& settings, const Effects&, const LightEffects*) {
  return {beams_a_side(settings), beams_a_side(settings)};
}

}  // namespace caustics
