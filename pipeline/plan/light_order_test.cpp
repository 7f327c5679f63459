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
  PassDefinition definition;
  definition.writes.resize(planned.writes.size());
  for (ColorWrite& write : definition.writes) write.blend = kAccumulate;
  planned.definition = std::make_shared<const PassDefinition>(std::move(definition));
  return planned;
}

std::string order_of(const std::vector<PlannedPass>& passes,
                     SampleOrder order = SampleOrder::SampleBySample) {
  FramePlan plan;
  plan.textures.resize(8);
  plan.passes = passes;
  order_by_light(plan, order);
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

TEST_CASE(
    "light order: samples come one after the other, or together light by light, glass when it is needed") {
  std::vector<PlannedPass> passes = {pass("map0", 0, {}, {2}), pass("map1", 1, {}, {3})};
  // Of each sample: where glass is, what lights add up, and both together.
  for (int sample = 1; sample <= 2; ++sample) {
    const std::string of = "/" + std::to_string(sample);
    const int glass = 2 + 2 * sample, sum = glass + 1;
    for (const PlannedPass& each : {pass("glass" + of, -1, {}, {glass}), pass("shade0" + of, 0, {2}, {sum}),
                                    pass("shade1" + of, 1, {3}, {sum}, true),
                                    pass("join" + of, -1, {glass, sum}, {kSum}, sample > 1)}) {
      passes.push_back(each);
      passes.back().sample = sample;
    }
  }
  CHECK(order_of(passes) == "map0! map1! glass/1 shade0/1 shade1/1 join/1 glass/2 shade0/2 shade1/2 join/2");
  CHECK(order_of(passes, SampleOrder::LightByLight) ==
        "map0! shade0/1 shade0/2 map1! shade1/1 shade1/2 glass/1 join/1 glass/2 join/2");
}
