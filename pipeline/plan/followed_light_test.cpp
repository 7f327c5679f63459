// Frames whose light is followed from surface to surface: which passes are planned, in which order, and what
// they read.
#include <algorithm>

#include "passes/registry.hpp"
#include "pipeline/effects/further_surfaces.hpp"
#include "pipeline/plan/frame_plan.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// A glass ball over a floor under a sun, half of whose light goes other ways than through two surfaces.
struct Bench {
  Scene scene = sphere_scene(1.5f, 1);
  Settings settings = small_settings(32, 32, 24);
  std::vector<Branch> branches{Branch{}};  // before light parts at surfaces

  Bench(int bounces, int splits) {
    settings.bounces = bounces;
    settings.splits = splits;
    settings.further_share = 0.03f;
  }
  Effects effects(double share = 0.5) const {
    Effects effects = effects_of(scene, settings);
    effects.branches = branches;
    return with_further_surfaces(std::move(effects), settings,
                                 {{.light = 0, .mesh = 1, .share = share, .of_light = 1.0}});
  }
  FramePlan plan(const PlanGoal& goal = {}) const {
    return make_plan(scene, effects(), settings, pass_registry(), goal);
  }
};

using Names = std::vector<std::string>;

bool follows(const PlannedPass& pass) { return pass.branch >= 0; }

Names labels_of(const FramePlan& plan, bool (*wanted)(const PlannedPass&) = follows) {
  Names labels;
  for (const PlannedPass& pass : plan.passes)
    if (wanted(pass)) labels.push_back(pass.label);
  return labels;
}

PlannedPass pass_of(const FramePlan& plan, const std::string& label) {
  const auto found = std::find_if(plan.passes.begin(), plan.passes.end(),
                                  [&](const PlannedPass& pass) { return pass.label == label; });
  INFO(label);
  REQUIRE(found != plan.passes.end());
  return *found;
}

bool reads(const FramePlan& plan, const std::string& label, const std::string& texture) {
  const PlannedPass& pass = pass_of(plan, label);
  const int wanted = plan.find(texture);
  INFO(label << " and " << texture);
  REQUIRE(wanted >= 0);
  return std::find(pass.reads.begin(), pass.reads.end(), wanted) != pass.reads.end();
}

// A branch's whole way, and what is made of its landings.
Names way_of(const std::string& owner) {
  const std::string o = "[" + owner + "]";
  return {"walk" + o, "cells" + o, "caustic_cells" + o, "caustic_footprints" + o};
}

Names joined(const std::vector<Names>& parts) {
  Names all;
  for (const Names& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

std::string why_skipped(const FramePlan& plan, const std::string& name) {
  for (const SkippedPass& skipped : plan.skipped)
    if (skipped.name == name) return skipped.reason;
  return {};
}

}  // namespace

TEST_CASE("followed light: a branch goes all its way before the next begins, which parts as late as may be") {
  CHECK(labels_of(Bench(3, 0).plan()) == joined({way_of("sun"), way_of("sun drawn")}));
  CHECK(labels_of(Bench(3, 1).plan()) ==
        joined({way_of("sun"), way_of("sun mirrored 1"), way_of("sun drawn")}));
  CHECK(labels_of(Bench(3, 2).plan()) ==
        joined({way_of("sun"), way_of("sun mirrored 2"), way_of("sun mirrored 1"), way_of("sun drawn")}));
}

TEST_CASE("followed light: what is made of landings reads the branch's own") {
  const FramePlan plan = Bench(3, 1).plan();
  CHECK(reads(plan, "walk[sun]", "receiver_position[0]"));
  CHECK(reads(plan, "cells[sun]", "landing_path[0]"));
  CHECK(reads(plan, "caustic_footprints[sun mirrored 1]", "landing_footprint[0 mirrored 1]"));
}

TEST_CASE("followed light: the second surface is found once for all branches that come to it alike") {
  const FramePlan plan = Bench(4, 3).plan();
  for (const char* branch : {"walk[sun mirrored 3]", "walk[sun mirrored 2]", "walk[sun drawn]"})
    CHECK(reads(plan, branch, "second_hit[0]"));
  for (const char* branch : {"walk[sun]", "walk[sun mirrored 1]"})
    CHECK(pass_of(plan, branch).reads.back() == PlannedPass::kNothing);
}

TEST_CASE("followed light: a wavelength's branches come to the second surface as it does") {
  Bench bench(3, 2);
  bench.branches = {{.name = "blue", .bend = 1.0, .color = {0, 0, 1}},
                    {.name = "red", .bend = -1.0, .color = {1, 1, 0}}};
  const FramePlan plan = bench.plan();
  CHECK(reads(plan, "walk[sun red mirrored 2]", "second_hit[0 red]"));
  CHECK(reads(plan, "walk[sun red drawn]", "second_hit[0 red]"));
  CHECK(reads(plan, "walk[sun blue mirrored 2]", "second_hit[0 blue]"));
  CHECK(pass_of(plan, "walk[sun red]").branch == 4);
}

TEST_CASE("followed light: what comes behind a branch's walk runs only where that has left light") {
  const FramePlan plan = Bench(3, 2).plan();
  const auto counts = [&](const char* label) { return pass_of(plan, label).counts_into; };
  const auto needs = [&](const char* label) { return pass_of(plan, label).only_if; };
  // Light enters where it reaches its casters.
  CHECK(counts("caster_map[sun]") > 0);
  CHECK(needs("walk[sun]") == counts("caster_map[sun]"));
  CHECK(needs("walk[sun drawn]") == counts("caster_map[sun]"));
  REQUIRE(counts("walk[sun]") > 0);
  CHECK(needs("cells[sun]") == counts("walk[sun]"));
  CHECK(needs("caustic_footprints[sun mirrored 2]") == counts("walk[sun mirrored 2]"));
  // Every count is one pass's own.
  std::vector<int> all;
  for (const PlannedPass& pass : plan.passes)
    if (pass.counts_into > 0) all.push_back(pass.counts_into);
  std::sort(all.begin(), all.end());
  CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());
}

TEST_CASE("followed light: what receivers hide from the light has landings and cells of its own") {
  Bench bench(2, 0);
  bench.scene.meshes.push_back(box({-1.4, 0.4, -0.9}, {-0.6, 0.6, -0.4}, 0));
  const FramePlan plan = bench.plan();
  CHECK(reads(plan, "hidden_landings[sun].far", "landing[0]"));
  CHECK(reads(plan, "hidden_landings[sun].far", "landing_footprint[0]"));
  CHECK(reads(plan, "cells[sun]", "landing[0]"));
  CHECK(reads(plan, "cells[sun].far", "landing.far[0]"));
  CHECK(reads(plan, "cells[sun].far", "landing_path.far[0]"));
  CHECK(reads(plan, "caustic_footprints[sun].far", "landing_footprint.far[0]"));
  CHECK(pass_of(plan, "hidden_landings[sun].far").only_if == pass_of(plan, "walk[sun]").counts_into);
}

TEST_CASE("followed light: of hidden receivers each branch reads its own landings, not the first's") {
  Bench bench(2, 1);
  bench.scene.meshes.push_back(box({-1.4, 0.4, -0.9}, {-0.6, 0.6, -0.4}, 0));
  const FramePlan plan = bench.plan();
  CHECK(reads(plan, "hidden_landings[sun mirrored 1].far", "landing[0 mirrored 1]"));
  CHECK(!reads(plan, "hidden_landings[sun mirrored 1].far", "landing.far[0]"));
  CHECK(reads(plan, "cells[sun mirrored 1].far", "landing.far[0 mirrored 1]"));
  CHECK(reads(plan, "caustic_footprints[sun mirrored 1].far", "landing_footprint.far[0 mirrored 1]"));
}

TEST_CASE("followed light: each light is followed by itself") {
  Bench bench(2, 0);
  bench.scene.lights.push_back(sun({0.2, -1.0, 0.0}, 1.0f));
  bench.scene.lights[1].name = "moon";
  const FramePlan plan = bench.plan();
  CHECK(reads(plan, "walk[moon]", "caster_position[1]"));
  CHECK(pass_of(plan, "walk[moon]").only_if == pass_of(plan, "caster_map[moon]").counts_into);
  CHECK(pass_of(plan, "cells[moon]").only_if == pass_of(plan, "walk[moon]").counts_into);
}

TEST_CASE("followed light: a light that throws no caustic is not followed") {
  Bench bench(2, 0);
  bench.scene.lights.push_back(sun({0.0, 1.0, 0.0}, 1.0f));  // from below: no receiver lies behind the ball
  bench.scene.lights[1].name = "below";
  const Names labels = labels_of(bench.plan());
  CHECK(labels == labels_of(Bench(2, 0).plan()));
}

TEST_CASE("followed light: passes for two surfaces are left out, with the effect's reason") {
  const FramePlan plan = Bench(3, 0).plan();
  const std::string reason =
      "further surfaces: 50.0% of the light that lands goes other ways than through two surfaces, at least "
      "3.0%";
  for (const char* name : {"landing", "landing.far", "caustic_map", "caustic_map.cascade"})
    CHECK(why_skipped(plan, name) == reason);
  for (const char* name : {kHierarchyNodes, kHierarchyTriangles, kHierarchyNormals}) {
    REQUIRE(plan.find(name) >= 0);
    CHECK(plan.textures[static_cast<std::size_t>(plan.find(name))].external);
  }
}

TEST_CASE("followed light: where little meets further surfaces nothing of it is planned") {
  const Bench bench(3, 2);
  const FramePlan plan = make_plan(bench.scene, bench.effects(0.01), bench.settings, pass_registry());
  CHECK(labels_of(plan) == Names{"landing[sun]", "cells[sun]", "caustic_cells[sun]", "caustic_map[sun]"});
  const std::string reason =
      "further surfaces: 1.0% of the light that lands goes other ways than through two surfaces, less "
      "than 3.0%";
  for (const char* name : {"walk", "caustic_footprints"}) CHECK(why_skipped(plan, name) == reason);
  CHECK(plan.find(kHierarchyNodes) >= 0);  // the camera's rays walk
  Effects neither = bench.effects(0.01);
  neither.seen_casters.active = false;
  CHECK(make_plan(bench.scene, neither, bench.settings, pass_registry()).find(kHierarchyNodes) < 0);
}

TEST_CASE("followed light: however many surfaces follow, and branches, the memory is the same") {
  const auto bytes = [](int bounces, int splits) {
    return Bench(bounces, splits).plan({.textures = {"picture"}}).bytes();
  };
  CHECK(bytes(4, 0) == bytes(16, 0));
  CHECK(bytes(4, 2) == bytes(4, 3));
}

TEST_CASE("followed light: no branch parts behind the last surface that light is followed through") {
  // It would have no landings of its own, and read those of the light's first branch once more.
  const FramePlan plan = Bench(2, 4).plan();
  for (const PlannedPass& pass : plan.passes)
    if (pass.branch > 0)
      for (const int texture : pass.reads)
        CHECK((texture < 0 || plan.textures[static_cast<std::size_t>(texture)].name != "landing[0]"));
  CHECK(labels_of(plan) == labels_of(Bench(2, 2).plan()));
}
