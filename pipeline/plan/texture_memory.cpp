#include "pipeline/plan/texture_memory.hpp"

#include <algorithm>
#include <map>

#include "pipeline/gpu/interrupt.hpp"
#include "pipeline/plan/light_order.hpp"

namespace caustics {

namespace {

// Of each texture: the last pass that uses it, or for which it is kept.
void find_ends(FramePlan& plan) {
  std::map<int, int> light_ends;
  for (PlannedTexture& texture : plan.textures) texture.until = -1;
  for (std::size_t i = 0; i < plan.passes.size(); ++i) {
    const auto use = [&](int texture) {
      if (texture >= 0) plan.textures[static_cast<std::size_t>(texture)].until = static_cast<int>(i);
    };
    if (plan.passes[i].sample == 0) light_ends[plan.passes[i].light] = static_cast<int>(i);
    for (const int texture : plan.passes[i].reads) use(texture);
    for (const int texture : plan.passes[i].writes) use(texture);
    use(plan.passes[i].depth);
  }
  for (PlannedTexture& texture : plan.textures) {
    if (texture.kept) texture.until = static_cast<int>(plan.passes.size()) - 1;
    if (texture.kept_for_light) texture.until = std::max(texture.until, light_ends[texture.light]);
  }
}

class Memory {
 public:
  explicit Memory(FramePlan& plan) : plan_(plan) {}

  void share() {
    plan_.memory.clear();
    for (int pass = 0; pass < static_cast<int>(plan_.passes.size()); ++pass) {
      for (const int texture : plan_.passes[static_cast<std::size_t>(pass)].writes) take(texture, pass);
      take(plan_.passes[static_cast<std::size_t>(pass)].depth, pass);
    }
  }

 private:
  // Memory of its kind whose last texture no pass uses from this one on, or new memory.
  void take(int index, int pass) {
    if (index < 0) return;
    stop_if_interrupted();
    PlannedTexture& texture = plan_.textures[static_cast<std::size_t>(index)];
    if (texture.external || texture.memory >= 0) return;
    const auto fits = [&](std::size_t m) {
      const TextureMemory& memory = plan_.memory[m];
      return memory.format == texture.format && memory.width == texture.width &&
             memory.height == texture.height && taken_until_[m] < pass;
    };
    std::size_t m = 0;
    while (m < plan_.memory.size() && !fits(m)) ++m;
    if (m == plan_.memory.size()) {
      plan_.memory.push_back({texture.format, texture.width, texture.height});
      taken_until_.push_back(-1);
    }
    texture.memory = static_cast<int>(m);
    taken_until_[m] = texture.until;
  }

  FramePlan& plan_;
  std::vector<int> taken_until_;  // by memory: the last pass that its texture is used in
};

}  // namespace

void share_memory(FramePlan& plan) {
  find_ends(plan);
  Memory(plan).share();
}

FramePlan in_least_memory(FramePlan plan) {
  const bool samples = std::any_of(plan.passes.begin(), plan.passes.end(),
                                   [](const PlannedPass& pass) { return pass.sample > 0; });
  FramePlan by_light;
  if (samples) by_light = plan;
  order_by_light(plan, SampleOrder::SampleBySample);
  share_memory(plan);
  if (samples) {
    order_by_light(by_light, SampleOrder::LightByLight);
    share_memory(by_light);
    if (by_light.bytes() < plan.bytes()) plan = std::move(by_light);
  }
  return plan;
}

}  // namespace caustics
