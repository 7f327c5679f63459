#include "pipeline/plan/light_order.hpp"

#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

constexpr int kFrameTexture = 0, kSum = 1;

// Two lights have a map each (textures 2 and 3), and add to the frame's sum.
PlannedPass pass(const std::string& label, int light, std::vector<int> reads, std::vector<int> writes,
                 bool adds = false) {
  PlannedPass planned;
  planned.label = label;
  planned.light = light;
  planned.reads = std::move(reads);
  planned.writes = std::move(writes);
  planned.keep.assign(planned.writes.size(), adds);
  planned.definition.writes.resize(planned.writes.size());
  for (ColorWrite& write : planned.definition.writes) write.blend = kAccumulate;
  return planned;
}

std::string order_of(const std::vector<PlannedPass>& passes) {
  FramePlan plan;
  plan.textures.resize(8);
  plan.passes = passes;
  order_by_light(plan);
  std::string text;
  for (const PlannedPass& planned : plan.passes) {
    text += (text.empty() ? "" : " ") + planned.label;
    if (planned.ends_light) text += "!";
  }
  return text;
}

}  // namespace

TEST_CASE("light order: each light's passes run together, after the frame's passes that they need") {
  CHECK(order_of({pass("map0", 0, {}, {2}), pass("map1", 1, {}, {3}), pass("view", -1, {}, {kFrameTexture}),
                  pass("shade0", 0, {kFrameTexture, 2}, {kSum}),
                  pass("shade1", 1, {kFrameTexture, 3}, {kSum}, true), pass("show", -1, {kSum}, {4})}) ==
        "view map0 shade0! map1 shade1! show");
}

TEST_CASE("light order: a light that needs what came of all lights waits for them") {
  CHECK(order_of({pass("map0", 0, {}, {2}), pass("map1", 1, {}, {3}), pass("join", -1, {2, 3}, {4}),
                  pass("use0", 0, {4, 2}, {5}), pass("use1", 1, {4, 3}, {6})}) ==
        "map0 map1 join use0! use1!");
  CHECK(order_of({pass("map0", 0, {}, {2}), pass("map1", 1, {}, {3}), pass("both", 0, {3}, {4})}) ==
        "map0 map1! both!");
}

TEST_CASE("light order: light is added light by light, what overwrites keeps its place") {
  const auto rounds = [](bool add) {
    return order_of({pass("a0", 0, {}, {kSum}), pass("a1", 1, {}, {kSum}, true),
                     pass("b0", 0, {}, {kSum}, add), pass("b1", 1, {}, {kSum}, add)});
  };
  CHECK(rounds(true) == "a0 b0! a1 b1!");
  CHECK(rounds(false) == "a0 a1 b0! b1!");
}

TEST_CASE("light order: the pass that clears a sum comes first, whoever's it is") {
  CHECK(order_of({pass("a1", 1, {}, {kSum}), pass("a0", 0, {}, {kSum}, true)}) == "a1! a0!");
}
