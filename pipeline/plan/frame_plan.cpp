#include "pipeline/plan/frame_plan.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include "pipeline/effects/expectations.hpp"
#include "pipeline/effects/surface_role.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/plan/light_order.hpp"
#include "pipeline/plan/needed_passes.hpp"
#include "pipeline/plan/texture_memory.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

std::vector<int> PlannedPass::attachments() const {
  std::vector<int> result;
  for (const int texture : writes)
    if (texture != kNothing) result.push_back(texture);
  if (depth >= 0) result.push_back(depth);
  return result;
}

int FramePlan::find(std::string_view name) const {
  for (std::size_t i = 0; i < textures.size(); ++i)
    if (textures[i].name == name) return static_cast<int>(i);
  return -1;
}

std::size_t FramePlan::bytes() const {
  std::size_t sum = 0;
  for (const TextureMemory& each : memory)
    sum += bytes_per_texel(each.format) * static_cast<std::size_t>(each.width) *
           static_cast<std::size_t>(each.height);
  return sum;
}

std::string light_texture(std::string_view name, int light) {
  return std::string(name) + "[" + std::to_string(light) + "]";
}

std::string branch_texture(std::string_view name, int light, const Branch& branch) {
  if (branch.name.empty()) return light_texture(name, light);
  return std::string(name) + "[" + std::to_string(light) + " " + branch.name + "]";
}

std::string water_texture(std::string_view name, std::size_t water) {
  return std::string(name) + "[water " + std::to_string(water) + "]";
}

namespace {

// Who a pass runs for, or a texture belongs to: the frame, a light, or a light's branch.
struct Owner {
  int light = -1, branch = -1;
};

// "cells: landings are splatted one by one", or nothing where the effect is active.
std::optional<std::string> missing(Effect Effects::*wanted, const Effects& effects) {
  if (!wanted || (effects.*wanted).active) return {};
  for (const NamedEffect& named : named_effects())
    if (named.effect == wanted) return std::string(named.name) + ": " + (effects.*wanted).reason;
  return (effects.*wanted).reason;
}

// Why the effects do not call for an instance of a pass, or nothing.
std::optional<std::string> not_called_for(const Pass& pass, const DrawnFor& drawn_for,
                                          const Effects& effects) {
  for (Effect Effects::*wanted : pass.when)
    if (auto reason = missing(wanted, effects)) return reason;
  return missing(drawn_for.also, effects);
}

std::string with_label(std::string_view name, std::string_view label) {
  return label.empty() ? std::string(name) : std::string(name) + "." + std::string(label);
}

class Planner {
 public:
  Planner(const Scene& scene, const Effects& effects, const Settings& settings, const Registry& registry)
      : scene_(scene), effects_(effects), settings_(settings), registry_(registry) {
    add_external(kCasterMaterials);
    if (scene.environment.image) add_external(kEnvironment);
  }

  FramePlan plan() {
    for (std::size_t i = 0; i < registry_.size(); ++i) add_instances(static_cast<int>(i));
    return std::move(plan_);
  }

 private:
  void add_external(const char* name) { plan_.textures.push_back({.name = name, .external = true}); }

  void add_instances(int index) {
    const Pass& pass = registry_[static_cast<std::size_t>(index)];
    for (const DrawnFor& drawn_for : pass.drawn_for) {
      if (const auto reason = not_called_for(pass, drawn_for, effects_)) {
        plan_.skipped.push_back({with_label(pass.name, drawn_for.label), *reason});
      } else if (drawn_for.each == Each::Frame) {
        add(index, drawn_for, {});
      } else if (drawn_for.each == Each::Water) {
        for (std::size_t water = 0; water < scene_.waters.size(); ++water) add_water(index, drawn_for, water);
      } else {
        add_for_lights(index, drawn_for);
      }
    }
  }

  void add_for_lights(int index, const DrawnFor& drawn_for) {
    const Pass& pass = registry_[static_cast<std::size_t>(index)];
    bool any = false;
    for (int light = 0; light < static_cast<int>(scene_.lights.size()); ++light) {
      if (!light_needs(pass, drawn_for, light)) continue;
      any = true;
      if (drawn_for.each == Each::Light) add(index, drawn_for, {light, -1});
      for (int b = 0; drawn_for.each == Each::Branch && b < static_cast<int>(effects_.branches.size()); ++b)
        add(index, drawn_for, {light, b});
    }
    if (!any) plan_.skipped.push_back({with_label(pass.name, drawn_for.label), why_no_light(pass)});
  }

  bool light_needs(const Pass& pass, const DrawnFor& drawn_for, int light) const {
    if (!has_effect(effects_, light)) return false;
    if (drawn_for.lights && !drawn_for.lights(effects_.lights[static_cast<std::size_t>(light)])) return false;
    return !pass.only_lights_with_caustics || throws_caustic(effects_, light);
  }

  // The first light's reason.
  std::string why_no_light(const Pass& pass) const {
    if (scene_.lights.empty()) return "light: no light shines";
    if (!has_effect(effects_, 0)) return std::string("light: ").append(effects_.lights[0].lights_nothing);
    if (pass.only_lights_with_caustics && !throws_caustic(effects_, 0))
      for (const Expectation& e : effects_.expectations)
        if (e.light == 0) return std::string("caustics: ").append(e.reason);
    return "no light calls for it";
  }

  TargetSize size_of(const Pass& pass, const DrawnFor& drawn_for, Owner user) const {
    const LightEffects* light =
        user.light < 0 ? nullptr : &effects_.lights[static_cast<std::size_t>(user.light)];
    // What the camera sees of the lights' passes has the picture's size.
    if (pass.size && drawn_for.label != kCamera.label) return pass.size(settings_, effects_, light);
    if (drawn_for.camera == CameraView::Picture) return {settings_.width, settings_.height};
    return {(settings_.width + 1) / 2, (settings_.height + 1) / 2};
  }

  void add(int index, const DrawnFor& drawn_for, Owner user) {
    const Pass& pass = registry_[static_cast<std::size_t>(index)];
    const TargetSize size = size_of(pass, drawn_for, user);
    PlannedPass planned{.pass = index,
                        .drawn_for = &drawn_for,
                        .definition = definition_of(pass, effects_, drawn_for),
                        .light = user.light,
                        .branch = user.branch,
                        .label = with_label(std::string(pass.name) + label_of(user), drawn_for.label),
                        .reason = std::string(drawn_for.reason.empty() ? pass.reason : drawn_for.reason),
                        .width = size.width,
                        .height = size.height};
    decide_by_query(pass, planned);
    for (const Read& read : pass.reads)
      if (!read.only_with || read.only_with(effects_))
        planned.reads.push_back(resolve(pass, read, drawn_for, user));
    const Each owned_by = pass.owner.value_or(drawn_for.each);
    const Owner owner{owned_by == Each::Frame ? -1 : user.light, owned_by == Each::Branch ? user.branch : -1};
    const std::string_view own = drawn_for.own_textures ? drawn_for.label : std::string_view{};
    std::size_t written = 0;
    for (const Write& write : pass.writes) {
      if (write.only_with && !write.only_with(effects_)) continue;
      const Format format = planned.definition.writes[written++].format;
      if (!called_for(write.needed_with)) {
        planned.writes.push_back(PlannedPass::kNothing);
        planned.keep.push_back(false);
        continue;
      }
      const std::string_view name = write.texture_by ? write.texture_by(effects_) : write.name;
      planned.writes.push_back(target(planned, with_label(name, own), format, owner));
    }
    if (pass.depth)
      planned.depth = target(planned, with_label(pass.depth->name, own), Format::Depth32F, owner);
    plan_.passes.push_back(std::move(planned));
  }

  // The pass that counts how much of its casters a light reaches comes before those that follow that light.
  void decide_by_query(const Pass& pass, PlannedPass& planned) {
    if (planned.light < 0 || !pass.only_lights_with_caustics) return;
    planned.if_casters_lit = counted_.count(planned.light) > 0;
    planned.counts_samples = pass.count_samples;
    if (planned.counts_samples) counted_.insert(planned.light);
  }

  // The steps of a water, and the last of them once more as a pass of the plan.
  void add_water(int index, const DrawnFor& drawn_for, std::size_t number) {
    const Water& water = scene_.waters[number];
    const Pass& pass = registry_[static_cast<std::size_t>(index)];
    const std::string reason(pass.reason);
    PlannedPass planned{.pass = index,
                        .drawn_for = &drawn_for,
                        .definition = definition_of(pass, effects_, drawn_for),
                        .water = static_cast<int>(number),
                        .label = std::string(pass.name) + "[" +
                                 (water.name.empty() ? std::to_string(number) : water.name) + "]",
                        .reason = reason,
                        .width = water.columns,
                        .height = water.rows};
    for (const TextureRead& read : planned.definition.reads) {
      plan_.textures.push_back({.name = water_texture(read.name, number), .external = true});
      planned.reads.push_back(static_cast<int>(plan_.textures.size()) - 1);
    }
    for (const ColorWrite& write : planned.definition.writes) {
      plan_.before.push_back({planned.label,
                              reason + ": a step every " + rounded_text(1e3 * water.step) + " ms",
                              {water_texture(write.name, number), write.format, water.columns, water.rows}});
      plan_.textures.push_back(plan_.before.back().writes);
      planned.writes.push_back(static_cast<int>(plan_.textures.size()) - 1);
      planned.keep.push_back(false);
    }
    plan_.passes.push_back(std::move(planned));
  }

  // "[sun]", "[sun 656nm]", or nothing for the frame.
  std::string label_of(Owner user) const {
    if (user.light < 0) return {};
    const std::string& name = scene_.lights[static_cast<std::size_t>(user.light)].name;
    std::string label = name.empty() ? std::to_string(user.light) : name;
    if (user.branch >= 0 && !branch_of(user).name.empty()) label += " " + branch_of(user).name;
    return "[" + label + "]";
  }

  const Branch& branch_of(Owner user) const {
    return effects_.branches[static_cast<std::size_t>(user.branch)];
  }

  std::string full_name(const std::string& name, Owner owner) const {
    if (owner.branch >= 0) return branch_texture(name, owner.light, branch_of(owner));
    return owner.light >= 0 ? light_texture(name, owner.light) : name;
  }

  // What is read is the instance's own, or else the plain one; the branch's, or else the light's, or else the
  // frame's.
  int resolve(const Pass& pass, const Read& read, const DrawnFor& drawn_for, Owner user) {
    if (read.of_material) return PlannedPass::kMaterial;
    if (!read.only_for.empty() && read.only_for != drawn_for.label) return PlannedPass::kNothing;
    const std::string name(read.texture.empty() ? read.name : read.texture);
    for (const std::string& wanted : {with_label(name, drawn_for.label), name})
      for (const Owner owner : {user, Owner{user.light, -1}, Owner{}})
        if (const int found = plan_.find(full_name(wanted, owner)); found >= 0)
          return called_for(read.needed_with) ? found : leave_unread(found, effects_.*read.needed_with);
    if (read.optional) return PlannedPass::kNothing;
    throw Error(ExitCode::InternalError, "pass '" + std::string(pass.name) + "' reads '" + name +
                                             "', which no pass before it writes; register a "
                                             "writer first, name the effect that its writer waits for in "
                                             "'when', or mark the read optional");
  }

  bool called_for(Effect Effects::*effect) const { return !effect || (effects_.*effect).active; }

  int leave_unread(int texture, const Effect& effect) {
    plan_.textures[static_cast<std::size_t>(texture)].unread = effect.reason;
    return PlannedPass::kNothing;
  }

  // The texture that an attachment is drawn into. What an earlier pass wrote is kept, not cleared.
  int target(PlannedPass& planned, const std::string& name, Format format, Owner owner) {
    const std::string full = full_name(name, owner);
    const int found = plan_.find(full);
    planned.keep.push_back(found >= 0);
    if (found < 0) {
      plan_.textures.push_back({.name = full,
                                .format = format,
                                .width = planned.width,
                                .height = planned.height,
                                .light = owner.light});
      return static_cast<int>(plan_.textures.size()) - 1;
    }
    const PlannedTexture& texture = plan_.textures[static_cast<std::size_t>(found)];
    if (texture.width != planned.width || texture.height != planned.height || texture.format != format)
      throw Error(ExitCode::InternalError, "pass '" + planned.label + "' writes '" + full +
                                               "' in another size or format than the pass before");
    return found;
  }

  const Scene& scene_;
  const Effects& effects_;
  const Settings& settings_;
  const Registry& registry_;
  FramePlan plan_;
  std::set<int> counted_;  // lights whose casters' samples an earlier pass counts
};

}  // namespace

FramePlan make_plan(const Scene& scene, const Effects& effects, const Settings& settings,
                    const Registry& registry, const PlanGoal& goal) {
  FramePlan plan = Planner(scene, effects, settings, registry).plan();
  if (!goal.textures.empty()) plan = needed_for(goal, std::move(plan));
  for (PlannedTexture& texture : plan.textures) {
    texture.kept_for_light = goal.light_by_light && texture.light >= 0 && texture.kept;
    texture.kept = texture.kept && !texture.kept_for_light;
  }
  order_by_light(plan);
  share_memory(plan);
  return plan;
}

}  // namespace caustics
