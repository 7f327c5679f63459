#include "pipeline/plan/texture_memory.hpp"

#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

// Textures of one kind, of which none is kept.
FramePlan plan_of(int textures, const std::vector<PlannedPass>& passes) {
  FramePlan plan;
  for (int i = 0; i < textures; ++i)
    plan.textures.push_back({.name = std::to_string(i), .width = 8, .height = 8, .kept = false});
  plan.passes = passes;
  return plan;
}

PlannedPass pass(std::vector<int> reads, std::vector<int> writes) {
  PlannedPass planned;
  planned.reads = std::move(reads);
  planned.writes = std::move(writes);
  return planned;
}

std::vector<int> memory_of(const FramePlan& plan) {
  std::vector<int> memory;
  for (const PlannedTexture& texture : plan.textures) memory.push_back(texture.memory);
  return memory;
}

}  // namespace

TEST_CASE("texture memory: a chain of passes needs two textures, one read and one written") {
  FramePlan plan = plan_of(4, {pass({}, {0}), pass({0}, {1}), pass({1}, {2}), pass({2}, {3})});
  share_memory(plan);
  CHECK(memory_of(plan) == std::vector<int>{0, 1, 0, 1});
  CHECK(plan.memory.size() == 2);
  CHECK(plan.bytes() == 2 * 64 * 16);
}

TEST_CASE("texture memory: what is kept, or read again later, is not taken") {
  FramePlan plan = plan_of(4, {pass({}, {0}), pass({0}, {1}), pass({1}, {2}), pass({0, 2}, {3})});
  share_memory(plan);
  CHECK(memory_of(plan) == std::vector<int>{0, 1, 2, 1});
  plan = plan_of(3, {pass({}, {0}), pass({0}, {1}), pass({1}, {2})});
  plan.textures[0].kept = true;
  share_memory(plan);
  CHECK(memory_of(plan) == std::vector<int>{0, 1, 2});
}

TEST_CASE("texture memory: another size or format does not fit") {
  FramePlan plan = plan_of(4, {pass({}, {0}), pass({0}, {1}), pass({1}, {2}), pass({2}, {3})});
  plan.textures[2].width = 4;
  plan.textures[3].format = Format::R32F;
  share_memory(plan);
  CHECK(memory_of(plan) == std::vector<int>{0, 1, 2, 3});
}

TEST_CASE("texture memory: a texture that several passes draw into is held from the first to the last") {
  FramePlan plan = plan_of(3, {pass({}, {0}), pass({}, {1}), pass({}, {0}), pass({0}, {2})});
  share_memory(plan);
  CHECK(memory_of(plan) == std::vector<int>{0, 1, 1});
}

TEST_CASE("texture memory: what is kept for a light is held to that light's last pass") {
  FramePlan plan = plan_of(5, {pass({}, {0}), pass({0}, {1}), pass({1}, {2}), pass({}, {3}), pass({3}, {4})});
  for (std::size_t i = 0; i < 5; ++i) plan.passes[i].light = i < 3 ? 0 : 1;
  plan.textures[0].light = 0;
  plan.textures[0].kept_for_light = true;
  share_memory(plan);
  CHECK(plan.textures[0].until == 2);
  CHECK(memory_of(plan) == std::vector<int>{0, 1, 2, 0, 1});
}

TEST_CASE("texture memory: attachments that nobody needs and uploaded textures take none") {
  FramePlan plan = plan_of(2, {pass({0}, {PlannedPass::kNothing, 1})});
  plan.textures[0].external = true;
  share_memory(plan);
  CHECK(memory_of(plan) == std::vector<int>{-1, 0});
}
