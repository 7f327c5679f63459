#include "pipeline/plan/frame_plan.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "pipeline/effects/dim_lights.hpp"
#include "pipeline/effects/expectations.hpp"
#include "pipeline/effects/surface_role.hpp"
#include "pipeline/effects/textured_casters.hpp"
#include "pipeline/gpu/interrupt.hpp"
#include "pipeline/gpu/text.hpp"
#include "pipeline/plan/called_for.hpp"
#include "pipeline/plan/needed_passes.hpp"
#include "pipeline/plan/sample_passes.hpp"
#include "pipeline/plan/texture_memory.hpp"
#include "pipeline/settings/settings.hpp"

namespace caustics {

namespace {

// Who a pass runs for, or a texture belongs to: the frame, a light, or a light's branch.
struct Owner {
  int light = -1, branch = -1;
};

// Those of some thousand lights; more would plan for minutes and draw for hours.
constexpr std::size_t kMostPasses = 1'000'000;

std::string with_label(std::string_view name, std::string_view label) {
  return label.empty() ? std::string(name) : std::string(name) + "." + std::string(label);
}

class Planner {
 public:
  Planner(const Scene& scene, const Effects& effects, const Settings& settings, const Registry& registry)
      : scene_(scene),
        effects_(effects),
        settings_(settings),
        registry_(registry),
        own_settings_(settings, effects),
        throws_(scene.lights.size()) {
    for (const Expectation& e : effects.expectations)
      if (e.expected) throws_[static_cast<std::size_t>(e.light)] = true;
    add_external(kCasterMaterials);
    for (int i = 0; i < static_cast<int>(registry.size()); ++i)
      if (pass_of(i).has_layers()) last_with_layers_ = i;
    if (scene.environment.image) add_external(kEnvironment);
    if (effects.further_surfaces.active || effects.seen_casters.active || effects.ambient_occlusion.active)
      for (const char* name : {kHierarchyNodes, kHierarchyTriangles, kHierarchyNormals}) add_external(name);
    if (light_meets_textures(effects) || sight_meets_textures(effects)) add_external(kCasterTexels);
  }

  FramePlan plan() {
    const int passes = static_cast<int>(registry_.size());
    for (int i = 0; i < passes;) {
      int end = i;
      while (end < passes && follows_branches(pass_of(end))) ++end;
      if (end > i)
        add_by_branch(i, end);
      else
        add_instances(end++);
      i = end;
    }
    return std::move(plan_);
  }

 private:
  void add_external(const char* name) { add_texture({.name = name, .external = true}); }

  int add_texture(PlannedTexture texture) {
    const int index = static_cast<int>(plan_.textures.size());
    index_.emplace(texture.name, index);
    plan_.textures.push_back(std::move(texture));
    return index;
  }
  int find(const std::string& name) const {
    const auto found = index_.find(name);
    return found == index_.end() ? -1 : found->second;
  }

  // One for all instances of a kind: thousands of lights have thousands of instances.
  const std::shared_ptr<const PassDefinition>& shared_definition(const Pass& pass,
                                                                 const DrawnFor& drawn_for) {
    std::shared_ptr<const PassDefinition>& shared = definitions_[{&pass, &drawn_for}];
    if (!shared) shared = std::make_shared<const PassDefinition>(definition_of(pass, effects_, drawn_for));
    return shared;
  }

  const Pass& pass_of(int index) const { return registry_[static_cast<std::size_t>(index)]; }
  static bool follows_branches(const Pass& pass) {
    return std::all_of(pass.drawn_for.begin(), pass.drawn_for.end(),
                       [](const DrawnFor& drawn_for) { return drawn_for.each == Each::Branch; });
  }

  // Each branch all its way before the next begins, so that they take the same memory in turn.
  void add_by_branch(int first, int end) {
    for (int i = first; i < end; ++i) say_skipped(i);
    for (int light = 0; light < static_cast<int>(scene_.lights.size()); ++light)
      for (int b = 0; b < static_cast<int>(effects_.branches.size()); ++b)
        for (int i = first; i < end; ++i) add_of_branch(i, {light, b});
  }

  void say_skipped(int index) {
    const Pass& pass = pass_of(index);
    for (const DrawnFor& drawn_for : pass.drawn_for) {
      bool any = false;
      for (int light = 0; light < static_cast<int>(scene_.lights.size()); ++light)
        any |= light_needs(pass, drawn_for, light);
      auto reason = not_called_for(pass, drawn_for, effects_);
      if (!reason && !any) reason = why_no_light(pass);
      if (reason) plan_.skipped.push_back({with_label(pass.name, drawn_for.label), *reason});
    }
  }

  void add_of_branch(int index, Owner user) {
    const Pass& pass = pass_of(index);
    for (const DrawnFor& drawn_for : pass.drawn_for) {
      if (not_called_for(pass, drawn_for, effects_) || !light_needs(pass, drawn_for, user.light)) continue;
      add(index, drawn_for, user);
    }
  }

  // The branch that leads, where this one comes to the second surface as it does; -1: itself.
  int with_same_start(int branch) const {
    const Branch& own = effects_.branches[static_cast<std::size_t>(branch)];
    for (std::size_t b = 0; own.has_same_start() && b < effects_.branches.size(); ++b) {
      const Branch& other = effects_.branches[b];
      if (other.leads() && other.bend == own.bend && other.color == own.color) return static_cast<int>(b);
    }
    return -1;
  }

  void add_instances(int index) {
    const Pass& pass = registry_[static_cast<std::size_t>(index)];
    if (index == last_with_layers_) add_layers();
    for (const DrawnFor& drawn_for : pass.drawn_for)
      if (drawn_for.layer == 0) add_instances(index, drawn_for);
  }

  // Layer by layer, so that each takes the memory of the one before.
  void add_layers() {
    for (int layer = 1; layer <= kMostLayers; ++layer)
      for (int i = 0; i <= last_with_layers_; ++i)
        for (const DrawnFor& drawn_for : pass_of(i).drawn_for)
          if (drawn_for.layer == layer) add_instances(i, drawn_for);
  }

  void add_instances(int index, const DrawnFor& drawn_for) {
    const Pass& pass = pass_of(index);
    if (drawn_for.each == Each::Rays) return;  // no frame has it
    if (const auto reason = not_called_for(pass, drawn_for, effects_)) {
      // The first layer's says enough.
      if (drawn_for.layer <= 1) plan_.skipped.push_back({with_label(pass.name, drawn_for.label), *reason});
    } else if (drawn_for.each == Each::Frame || drawn_for.each == Each::Sample) {
      add(index, drawn_for, {});
    } else if (drawn_for.each == Each::Water) {
      for (std::size_t water = 0; water < scene_.waters.size(); ++water) add_water(index, drawn_for, water);
    } else {
      add_for_lights(index, drawn_for);
    }
  }

  void add_for_lights(int index, const DrawnFor& drawn_for) {
    const Pass& pass = registry_[static_cast<std::size_t>(index)];
    bool any = false;
    for (int light = 0; light < static_cast<int>(scene_.lights.size()); ++light) {
      if (!light_needs(pass, drawn_for, light)) continue;
      any = true;
      add(index, drawn_for, {light, -1});
    }
    if (!any) plan_.skipped.push_back({with_label(pass.name, drawn_for.label), why_no_light(pass)});
  }

  bool light_needs(const Pass& pass, const DrawnFor& drawn_for, int light) const {
    const auto index = static_cast<std::size_t>(light);
    if (!throws_[index] && !effects_.lights[index].lights_nothing.empty()) return false;
    if (drawn_for.lights && !drawn_for.lights(effects_.lights[index])) return false;
    return !pass.only_lights_with_caustics || throws_[index];
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
    return is_of_camera(pass, drawn_for) ? coarser(picture_size(settings_, drawn_for.camera), pass.coarser)
           : drawn_for.size              ? drawn_for.size(own_settings_[user.light], effects_, light)
                                         : pass.size(own_settings_[user.light], effects_, light);
  }

  void add(int index, const DrawnFor& drawn_for, Owner user) {
    stop_if_interrupted();
    refuse_too_many();
    const Pass& pass = registry_[static_cast<std::size_t>(index)];
    const TargetSize size = size_of(pass, drawn_for, user);
    PlannedPass planned{
        .pass = index,
        .drawn_for = &drawn_for,
        .definition = shared_definition(pass, drawn_for),
        .light = user.light,
        .branch = user.branch,
        .label = with_label(std::string(pass.name) + label_of(user), std::string(drawn_for.label)),
        .reason = std::string(drawn_for.reason.empty() ? pass.reason : drawn_for.reason),
        .width = size.width,
        .height = size.height};
    for (const Read& read : pass.reads)
      if (!read.only_with || read.only_with(effects_))
        planned.reads.push_back(resolve(pass, read, drawn_for, user));
    const Each owned_by = pass.owner.value_or(drawn_for.each);
    const Owner owner{owned_by == Each::Frame ? -1 : user.light, owned_by == Each::Branch ? user.branch : -1};
    const std::string own(drawn_for.own_textures ? drawn_for.label : std::string_view());
    std::size_t written = 0;
    for (const Write& write : pass.writes) {
      if (write.only_with && !write.only_with(effects_)) continue;
      const Format format = planned.definition->writes[written++].format;
      const bool nobodys = !write.not_for.empty() && write.not_for == drawn_for.label;
      if (nobodys || (write.needed_if && !write.needed_if(effects_))) {
        planned.writes.push_back(PlannedPass::kNothing);
        planned.keep.push_back(false);
        continue;
      }
      const std::string_view name = write.texture_by && own.empty() ? write.texture_by(effects_) : write.name;
      planned.writes.push_back(target(planned, with_label(name, own), format, owner));
    }
    if (pass.depth)
      planned.depth = target(planned, with_label(pass.depth->name, own), Format::Depth32F, owner);
    decide_by_query(pass, planned);
    plan_.passes.push_back(std::move(planned));
  }

  void refuse_too_many() const {
    if (plan_.passes.size() < kMostPasses) return;
    throw Error(
        ExitCode::WrongUsage,
        "the frame would be more than " + grouped(kMostPasses) + " passes, of " +
            grouped(scene_.lights.size()) + " lights and samples of lights on " +
            grouped(effects_.branches.size()) +
            " ways each; lower --wavelengths, -D splits or -D light.samples, or raise -D light.least");
  }

  // The pass that counts how much of its casters a light reaches comes before those that follow that light;
  // of light that is followed from surface to surface, the one that counts how much goes a branch's way.
  void decide_by_query(const Pass& pass, PlannedPass& planned) {
    if (planned.drawn_for->layer > 0 || planned.drawn_for->camera != CameraView::Picture)
      decide_by_what_is_there(planned);
    if (planned.light < 0 || !pass.only_lights_with_caustics) return;
    planned.only_if = query_before(planned);
    if (!pass.count_samples) return;
    planned.counts_into = ++queries_;
    if (planned.branch >= 0) {
      branch_queries_.try_emplace({planned.light, planned.branch}, queries_);
    } else {
      light_queries_.try_emplace(planned.light, queries_);
    }
  }

  // Where nothing was drawn into a layer, neither is there light on it, nor another behind it; likewise where
  // glass shows nothing but what the picture shows.
  void decide_by_what_is_there(PlannedPass& planned) {
    for (std::size_t r = 0; r < planned.reads.size(); ++r)
      if (const auto found = counted_in_.find(planned.reads[r]);
          found != counted_in_.end() && planned.definition->reads[r].discards_where_zero)
        planned.only_if = found->second;
    if (!planned.definition->count_samples) return;
    planned.counts_into = ++queries_;
    for (const int texture : planned.writes)
      if (texture >= 0) counted_in_.try_emplace(texture, queries_);
  }

  int query_before(const PlannedPass& planned) const {
    const auto found_in = [](const auto& map, const auto& key) {
      const auto found = map.find(key);
      return found == map.end() ? 0 : found->second;
    };
    const int of_branch = found_in(branch_queries_, std::pair(planned.light, planned.branch));
    return of_branch > 0 ? of_branch : found_in(light_queries_, planned.light);
  }

  // The steps of a water, and the last of them once more as a pass of the plan.
  void add_water(int index, const DrawnFor& drawn_for, std::size_t number) {
    const Water& water = scene_.waters[number];
    const Pass& pass = registry_[static_cast<std::size_t>(index)];
    const std::string reason(pass.reason);
    PlannedPass planned{.pass = index,
                        .drawn_for = &drawn_for,
                        .definition = shared_definition(pass, drawn_for),
                        .water = static_cast<int>(number),
                        .label = std::string(pass.name) + "[" +
                                 (water.name.empty() ? std::to_string(number) : water.name) + "]",
                        .reason = reason,
                        .width = water.columns,
                        .height = water.rows};
    for (const TextureRead& read : planned.definition->reads) {
      planned.reads.push_back(add_texture({.name = water_texture(read.name, number), .external = true}));
    }
    for (const ColorWrite& write : planned.definition->writes) {
      plan_.before.push_back({planned.label,
                              reason + ": a step every " + rounded_text(1e3 * water.step) + " ms",
                              {water_texture(write.name, number), write.format, water.columns, water.rows}});
      planned.writes.push_back(add_texture(plan_.before.back().writes));
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
    if (read.of_picture && drawn_for.camera != CameraView::Picture) return PlannedPass::kNothing;
    const std::string name(read.texture_by         ? read.texture_by(effects_, drawn_for)
                           : !read.texture.empty() ? read.texture
                                                   : read.name);
    if (read.layer != OfLayer::None) return of_layer(name, read.layer, drawn_for);
    if (read.of_same_start) return of_same_start(name, user);
    // A branch's own comes before what the first branch, which bears the light's name, has under the label.
    // Of thousands of lights each name is looked for once.
    const bool is_branch = user.branch >= 0 && !branch_of(user).name.empty();
    for (const Owner owner : std::to_array({user, Owner{user.light, -1}, Owner{}})) {
      if (owner.branch >= 0 && !is_branch) continue;
      for (const bool labelled : {true, false}) {
        if (labelled && drawn_for.label.empty()) continue;
        const int found = find(full_name(labelled ? with_label(name, drawn_for.label) : name, owner));
        if (found < 0) continue;
        return called_for(read.needed_with) ? found : leave_unread(found, effects_.*read.needed_with);
      }
    }
    if (read.optional) return PlannedPass::kNothing;
    fail_unwritten(pass, name);
  }

  int of_layer(const std::string& name, OfLayer which, const DrawnFor& drawn_for) const {
    if (drawn_for.camera != CameraView::Picture) return PlannedPass::kNothing;
    if (which == OfLayer::Behind) {
      const int found = drawn_for.layer > 0 ? find(name) : -1;
      return found >= 0 ? found : PlannedPass::kNothing;
    }
    int layer = which == OfLayer::First ? 1 : drawn_for.layer > 0 ? drawn_for.layer - 1 : kMostLayers;
    for (; layer > 0; --layer)
      if (const int found = find(with_label(name, layer_label(layer))); found >= 0) return found;
    return PlannedPass::kNothing;
  }

  int of_same_start(const std::string& name, Owner user) const {
    const int branch = with_same_start(user.branch);
    const int found = branch < 0 ? -1 : find(full_name(name, {user.light, branch}));
    return found >= 0 ? found : PlannedPass::kNothing;
  }

  [[noreturn]] static void fail_unwritten(const Pass& pass, const std::string& name) {
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
    const int found = find(full);
    planned.keep.push_back(found >= 0);
    if (found < 0)
      return add_texture({.name = full,
                          .format = format,
                          .width = planned.width,
                          .height = planned.height,
                          .light = owner.light});
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
  std::map<std::pair<const Pass*, const DrawnFor*>, std::shared_ptr<const PassDefinition>> definitions_;
  const LightSettings own_settings_;
  std::vector<bool> throws_;                    // by light: a caustic
  int last_with_layers_ = -1;                   // in the registry
  std::unordered_map<std::string, int> index_;  // of the plan's textures, by name
  // Queries that earlier passes count into: of a light's casters, of a branch's first rays, of the rays that
  // a texture holds.
  int queries_ = 0;
  std::map<int, int> light_queries_, counted_in_;
  std::map<std::pair<int, int>, int> branch_queries_;
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
  plan = in_least_memory(with_samples(std::move(plan), registry, samples_a_pixel(settings), goal));
  for (std::size_t i = 0; i < plan.textures.size(); ++i)
    plan.by_name.emplace(plan.textures[i].name, static_cast<int>(i));
  return plan;
}

}  // namespace caustics
