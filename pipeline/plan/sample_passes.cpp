#include "pipeline/plan/sample_passes.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "pipeline/plan/needed_passes.hpp"

namespace caustics {

namespace {

std::string of_sample(const std::string& name, int sample) {
  return name + ".sample " + std::to_string(sample);
}

class SamplePasses {
 public:
  // `adder`: the plan's pass of each sample. It reads what passes before it make of a sample, and adds it to
  // the texture of that name.
  SamplePasses(FramePlan& plan, std::size_t adder, const Registry& registry, const PlanGoal& goal)
      : plan_(plan), adder_(adder), registry_(registry), goal_(goal), sum_(plan.passes[adder].writes[0]) {
    sampled_textures_ = {sum_};
    sampled_ = leading_to(sampled_textures_, std::vector<bool>(adder, true));
    middle_textures_ = wanted_of_middle();
    middle_ = leading_to(middle_textures_, sampled_);
    for (const PlannedPass& pass : plan.passes) queries_ = std::max(queries_, pass.counts_into);
  }

  void expand(int samples) {
    std::vector<PlannedPass> passes;
    for (std::size_t i = 0; i < adder_; ++i) {
      if (!sampled_[i]) passes.push_back(plan_.passes[i]);
      if (middle_[i]) passes.push_back(writing_only(middle_textures_, plan_.passes[i]));
    }
    for (int sample = 1; sample <= samples; ++sample) {
      std::map<int, int> own;  // the sample's textures, by those of the plan
      own_queries_.clear();
      for (std::size_t i = 0; i < adder_; ++i)
        if (sampled_[i]) passes.push_back(copy(plan_.passes[i], sample, own));
      passes.push_back(copy_of_adder(sample, own.at(sum_)));
    }
    const auto rest = plan_.passes.begin() + static_cast<std::ptrdiff_t>(adder_) + 1;
    passes.insert(passes.end(), rest, plan_.passes.end());
    plan_.passes = std::move(passes);
  }

 private:
  // The camera's passes, of these, that the textures depend on; adds what those read.
  std::vector<bool> leading_to(std::set<int>& textures, const std::vector<bool>& of) const {
    std::vector<bool> leading(adder_, false);
    for (std::size_t i = adder_; i-- > 0;) {
      const PlannedPass& pass = plan_.passes[i];
      const std::vector<int> written = pass.attachments();
      leading[i] = of[i] && is_of_camera(registry_[static_cast<std::size_t>(pass.pass)], *pass.drawn_for) &&
                   std::any_of(written.begin(), written.end(), [&](int t) { return textures.contains(t); });
      if (leading[i]) textures.insert(pass.reads.begin(), pass.reads.end());
    }
    return leading;
  }

  // What others than the samples read, and what is wanted by name.
  std::set<int> wanted_of_middle() const {
    std::set<int> wanted;
    for (std::size_t i = 0; i < plan_.passes.size(); ++i)
      if (i > adder_ || (i < adder_ && !sampled_[i]))
        wanted.insert(plan_.passes[i].reads.begin(), plan_.passes[i].reads.end());
    for (int t = 0; t < static_cast<int>(plan_.textures.size()) && !goal_.textures.empty(); ++t)
      if (plan_.textures[static_cast<std::size_t>(t)].kept) wanted.insert(t);
    wanted.erase(sum_);
    return wanted;
  }

  static PlannedPass writing_only(const std::set<int>& textures, PlannedPass pass) {
    for (int& texture : pass.writes)
      if (!textures.contains(texture)) texture = PlannedPass::kNothing;
    return pass;
  }

  PlannedPass copy(const PlannedPass& planned, int sample, std::map<int, int>& own) {
    PlannedPass pass = writing_only(sampled_textures_, planned);
    pass.sample = sample;
    pass.label = of_sample(pass.label, sample);
    for (int& texture : pass.reads)
      if (const auto found = own.find(texture); found != own.end()) texture = found->second;
    for (int& texture : pass.writes) texture = own_texture(texture, sample, own);
    pass.depth = own_texture(pass.depth, sample, own);
    if (pass.counts_into > 0) own_queries_[pass.counts_into] = ++queries_;
    for (int* query : {&pass.counts_into, &pass.only_if})
      if (const auto found = own_queries_.find(*query); found != own_queries_.end()) *query = found->second;
    return pass;
  }

  PlannedPass copy_of_adder(int sample, int read) const {
    PlannedPass pass = plan_.passes[adder_];
    pass.sample = sample;
    pass.label = of_sample(pass.label, sample);
    pass.reads[0] = read;
    pass.keep[0] = sample > 1;
    return pass;
  }

  int own_texture(int texture, int sample, std::map<int, int>& own) {
    if (texture < 0) return texture;
    const auto [place, is_new] = own.try_emplace(texture, static_cast<int>(plan_.textures.size()));
    if (is_new) {
      PlannedTexture made = plan_.textures[static_cast<std::size_t>(texture)];
      made.name = of_sample(made.name, sample);
      // Those who look at them while the frame is drawn need no more memory for more samples.
      made.kept = goal_.textures.empty() && !goal_.light_by_light;
      plan_.textures.push_back(std::move(made));
    }
    return place->second;
  }

  FramePlan& plan_;
  std::size_t adder_;
  const Registry& registry_;
  const PlanGoal& goal_;
  int sum_;
  // By pass: is it drawn for each sample, and for the pixels' middles? And what that needs of textures.
  std::vector<bool> sampled_, middle_;
  std::set<int> sampled_textures_, middle_textures_;
  int queries_ = 0;                 // the last one's number
  std::map<int, int> own_queries_;  // of the sample that is copied, by those of the plan
};

}  // namespace

FramePlan with_samples(FramePlan plan, const Registry& registry, int samples, const PlanGoal& goal) {
  const auto adder = std::find_if(plan.passes.begin(), plan.passes.end(), [](const PlannedPass& pass) {
    return pass.drawn_for->each == Each::Sample;
  });
  if (adder == plan.passes.end()) return plan;
  SamplePasses(plan, static_cast<std::size_t>(adder - plan.passes.begin()), registry, goal).expand(samples);
  keep_used_textures(plan);
  return plan;
}

}  // namespace caustics
