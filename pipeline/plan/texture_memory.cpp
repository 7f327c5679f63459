#include "pipeline/plan/texture_memory.hpp"

#include <algorithm>

namespace caustics {

namespace {

// By texture: the last pass that uses it, or -1.
std::vector<int> last_uses(const FramePlan& plan) {
  std::vector<int> last(plan.textures.size(), -1);
  for (std::size_t i = 0; i < plan.passes.size(); ++i) {
    const auto use = [&](int texture) {
      if (texture >= 0) last[static_cast<std::size_t>(texture)] = static_cast<int>(i);
    };
    for (const int texture : plan.passes[i].reads) use(texture);
    for (const int texture : plan.passes[i].writes) use(texture);
    use(plan.passes[i].depth);
  }
  return last;
}

class Memory {
 public:
  explicit Memory(FramePlan& plan) : plan_(plan), last_(last_uses(plan)) {}

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
    taken_until_[m] =
        texture.kept ? static_cast<int>(plan_.passes.size()) : last_[static_cast<std::size_t>(index)];
  }

  FramePlan& plan_;
  std::vector<int> last_;
  std::vector<int> taken_until_;  // by memory: the last pass that its texture is used in
};

}  // namespace

void share_memory(FramePlan& plan) { Memory(plan).share(); }

}  // namespace caustics
