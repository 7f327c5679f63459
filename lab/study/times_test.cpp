#include "lab/study/times.hpp"

#include "tests/support/catch.hpp"

using namespace caustics::study;

TEST_CASE("study times: the median of an even number lies between the middle two") {
  const Times times = times_of({4.0, 1.0, 3.0, 10.0});
  CHECK(times.median == 3.5);
  CHECK(times.least == 1.0);
  CHECK(times.most == 10.0);
  CHECK(times_of({5.0, 2.0, 9.0}).median == 5.0);
  CHECK(times_of({}).median == 0.0);
}

TEST_CASE("study times: one slow frame moves neither the median nor the deviation far") {
  // From 5: 0, 1, 1, 3, 95, of which the middle one is 1.
  const Times times = times_of({6.0, 100.0, 4.0, 5.0, 2.0});
  CHECK(times.median == 5.0);
  CHECK(times.deviation == 1.0);
  // From 2.5: 1.5, 0.5, 0.5, 1.5.
  CHECK(times_of({1.0, 2.0, 3.0, 4.0}).deviation == 1.0);
  CHECK(times_of({7.0}).deviation == 0.0);
}
