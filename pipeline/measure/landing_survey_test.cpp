#include "pipeline/measure/landing_survey.hpp"

#include "pipeline/measure/ledger.hpp"
#include "tests/support/catch.hpp"

using namespace caustics;

namespace {

constexpr int kSide = 5;

struct Landings {
  Image landing{Format::RGBA32F, kSide, kSide}, flux = landing;
};

// Vertices land at x(column), row on z = 0, each with flux 1; those that do not land are `missing` columns.
template <class Where>
Landings landings(Where x, int missing = 0) {
  Landings result;
  for (int row = 0; row < kSide; ++row)
    for (int column = 0; column < kSide; ++column) {
      const bool lands = column >= missing;
      result.landing.at(column, row, 0) = lands ? x(column) : 0.0f;
      result.landing.at(column, row, 1) = lands ? static_cast<float>(row) : 0.0f;
      result.landing.at(column, row, 3) =
          static_cast<float>(lands ? LandingStatus::Landed : LandingStatus::Empty);
      if (lands) result.flux.at(column, row, 0) = 1.0f;
    }
  return result;
}

// Looks along z; window 0..8, a texel of an 8-texel map is 1.
View square() {
  View view;
  view.forward = {0.0, 0.0, 1.0};
  view.window_lower = {0.0, 0.0};
  view.window_upper = {8.0, 8.0};
  view.near = -1.0;
  view.far = 1.0;
  return view;
}

LightViews views() {
  LightViews all;
  all.caustic = square();
  return all;
}

LandingSurvey survey_of(const Landings& of) { return survey_landings(of.landing, of.flux, square()); }

const auto kEven = [](int column) { return static_cast<float>(column); };

}  // namespace

TEST_CASE("landing survey: even light has none") {
  const LandingSurvey found = survey_of(landings(kEven));
  CHECK(found.edges.empty());
  CHECK(found.flux == 16.0);  // cells
  CHECK(blurred_share(found, views(), square(), 8, 8) == 0.0);
}

TEST_CASE("landing survey: where light ends there is a step in each row") {
  const LandingSurvey found = survey_of(landings(kEven, 1));
  REQUIRE(found.edges.size() == 4);
  for (const CausticEdge& edge : found.edges) {
    CHECK_FALSE(edge.fold);
    CHECK(edge.width == 1.0);
    CHECK(edge.flux == 1.0);
    CHECK(edge.at.x == 1.5);
  }
}

TEST_CASE("landing survey: light that turns back on itself has a fold in each row") {
  const LandingSurvey found = survey_of(landings([](int column) {
    return static_cast<float>((column - 2) * (column - 2));  // 4 1 0 1 4
  }));
  REQUIRE(found.edges.size() == 4);
  for (const CausticEdge& edge : found.edges) {
    CHECK(edge.fold);
    CHECK(edge.flux == 2.0);
    CHECK(edge.width == 1.0);  // cells of 1 x 1
    CHECK(edge.at.x == 0.5);
  }
}

// landing_survey.cpp's fit: of the light within a pixel of a step, at one texel a pixel 0.165, at two 0.165
// / 4.
TEST_CASE("landing survey: what a map blurs falls with its texels") {
  const LandingSurvey found = survey_of(landings(kEven, 1));  // 12 whole cells, 4 in part with half the flux
  CHECK(found.flux == 14.0);
  // 32 pixels a row: a quarter of a window unit each, so that an edge has a quarter of its cell's light.
  const double at_one = blurred_share(found, views(), square(), 32, 32);
  CHECK(at_one == Approx(4.0 * 0.25 * 0.165 / 14.0));
  CHECK(blurred_share(found, views(), square(), 32, 64) == Approx(at_one / 4.0));
}

TEST_CASE("landing survey: of what the camera does not see nothing is blurred") {
  View elsewhere = square();
  elsewhere.window_lower.x = 4.0;
  CHECK(blurred_share(survey_of(landings(kEven, 1)), views(), elsewhere, 32, 32) == 0.0);
}

TEST_CASE("landing survey: in a cascade's window its texels count") {
  LightViews with_cascade = views();
  with_cascade.cascade = square();
  with_cascade.cascade->window_upper = {4.0, 4.0};
  const LandingSurvey found = survey_of(landings(kEven, 1));
  CHECK(blurred_share(found, with_cascade, square(), 32, 32) ==
        Approx(blurred_share(found, views(), square(), 32, 64)));
}

TEST_CASE("landing survey: a cell covers the square around it, a texel longer than it is") {
  const LandingSurvey found = survey_of(landings(kEven));  // 16 cells of 1 x 1 in a window of 8 x 8
  CHECK(covered_texels(found, square(), kSide, 8) == 16 * 4);
  CHECK(covered_texels(found, square(), kSide, 16) == 16 * 9);
  // Twice as many vertices: four cells of half a unit for one.
  CHECK(covered_texels(found, square(), 2 * kSide, 8) == 16 * 4 * 2.25);
}

TEST_CASE("landing survey: cells beside a window cover nothing of it") {
  View elsewhere = square();
  elsewhere.window_lower = {5.0, 5.0};
  CHECK(covered_texels(survey_of(landings(kEven)), elsewhere, kSide, 8) == 0.0);
}
