#include "pipeline/measure/outcome.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/run_pass.hpp"

using namespace caustics;
using namespace caustics::test;

namespace {

// Of light that has entered, nearly all ended so, and a little was missed.
std::string reason(LandingStatus most, bool over_added_ground = false) {
  Outcome outcome{.entered = 1.0};
  outcome.ended[static_cast<std::size_t>(LandingStatus::Missed)] = 0.01;
  outcome.ended[static_cast<std::size_t>(most)] += 0.9;
  return why_no_caustic(outcome, over_added_ground);
}

}  // namespace

TEST_CASE("outcome: the reason why there is no caustic is what became of most of the light") {
  CHECK(reason(LandingStatus::Landed).empty());
  CHECK(reason(LandingStatus::Missed).starts_with("all of its light goes past everything"));
  CHECK(reason(LandingStatus::Missed).find("--ground on") != std::string::npos);
  CHECK(reason(LandingStatus::Missed, true).ends_with("the added ground too; --sun moves the light"));
  CHECK(reason(LandingStatus::Outside) == reason(LandingStatus::Missed));
  CHECK(reason(LandingStatus::TotalReflection).starts_with("all of its light is totally reflected inside"));
  CHECK(reason(LandingStatus::Absorbed) == "its material absorbs all of the light");
  CHECK(reason(LandingStatus::NotConverged) == "none of its light could be followed to the end");
  CHECK(reason(LandingStatus::ExitNotFound) ==
        "where its light leaves it was not found: behind a nearer second surface, perhaps");
  CHECK(why_no_caustic({.entered = 1.0}, false) == "hardly any of its light is left");
  CHECK(why_no_caustic({}, false) == "no light reaches it: something stands before it");
}

TEST_CASE("outcome: what was mirrored has entered once, and each caster has its own") {
  // Two vertices on the casters of rows 0 and 1: 2 lumen onto the first, of which 0.5 are let in and land,
  // 0.25 are mirrored and miss; 1 lumen onto the second, all absorbed.
  Image normal(Format::RGBA32F, 2, 1);
  normal.at(1, 0, 3) = 1.0f;
  const auto vertex = [](Image& image, int x, const glm::vec4& value) {
    for (int c = 0; c < 4; ++c) image.at(x, 0, c) = value[c];
  };
  Image landing(Format::RGBA32F, 2, 1), flux = landing, fresnel = landing;
  vertex(landing, 0, {0, 0, 0, STATUS_LANDED});
  vertex(landing, 1, {0, 0, 0, STATUS_ABSORBED});
  vertex(flux, 0, {0.5f, 0.5f, 0.5f, 0});
  vertex(fresnel, 0, {0, 0, 0, 2});
  vertex(fresnel, 1, {0, 0, 0, 1});
  Image missed(Format::RGBA32F, 2, 1), mirrored_flux = missed;
  vertex(missed, 0, {0, 0, 0, STATUS_MISSED});
  vertex(mirrored_flux, 0, {0.25f, 0.25f, 0.25f, 0});
  BranchImages through{};
  through.branch.color = glm::vec3(1.0f);
  through.landing = landing;
  through.flux = flux;
  through.fresnel = fresnel;
  BranchImages mirrored = through;
  mirrored.branch.reflected = true;
  mirrored.landing = missed;
  mirrored.flux = mirrored_flux;
  const std::vector<Outcome> outcomes = outcomes_of({through, mirrored}, normal, {7, 9});
  REQUIRE(outcomes.size() == 2);
  CHECK(outcomes[0].mesh == 7);
  CHECK(outcomes[0].entered == 2.0);
  CHECK(outcomes[0].share(LandingStatus::Landed) == 0.25);
  CHECK(outcomes[0].share(LandingStatus::Missed) == 0.125);
  CHECK(outcomes[1].mesh == 9);
  CHECK(outcomes[1].entered == 1.0);
}
