#include "pipeline/effects/further_surfaces.hpp"

#include <algorithm>

#include "pipeline/settings/settings.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/scenes.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// Half of what lands through the one caster goes other ways than through two surfaces.
const std::vector<FurtherShare> kHalf{{.light = 0, .mesh = 1, .share = 0.5, .of_light = 1.0}};

Effects of_glass() {
  Effects effects;
  effects.lights.resize(8);
  effects.surfaces = {{.role = Role::Refractor}};
  return effects;
}

Effects followed(int splits, Effects effects = of_glass(), const std::vector<FurtherShare>& shares = kHalf) {
  Settings settings;
  settings.splits = splits;
  return with_further_surfaces(std::move(effects), settings, shares);
}

std::vector<std::string> names_of(const Effects& effects) {
  std::vector<std::string> names;
  for (const Branch& branch : effects.branches) names.push_back(branch.name);
  return names;
}

Effects with_branches(std::vector<Branch> branches) {
  Effects effects = of_glass();
  effects.branches = std::move(branches);
  return effects;
}

std::string why_not(const Settings& settings, Effects effects = {}) {
  effects.caustics.active = true;
  return why_not_followed(settings, effects);
}

}  // namespace

TEST_CASE(
    "further surfaces: at each surface where light parts a branch is mirrored, and one draws the rest") {
  for (int splits = 0; splits <= 4; ++splits) {
    const Effects effects = followed(splits);
    REQUIRE(effects.branches.size() == static_cast<std::size_t>(splits) + 2);
    CHECK(effects.branches.front().leads());
    CHECK_FALSE(effects.branches.front().has_same_start());
    for (int i = 1; i <= splits; ++i) {
      const Branch& branch = effects.branches[static_cast<std::size_t>(i)];
      CHECK(branch.mirrored_at == splits + 1 - i);
      CHECK_FALSE(branch.leads());
      CHECK(branch.has_same_start() == (branch.mirrored_at > 1));
      CHECK_FALSE(branch.drawn);
    }
    CHECK(effects.branches.back().drawn);
    CHECK(effects.branches.back().has_same_start());
    CHECK_FALSE(effects.branches.back().leads());
  }
}

TEST_CASE("further surfaces: all light is followed, or from a share on of what lands or is seen") {
  FurtherShare found{.light = 0, .mesh = 1, .share = 0.0, .of_light = 1.0};
  Settings settings;
  settings.further_share = 0.0f;
  const auto effects = [&] { return with_further_surfaces(of_glass(), settings, {found}); };
  CHECK(effects().further_surfaces.active);
  CHECK(effects().further_surfaces.reason ==
        "0.0% of the light that lands goes other ways than through two surfaces");
  settings.further_share = 0.03f;
  found.share = 0.02;
  CHECK_FALSE(effects().further_surfaces.active);
  found.share = 0.04;
  CHECK(effects().further_surfaces.active);
  found.share = 0.02;
  found.seen = 0.2;
  CHECK(effects().further_surfaces.active);
  CHECK(effects().further_surfaces.reason.find("20.0% of the light that is seen") == 0);
  settings.further_share = 1.0f;
  found.share = found.seen = 1.0;
  CHECK_FALSE(effects().further_surfaces.active);
}

TEST_CASE("further surfaces: light through rough glass is followed, however little goes other ways") {
  Effects effects = of_glass();
  effects.surfaces[0].rough = true;
  effects.rough_glass.active = true;
  const std::vector<FurtherShare> none{{.light = 0, .mesh = 1, .share = 0.0, .of_light = 1.0}};
  const Effects found = followed(0, effects, none);
  CHECK(names_of(found) == std::vector<std::string>{"", "drawn"});
  CHECK(found.branches[0].spread);
  Settings settings;
  settings.further_share = 1.0f;
  CHECK_FALSE(with_further_surfaces(effects, settings, none).further_surfaces.active);
}

TEST_CASE("further surfaces: nothing is drawn where it is not wanted") {
  Settings settings;
  settings.drawn = false;
  CHECK(names_of(with_further_surfaces(of_glass(), settings, kHalf)) ==
        std::vector<std::string>{"", "mirrored 2", "mirrored 1"});
}

TEST_CASE("further surfaces: light that mirrors alone send on never parts") {
  Effects effects;
  effects.lights.resize(8);
  effects.branches = {{}};
  effects.surfaces = {{.role = Role::Mirror}, {.role = Role::Receiver}};
  CHECK(names_of(followed(4, effects)) == std::vector<std::string>{""});
}

TEST_CASE("further surfaces: light parts at no more surfaces than it is followed through") {
  Settings settings;
  settings.splits = 4;
  settings.bounces = 2;
  CHECK(with_further_surfaces(of_glass(), settings, kHalf).branches.size() == 4);
}

TEST_CASE(
    "further surfaces: branches are named after the surface that mirrors them, the last to part first") {
  CHECK(names_of(followed(0)) == std::vector<std::string>{"", "drawn"});
  CHECK(names_of(followed(1)) == std::vector<std::string>{"", "mirrored 1", "drawn"});
  CHECK(names_of(followed(3)) ==
        std::vector<std::string>{"", "mirrored 3", "mirrored 2", "mirrored 1", "drawn"});
}

TEST_CASE("further surfaces: each wavelength has branches of its own, with its index and its colour") {
  const Effects effects = followed(1, with_branches({{.name = "486.1nm", .bend = 1.0, .color = {0, 0, 1}},
                                                     {.name = "656.3nm", .bend = -1.0, .color = {1, 1, 0}}}));
  CHECK(names_of(effects) == std::vector<std::string>{"486.1nm", "486.1nm mirrored 1", "486.1nm drawn",
                                                      "656.3nm", "656.3nm mirrored 1", "656.3nm drawn"});
  CHECK(effects.branches[1].bend == 1.0);
  CHECK(effects.branches[2].color == glm::vec3(0, 0, 1));
  CHECK(effects.branches[5].bend == -1.0);
  CHECK(names_of(followed(2, with_branches({{.name = "486.1nm"}}))) ==
        std::vector<std::string>{"486.1nm", "486.1nm mirrored 2", "486.1nm mirrored 1", "486.1nm drawn"});
}

TEST_CASE("further surfaces: they take the place of what glass mirrors at its first surface") {
  const Branch reflected{.name = "reflected", .reflected = true};
  CHECK(names_of(followed(1, with_branches({{}, reflected}))) ==
        std::vector<std::string>{"", "mirrored 1", "drawn"});
  CHECK(names_of(followed(0, with_branches({{}, reflected}))) == std::vector<std::string>{"", "drawn"});
}

TEST_CASE("further surfaces: light is followed where more than a named share of a light's meets them") {
  // A tenth of what one caster throws is 0.02 of a light to which it throws 0.2.
  const auto judged = [](double share, double of_light) {
    Settings settings;
    settings.further_share = 0.03f;
    return with_further_surfaces(with_branches({{}, {.name = "reflected", .reflected = true}}), settings,
                                 {{.light = 0, .mesh = 1, .share = share, .of_light = of_light}});
  };
  const Effects little = judged(0.1, 0.2);
  CHECK_FALSE(little.further_surfaces.active);
  CHECK(little.further_surfaces.reason ==
        "2.0% of the light that lands goes other ways than through two surfaces, less than 3.0%");
  CHECK(names_of(little) == std::vector<std::string>{"", "reflected"});
  const Effects more = judged(0.1, 0.6);
  CHECK(more.further_surfaces.active);
  CHECK(more.further_surfaces.reason ==
        "6.0% of the light that lands goes other ways than through two surfaces, at least 3.0%");
  CHECK(more.further_shares.size() == 1);
  CHECK_FALSE(judged(0.0, 1.0).further_surfaces.active);
}

TEST_CASE("further surfaces: the light with the most decides, by all its casters together") {
  Effects none;
  none.lights.resize(2);
  const Effects effects =
      followed(0, none,
               {{.light = 0, .mesh = 1, .share = 0.9, .of_light = 0.01},
                {.light = 1, .mesh = 2, .share = 0.2, .of_light = 0.5},
                {.light = 1, .mesh = 1, .share = 0.04, .of_light = 0.5}});  // 0.1 and 0.02
  CHECK(effects.further_surfaces.active);
  CHECK(effects.further_surfaces.reason.starts_with("12.0% of the light"));
  CHECK(effects.further_shares.size() == 3);
  // Where nothing lands there is nothing to follow.
  CHECK_FALSE(followed(2, {}, {}).further_surfaces.active);
  CHECK(followed(2, {}, {}).branches.size() == 1);
}

TEST_CASE("further surfaces: light is not followed where something else was asked for") {
  CHECK(why_not({}) == "");
  CHECK(why_not_followed({}, {}) == "there is no caustic");
  Settings settings;
  settings.interfaces = Interfaces::Two;
  CHECK(why_not(settings) == "a number of interfaces was asked for");
  settings = {};
  settings.weights = Weights::Paper;
  CHECK(why_not(settings) == "the paper's weights know two surfaces");
  settings = {};
  settings.thickness = Thickness::Wyman;
  CHECK(why_not(settings) == "Wyman's thickness knows two surfaces");
  settings = {};
  settings.draw_unconverged = true;
  CHECK(why_not(settings) == "what has not converged is drawn where its search stopped");
  settings = {};
  settings.estimator = Estimator::Impostor;
  CHECK(why_not(settings) == "impostors were asked for");
}
