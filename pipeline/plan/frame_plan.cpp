#include "pipeline/plan/frame_plan.hpp"

#include <algorithm>
#include <set>

#include "pipeline/gpu/error.hpp"
#include "pipeline/effects/surface_role.hpp"

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

struct Size {
  int width = 0, height = 0;
};

Size size_of(Extent extent, const Settings& settings) {
  switch (extent) {
    case Extent::Picture:
      return {settings.width, settings.height};
    case Extent::Wide:
      return {(settings.width + 1) / 2, (settings.height + 1) / 2};
    case Extent::Grid:
      return {settings.grid, settings.grid};
    case Extent::Map:
    case Extent::Receiver:
      return {settings.map, settings.map};
    case Extent::Shadow:
      return {settings.shadow, settings.shadow};
    case Extent::Water:
      break;  // each water's own
    case Extent::Beams:
      return {beams_a_side(settings), beams_a_side(settings)};
  }
  return {};
}

class Planner {
 public:
  Planner(const Scene& scene, const Effects& effects, const Settings& settings,
          const Registry& registry)
      : scene_(scene), effects_(effects), settings_(settings), registry_(registry) {
    add_external(kCasterMaterials);
    if (scene.environment.image) add_external(kEnvironment);
  }

  FramePlan plan() {
    for (std::size_t i = 0; i < registry_.size(); ++i) add_instances(static_cast<int>(i));
    return std::move(plan_);
  }

 private:
  void add_external(const char* name) {
    plan_.textures.push_back({.name = name, .external = true});
  }

  void add_instances(int index) {
    const Pass& pass = registry_[static_cast<std::size_t>(index)];
    const std::optional<std::string> reason = pass.called_for_by(effects_);
    if (!reason) {
      plan_.skipped.push_back({pass.definition.name, "no effect calls for it"});
      return;
    }
    if (pass.each == Each::Frame) {
      add(index, {}, *reason);
      return;
    }
    if (pass.each == Each::Water) {
      for (std::size_t water = 0; water < scene_.waters.size(); ++water) add_water(index, water, *reason);
      return;
    }
    bool any = false;
    for (int light = 0; light < static_cast<int>(scene_.lights.size()); ++light) {
      if (!light_needs(pass, light)) continue;
      any = true;
      if (pass.each == Each::Light) add(index, {light, -1}, *reason);
      for (int b = 0; pass.each == Each::Branch && b < static_cast<int>(effects_.branches.size()); ++b)
        add(index, {light, b}, *reason);
    }
    if (!any) plan_.skipped.push_back({pass.definition.name, "no light calls for it"});
  }

  // A light's caustic passes run only where one of its caustics is to be expected.
  bool light_needs(const Pass& pass, int light) const {
    if (!(scene_.lights[static_cast<std::size_t>(light)].intensity > 0.0f)) return false;
    if (pass.light_needs && !pass.light_needs(effects_, light)) return false;
    const bool of_casters = pass.extent == Extent::Grid || pass.extent == Extent::Map || pass.extent == Extent::Receiver ||
                            pass.extent == Extent::Beams || pass.draws == DrawSet::Beams;
    if (!of_casters) return true;
    return std::any_of(effects_.expectations.begin(), effects_.expectations.end(),
                       [&](const Expectation& e) { return e.light == light && e.expected; });
  }

  void add(int index, Owner user, const std::string& reason) {
    const Pass& pass = registry_[static_cast<std::size_t>(index)];
    const PassDefinition& definition = pass.definition;
    Size size = size_of(pass.extent, settings_);
    if (pass.extent == Extent::Receiver && hides_receivers(user.light)) size = {2 * size.width, 2 * size.height};
    PlannedPass planned{.pass = index,
                        .light = user.light,
                        .branch = user.branch,
                        .label = definition.name,
                        .reason = reason,
                        .width = size.width,
                        .height = size.height};
    planned.label += label_of(user);
    for (const TextureRead& read : definition.reads)
      planned.reads.push_back(resolve(definition, read, user));
    const Owner owner{pass.owner == Each::Frame ? -1 : user.light,
                      pass.owner == Each::Branch ? user.branch : -1};
    for (const ColorWrite& write : definition.writes)
      planned.writes.push_back(target(planned, write.name, write.format, owner));
    if (definition.depth)
      planned.depth = target(planned, definition.depth->name, Format::Depth32F, owner);
    plan_.passes.push_back(std::move(planned));
  }

  // The steps of a water, and the last of them once more as a pass of the plan.
  void add_water(int index, std::size_t number, const std::string& reason) {
    const Water& water = scene_.waters[number];
    const PassDefinition& definition = registry_[static_cast<std::size_t>(index)].definition;
    PlannedPass planned{.pass = index,
                        .water = static_cast<int>(number),
                        .label = definition.name + "[" + (water.name.empty() ? std::to_string(number) : water.name) + "]",
                        .reason = reason,
                        .width = water.columns,
                        .height = water.rows};
    for (const TextureRead& read : definition.reads) {
      plan_.textures.push_back({.name = water_texture(read.name, number), .external = true});
      planned.reads.push_back(static_cast<int>(plan_.textures.size()) - 1);
    }
    for (const ColorWrite& write : definition.writes) {
      plan_.before.push_back({planned.label,
                              reason + ": a step every " + number_text(1e3 * water.step) + " ms",
                              {water_texture(write.name, number), write.format, water.columns, water.rows}});
      plan_.textures.push_back(plan_.before.back().writes);
      planned.writes.push_back(static_cast<int>(plan_.textures.size()) - 1);
      planned.keep.push_back(false);
    }
    plan_.passes.push_back(std::move(planned));
  }

  bool hides_receivers(int light) const {
    return effects_.hidden_receivers.active && effects_.lights[static_cast<std::size_t>(light)].all_around.empty();
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

  // What is read is the branch's own, or else the light's, or else the frame's.
  int resolve(const PassDefinition& definition, const TextureRead& read, Owner user) const {
    if (read.of_material) return PlannedPass::kMaterial;
    int found = plan_.find(full_name(read.name, user));
    if (found < 0) found = plan_.find(full_name(read.name, {user.light, -1}));
    if (found < 0) found = plan_.find(read.name);
    if (found >= 0) return found;
    if (read.optional) return PlannedPass::kNothing;
    throw Error(ExitCode::InternalError, "pass '" + definition.name + "' reads '" + read.name +
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
    if (texture.width != planned.width || texture.height != planned.height ||
        texture.format != format)
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
  return std::any_of(goal.begin(), goal.end(), [&](const std::string& wanted) {
    return wanted == full_name || wanted == bare;
  });
}

// Walks backwards: a pass stays when something needed is written by it; what it reads, and the
// contents that it keeps, are needed from then on.
std::vector<bool> needed_passes(const FramePlan& plan, const PlanGoal& goal) {
  std::set<int> needed;
  for (std::size_t i = 0; i < plan.textures.size(); ++i)
    if (is_wanted(plan.textures[i].name, goal.textures)) needed.insert(static_cast<int>(i));
  std::vector<bool> stays(plan.passes.size(), false);
  for (std::size_t i = plan.passes.size(); i-- > 0;) {
    const PlannedPass& pass = plan.passes[i];
    std::vector<int> attachments = pass.writes;
    if (pass.depth >= 0) attachments.push_back(pass.depth);
    stays[i] = std::any_of(attachments.begin(), attachments.end(),
                           [&](int texture) { return needed.count(texture) > 0; });
    if (!stays[i]) continue;
    for (std::size_t a = 0; a < attachments.size(); ++a)
      pass.keep[a] ? (void)needed.insert(attachments[a]) : (void)needed.erase(attachments[a]);
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
