// Frames whose light is followed from surface to surface: which rounds are planned, in which order, and what
// they read. bounces = 3: light is bent at surfaces 1 to 3, and what lies ahead is looked for up to
// surface 4.
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

// Of what follows light: the passes of rounds, and those of branches behind them.
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

// All of a branch's rounds from surface 2 on, and what is made of its landings.
Names from_second_surface(const std::string& owner) {
  const std::string o = "[" + owner + "]";
  return {"next_surface" + o + ".2", "land" + o + ".2",       "bend" + o + ".2",
          "next_surface" + o + ".3", "land" + o + ".3",       "bend" + o + ".3",
          "next_surface" + o + ".4", "land" + o + ".4",       "cells" + o,
          "caustic_cells" + o,       "caustic_footprints" + o};
}

// The same of a branch that is mirrored at surface 2 first of all.
Names from_mirrored_second(const std::string& owner) {
  Names names = from_second_surface(owner);
  names.erase(names.begin(), names.begin() + 2);
  return names;
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

TEST_CASE("followed light: light enters, then lands or is bent at one surface after the other") {
  CHECK(labels_of(Bench(3, 0).plan()) == joined({{"enter[sun].1"}, from_second_surface("sun")}));
}

TEST_CASE("followed light: with one surface nothing is bent again, and what lies ahead is still looked for") {
  CHECK(labels_of(Bench(1, 0).plan()) == Names{"enter[sun].1", "next_surface[sun].2", "land[sun].2",
                                               "cells[sun]", "caustic_cells[sun]",
                                               "caustic_footprints[sun]"});
}

TEST_CASE(
    "followed light: what is mirrored at the first surface enters anew, after the rest has gone its way") {
  CHECK(labels_of(Bench(3, 1).plan()) == joined({{"enter[sun].1"},
                                                 from_second_surface("sun"),
                                                 {"enter[sun mirrored 1].1"},
                                                 from_second_surface("sun mirrored 1")}));
}

TEST_CASE("followed light: a branch goes all its way before the next begins, which parts as late as may be") {
  CHECK(labels_of(Bench(3, 2).plan()) == joined({{"enter[sun].1"},
                                                 from_second_surface("sun"),
                                                 from_mirrored_second("sun mirrored 2"),
                                                 {"enter[sun mirrored 1].1"},
                                                 from_second_surface("sun mirrored 1"),
                                                 from_mirrored_second("sun mirrored 1+2")}));
}

TEST_CASE("followed light: a round reads what the round before it has written, and writes its own") {
  const FramePlan plan = Bench(3, 0).plan();
  CHECK(reads(plan, "next_surface[sun].2", "ray_start.1[0]"));
  CHECK(reads(plan, "bend[sun].2", "ray_flux.1[0]"));
  CHECK(reads(plan, "bend[sun].2", "surface_hit.2[0]"));
  CHECK(reads(plan, "next_surface[sun].3", "ray_start.2[0]"));
  CHECK(reads(plan, "land[sun].4", "ray_start.3[0]"));
  CHECK(reads(plan, "land[sun].4", "surface_hit.4[0]"));
  CHECK(reads(plan, "land[sun].4", "receiver_position[0]"));
  CHECK(plan.find("ray_start.4[0]") < 0);
  CHECK(reads(plan, "cells[sun]", "landing_path[0]"));
  CHECK(reads(plan, "caustic_footprints[sun]", "landing_footprint[0]"));
}

TEST_CASE("followed light: where a branch begins it reads what the one that it parts from has met") {
  const FramePlan plan = Bench(3, 2).plan();
  CHECK(reads(plan, "bend[sun mirrored 2].2", "ray_start.1[0]"));
  CHECK(reads(plan, "bend[sun mirrored 2].2", "surface_hit.2[0]"));
  CHECK(reads(plan, "next_surface[sun mirrored 2].3", "ray_start.2[0 mirrored 2]"));
  CHECK(reads(plan, "bend[sun mirrored 2].3", "surface_hit.3[0 mirrored 2]"));
  CHECK(plan.find("surface_hit.2[0 mirrored 2]") < 0);
  CHECK(reads(plan, "next_surface[sun mirrored 1].2", "ray_start.1[0 mirrored 1]"));
  // Mirrored at both surfaces, it parts from what is mirrored at the first.
  CHECK(reads(plan, "bend[sun mirrored 1+2].2", "ray_start.1[0 mirrored 1]"));
  CHECK(reads(plan, "bend[sun mirrored 1+2].2", "surface_hit.2[0 mirrored 1]"));
}

TEST_CASE("followed light: a branch that parts at surface 3 begins there, of the branch that it parts from") {
  const FramePlan plan = Bench(4, 3).plan();
  const auto first_of = [&](const char* owner) {
    for (const std::string& label : labels_of(plan))
      if (label.find(std::string("[sun ") + owner + "]") != std::string::npos) return label;
    return std::string();
  };
  for (const auto& [branch, parent] : {std::pair{"mirrored 3", ""},
                                       {"mirrored 2+3", " mirrored 2"},
                                       {"mirrored 1+3", " mirrored 1"},
                                       {"mirrored 1+2+3", " mirrored 1+2"}}) {
    const std::string begins = std::string("bend[sun ") + branch + "].3";
    CHECK(first_of(branch) == begins);
    CHECK(reads(plan, begins, std::string("ray_start.2[0") + parent + "]"));
    CHECK(reads(plan, begins, std::string("surface_hit.3[0") + parent + "]"));
  }
}

TEST_CASE("followed light: a wavelength's branches part from their own") {
  Bench bench(3, 2);
  bench.branches = {{.name = "blue", .bend = 1.0, .color = {0, 0, 1}},
                    {.name = "red", .bend = -1.0, .color = {1, 1, 0}}};
  const FramePlan plan = bench.plan();
  CHECK(reads(plan, "bend[sun red mirrored 2].2", "ray_start.1[0 red]"));
  CHECK(reads(plan, "bend[sun red mirrored 1+2].2", "surface_hit.2[0 red mirrored 1]"));
  CHECK(reads(plan, "bend[sun blue mirrored 2].2", "ray_start.1[0 blue]"));
  CHECK(pass_of(plan, "enter[sun red].1").branch == 4);
}

TEST_CASE("followed light: a branch's landings are drawn into one texture, which its first round clears") {
  const FramePlan plan = Bench(3, 1).plan();
  for (const std::string owner : {"sun", "sun mirrored 1"}) {
    const PlannedPass &first = pass_of(plan, "land[" + owner + "].2"),
                      &second = pass_of(plan, "land[" + owner + "].3"),
                      &last = pass_of(plan, "land[" + owner + "].4");
    CHECK(first.writes == second.writes);
    CHECK(first.writes == last.writes);
    // landing_absorbed, the third, is begun by `enter`.
    CHECK(first.keep == std::vector<bool>{false, false, true, false, false});
    CHECK(second.keep == std::vector<bool>(5, true));
    const PlannedPass &entered = pass_of(plan, "enter[" + owner + "].1"),
                      &bent = pass_of(plan, "bend[" + owner + "].2");
    CHECK(entered.keep == std::vector<bool>(8, false));
    CHECK(bent.keep == std::vector<bool>{false, false, false, false, false, false, true, true});
    CHECK(first.writes[2] == entered.writes[7]);
  }
  CHECK(plan.find("landing[0 mirrored 1]") >= 0);
  CHECK(pass_of(plan, "land[sun].2").writes != pass_of(plan, "land[sun mirrored 1].2").writes);
}

TEST_CASE("followed light: a round runs only where the round before it has left light under way") {
  const FramePlan plan = Bench(3, 2).plan();
  const auto counts = [&](const char* label) { return pass_of(plan, label).counts_into; };
  const auto needs = [&](const char* label) { return pass_of(plan, label).only_if; };
  // Light enters where it reaches its casters.
  CHECK(counts("caster_map[sun]") > 0);
  CHECK(needs("enter[sun].1") == counts("caster_map[sun]"));
  CHECK(needs("enter[sun mirrored 1].1") == counts("caster_map[sun]"));
  REQUIRE(counts("enter[sun].1") > 0);
  for (const char* label : {"next_surface[sun].2", "land[sun].2", "bend[sun].2", "bend[sun mirrored 2].2"})
    CHECK(needs(label) == counts("enter[sun].1"));
  for (const char* label : {"next_surface[sun].3", "land[sun].3", "bend[sun].3"})
    CHECK(needs(label) == counts("bend[sun].2"));
  CHECK(needs("next_surface[sun mirrored 2].3") == counts("bend[sun mirrored 2].2"));
  CHECK(needs("bend[sun mirrored 1+2].2") == counts("enter[sun mirrored 1].1"));
  CHECK(needs("land[sun mirrored 1+2].4") == counts("bend[sun mirrored 1+2].3"));
  // Cells are made where the branch has begun.
  CHECK(needs("cells[sun]") == counts("enter[sun].1"));
  CHECK(needs("caustic_footprints[sun mirrored 2]") == counts("bend[sun mirrored 2].2"));
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
  CHECK(pass_of(plan, "hidden_landings[sun].far").only_if == pass_of(plan, "enter[sun].1").counts_into);
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
  CHECK(reads(plan, "bend[moon].2", "ray_start.1[1]"));
  CHECK(reads(plan, "land[moon].3", "surface_hit.3[1]"));
  CHECK(pass_of(plan, "enter[moon].1").only_if == pass_of(plan, "caster_map[moon]").counts_into);
  CHECK(pass_of(plan, "cells[moon]").only_if == pass_of(plan, "enter[moon].1").counts_into);
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
      "further surfaces: 50.0% of the light that lands goes other ways than through two surfaces, more than "
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
      "further surfaces: 1.0% of the light that lands goes other ways than through two surfaces, no more "
      "than 3.0%";
  for (const char* name : {"enter", "next_surface", "land", "bend", "caustic_footprints"})
    CHECK(why_skipped(plan, name) == reason);
  CHECK(plan.find(kHierarchyNodes) >= 0);  // the camera's rays walk
  Effects neither = bench.effects(0.01);
  neither.followed_view.active = false;
  CHECK(make_plan(bench.scene, neither, bench.settings, pass_registry()).find(kHierarchyNodes) < 0);
}

TEST_CASE("followed light: rays of surfaces that are behind make room, however many follow") {
  const auto bytes = [](int bounces, int splits) {
    return Bench(bounces, splits).plan({.textures = {"picture"}}).bytes();
  };
  CHECK(bytes(4, 0) == bytes(16, 0));
  CHECK(bytes(4, 2) == bytes(16, 2));
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
