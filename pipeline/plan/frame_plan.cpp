#include "pipeline/plan/frame_plan.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include "pipeline/effects/surface_role.hpp"
#include "pipeline/gpu/error.hpp"

namespace caustics {

int FramePlan::find(std::string_view name) const {
  for (std::size_t i = 0; i < textures.size(); ++i)
    if (textures[i].name == name) return static_cast<int>(i);
  return -1;
}

std::size_t FramePlan::bytes() const {
  std::size_t sum = 0;
  for (const PlannedTexture& texture : textures)
    if (!texture.external)
      sum += bytes_per_texel(texture.format) * static_cast<std::size_t>(texture.width) *
             static_cast<std::size_t>(texture.height);
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
    if (!any)
      plan_.skipped.push_back({with_label(pass.name, drawn_for.label),
                               scene_.lights.empty() ? "light: no light shines" : "no light calls for it"});
  }

  bool light_needs(const Pass& pass, const DrawnFor& drawn_for, int light) const {
    if (!(scene_.lights[static_cast<std::size_t>(light)].intensity > 0.0f)) return false;
    if (drawn_for.lights && !drawn_for.lights(effects_.lights[static_cast<std::size_t>(light)])) return false;
    if (!pass.only_lights_with_caustics) return true;
    return std::any_of(effects_.expectations.begin(), effects_.expectations.end(),
                       [&](const Expectation& e) { return e.light == light && e.expected; });
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
    for (const Read& read : pass.reads)
      if (!read.only_with || read.only_with(effects_))
        planned.reads.push_back(resolve(pass, read, drawn_for, user));
    const Each owned_by = pass.owner.value_or(drawn_for.each);
    const Owner owner{owned_by == Each::Frame ? -1 : user.light, owned_by == Each::Branch ? user.branch : -1};
    const std::string_view own = drawn_for.own_textures ? drawn_for.label : std::string_view{};
    std::size_t written = 0;
    for (const Write& write : pass.writes) {
      if (write.only_with && !write.only_with(effects_)) continue;
      const std::string_view name = write.texture_by ? write.texture_by(effects_) : write.name;
      planned.writes.push_back(
          target(planned, with_label(name, own), planned.definition.writes[written++].format, owner));
    }
    if (pass.depth)
      planned.depth = target(planned, with_label(pass.depth->name, own), Format::Depth32F, owner);
    plan_.passes.push_back(std::move(planned));
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
                              reason + ": a step every " + number_text(1e3 * water.step) + " ms",
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
  int resolve(const Pass& pass, const Read& read, const DrawnFor& drawn_for, Owner user) const {
    if (read.of_material) return PlannedPass::kMaterial;
    if (!read.only_for.empty() && read.only_for != drawn_for.label) return PlannedPass::kNothing;
    const std::string name(read.texture.empty() ? read.name : read.texture);
    for (const std::string& wanted : {with_label(name, drawn_for.label), name})
      for (const Owner owner : {user, Owner{user.light, -1}, Owner{}})
        if (const int found = plan_.find(full_name(wanted, owner)); found >= 0) return found;
    if (read.optional) return PlannedPass::kNothing;
    throw Error(ExitCode::InternalError, "pass '" + std::string(pass.name) + "' reads '" + name +
                                             "', which no pass before it writes; register a "
                                             "writer first or mark the read optional");
  }

  // The texture that an attachment is drawn into. What an earlier pass wrote is kept, not cleared.
  int target(PlannedPass& planned, const std::string& name, Format format, Owner owner) {
    const std::string full = full_name(name, owner);
    const int found = plan_.find(full);
    planned.keep.push_back(found >= 0);
    if (found < 0) {
      plan_.textures.push_back(
          {.name = full, .format = format, .width = planned.width, .height = planned.height});
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
};

// "name" is meant by a goal for the frame's texture and for each light's own.
bool is_wanted(const std::string& full_name, const std::vector<std::string>& goal) {
  const std::string bare = full_name.substr(0, full_name.find('['));
  return std::any_of(goal.begin(), goal.end(),
                     [&](const std::string& wanted) { return wanted == full_name || wanted == bare; });
}

// Is the attachment that the read is for among those needed?
bool is_towards_needed(const PlannedPass& pass, const TextureRead& read, const std::set<int>& needed) {
  if (read.only_towards.empty()) return true;
  for (std::size_t i = 0; i < pass.writes.size(); ++i)
    if (pass.definition.writes[i].name == read.only_towards) return needed.count(pass.writes[i]) > 0;
  return true;
}

// Walks backwards: a pass stays when something needed is written by it; what it reads towards that, and the
// contents that it keeps, are needed from then on. Other reads of it become nothing.
std::vector<bool> needed_passes(FramePlan& plan, const PlanGoal& goal) {
  std::set<int> needed;
  for (std::size_t i = 0; i < plan.textures.size(); ++i)
    if (is_wanted(plan.textures[i].name, goal.textures)) needed.insert(static_cast<int>(i));
  std::vector<bool> stays(plan.passes.size(), false);
  for (std::size_t i = plan.passes.size(); i-- > 0;) {
    PlannedPass& pass = plan.passes[i];
    std::vector<int> attachments = pass.writes;
    if (pass.depth >= 0) attachments.push_back(pass.depth);
    stays[i] = std::any_of(attachments.begin(), attachments.end(),
                           [&](int texture) { return needed.count(texture) > 0; });
    if (!stays[i]) continue;
    for (std::size_t r = 0; r < pass.reads.size(); ++r)
      if (!is_towards_needed(pass, pass.definition.reads[r], needed)) pass.reads[r] = PlannedPass::kNothing;
    for (std::size_t a = 0; a < pass.writes.size(); ++a)
      if (!pass.keep[a]) needed.erase(pass.writes[a]);
    // What the depth test meets decides what is drawn into the others.
    if (pass.depth >= 0) pass.keep.back() ? (void)needed.insert(pass.depth) : (void)needed.erase(pass.depth);
    for (const int texture : pass.reads)
      if (texture >= 0) needed.insert(texture);
  }
  return stays;
}

// Drops the passes that no goal needs, and the textures that nobody uses any more.
FramePlan pruned(FramePlan plan, const PlanGoal& goal) {
  const std::vector<bool> stays = needed_passes(plan, goal);
  FramePlan result;
  result.skipped = std::move(plan.skipped);
  result.before = std::move(plan.before);
  std::vector<int> renumbered(plan.textures.size(), -1);
  const auto keep_texture = [&](int& texture) {
    if (texture < 0) return;
    int& number = renumbered[static_cast<std::size_t>(texture)];
    if (number < 0) {
      number = static_cast<int>(result.textures.size());
      result.textures.push_back(plan.textures[static_cast<std::size_t>(texture)]);
    }
    texture = number;
  };
  for (std::size_t i = 0; i < plan.passes.size(); ++i) {
    PlannedPass& pass = plan.passes[i];
    if (!stays[i]) {
      if (pass.water < 0) result.skipped.push_back({pass.label, "no wanted image depends on it"});
      continue;
    }
    for (int& texture : pass.reads) keep_texture(texture);
    for (int& texture : pass.writes) keep_texture(texture);
    keep_texture(pass.depth);
    result.passes.push_back(std::move(pass));
  }
  return result;
}

}  // namespace

FramePlan make_plan(const Scene& scene, const Effects& effects, const Settings& settings,
                    const Registry& registry, const PlanGoal& goal) {
  FramePlan plan = Planner(scene, effects, settings, registry).plan();
  return goal.textures.empty() ? plan : pruned(std::move(plan), goal);
}

}  // namespace caustics
