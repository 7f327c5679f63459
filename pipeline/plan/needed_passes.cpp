#include "pipeline/plan/needed_passes.hpp"

#include <algorithm>

namespace caustics {

namespace {

bool is_named(const std::string& full_name, const std::vector<std::string>& names) {
  const std::string bare = full_name.substr(0, full_name.find('['));
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name) { return name == full_name || name == bare; });
}

// Is the attachment that the read is for among those needed?
bool is_towards_needed(const PlannedPass& pass, const TextureRead& read, const std::vector<bool>& needed) {
  if (read.only_towards.empty()) return true;
  for (std::size_t i = 0; i < pass.writes.size(); ++i)
    if (pass.definition->writes[i].name == read.only_towards)
      return pass.writes[i] >= 0 && needed[static_cast<std::size_t>(pass.writes[i])];
  return true;
}

// Walks backwards: a pass stays when something needed is written by it; what it reads towards that, and the
// contents that it keeps, are needed from then on. Its other reads and attachments become nothing.
class BackwardWalk {
 public:
  BackwardWalk(FramePlan& plan, const PlanGoal& goal) : plan_(plan) {
    for (PlannedTexture& texture : plan.textures) {
      needed_.push_back(is_named(texture.name, goal.textures));
      beside_.push_back(is_named(texture.name, goal.beside));
      texture.kept = needed_.back() || beside_.back();
    }
  }

  // By pass: why it does not stay; empty where it stays.
  std::vector<std::string> walk() {
    std::vector<std::string> reasons(plan_.passes.size());
    for (std::size_t i = plan_.passes.size(); i-- > 0;)
      if (!visit(plan_.passes[i])) reasons[i] = why_not(plan_.passes[i]);
    return reasons;
  }

 private:
  bool is_needed(int texture) const { return texture >= 0 && needed_[static_cast<std::size_t>(texture)]; }
  void set_needed(int texture, bool needed) {
    if (texture >= 0) needed_[static_cast<std::size_t>(texture)] = needed;
  }

  bool visit(PlannedPass& pass) {
    if (!is_needed(pass.depth) &&
        std::none_of(pass.writes.begin(), pass.writes.end(), [&](int texture) { return is_needed(texture); }))
      return false;
    for (std::size_t r = 0; r < pass.reads.size(); ++r)
      if (!is_towards_needed(pass, pass.definition->reads[r], needed_)) pass.reads[r] = PlannedPass::kNothing;
    for (std::size_t a = 0; a < pass.writes.size(); ++a) write(pass.writes[a], pass.keep[a]);
    // What the depth test meets decides what is drawn into the others.
    if (pass.depth >= 0) set_needed(pass.depth, pass.keep.back());
    for (const int texture : pass.reads) set_needed(texture, true);
    return true;
  }

  PlannedTexture& texture_of(int index) { return plan_.textures[static_cast<std::size_t>(index)]; }

  // The effect that keeps the readers from what the pass writes; what the pass reads is unread by it too.
  std::string why_not(const PlannedPass& pass) {
    std::string reason;
    for (const int texture : pass.attachments())
      if (texture >= 0 && reason.empty()) reason = texture_of(texture).unread;
    if (reason.empty()) return "no wanted image depends on it";
    for (const int texture : pass.reads)
      if (texture >= 0 && texture_of(texture).unread.empty()) texture_of(texture).unread = reason;
    return reason;
  }

  void write(int& texture, bool keeps) {
    if (texture < 0) return;
    if (is_needed(texture) || beside_[static_cast<std::size_t>(texture)])
      set_needed(texture, keeps);
    else
      texture = PlannedPass::kNothing;
  }

  FramePlan& plan_;
  std::vector<bool> needed_, beside_;  // by texture: what the goal names beside
};

}  // namespace

void keep_used_textures(FramePlan& plan) {
  const std::vector<PlannedTexture> all = std::move(plan.textures);
  plan.textures.clear();
  std::vector<int> renumbered(all.size(), -1);
  const auto keep = [&](int& texture) {
    if (texture < 0) return;
    int& number = renumbered[static_cast<std::size_t>(texture)];
    if (number < 0) {
      number = static_cast<int>(plan.textures.size());
      plan.textures.push_back(all[static_cast<std::size_t>(texture)]);
    }
    texture = number;
  };
  for (PlannedPass& pass : plan.passes) {
    for (int& texture : pass.reads) keep(texture);
    for (int& texture : pass.writes) keep(texture);
    keep(pass.depth);
  }
}

FramePlan needed_for(const PlanGoal& goal, FramePlan plan) {
  const std::vector<std::string> reasons = BackwardWalk(plan, goal).walk();
  std::vector<PlannedPass> needed;
  for (std::size_t i = 0; i < plan.passes.size(); ++i) {
    PlannedPass& pass = plan.passes[i];
    if (!reasons[i].empty()) {
      if (pass.water < 0) plan.skipped.push_back({pass.label, reasons[i]});
      continue;
    }
    needed.push_back(std::move(pass));
  }
  plan.passes = std::move(needed);
  keep_used_textures(plan);
  return plan;
}

}  // namespace caustics
