#include "lab/study/pareto.hpp"

#include <limits>

#include "lab/study/study.hpp"
#include "tests/support/catch.hpp"

using namespace caustics::study;

using Front = std::vector<std::size_t>;

TEST_CASE("study front: what is beaten in one and not better in the other is left out") {
  // Error, milliseconds. 1 beats 2 in both; 3 is as slow as 1 and worse; 4 is the most accurate.
  CHECK(pareto_front({Cost{0.5, 1.0}, Cost{0.2, 4.0}, Cost{0.3, 5.0}, Cost{0.4, 4.0}, Cost{0.1, 9.0}}) ==
        Front{0, 1, 4});
}

TEST_CASE("study front: equal errors leave the quicker, equal costs the first") {
  CHECK(pareto_front({Cost{0.2, 3.0}, Cost{0.2, 2.0}, Cost{0.2, 2.0}}) == Front{1});
}

TEST_CASE("study front: a slower row that is hardly better is not worth it") {
  const std::vector<std::optional<Cost>> costs{Cost{0.2, 1.0}, Cost{0.199, 2.0}, Cost{0.19, 3.0}};
  CHECK(pareto_front(costs) == Front{0, 1, 2});
  CHECK(pareto_front(costs, 0.01) == Front{0, 2});
  // Small steps add up: both together are more than one per cent.
  CHECK(pareto_front({Cost{0.2, 1.0}, Cost{0.1985, 2.0}, Cost{0.197, 3.0}}, 0.01) == Front{0, 2});
}

TEST_CASE("study front: rows without figures and figures that are not finite take no part") {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  CHECK(pareto_front({std::nullopt, Cost{nan, 1.0}, Cost{0.1, infinity}, Cost{0.4, 2.0}}) == Front{3});
  CHECK(pareto_front({}).empty());
}

TEST_CASE("study front: a row without error is a front's end") {
  CHECK(pareto_front({Cost{0.0, 5.0}, Cost{0.1, 9.0}, Cost{0.0, 6.0}}) == Front{0});
}

TEST_CASE("study front: of a backend alone, without rows that have a problem or no error") {
  Study study;
  const auto add = [&](const char* backend, std::optional<double> error, double median, const char* problem) {
    StudyRow row{.backend = backend, .problem = problem};
    row.figures.relative_l1 = error;
    row.caustic.median = median;
    study.rows.push_back(row);
  };
  add("software", 0.5, 1.0, "");
  add("software", 0.01, 0.5, "it ran out of memory");
  add("gl", 0.02, 0.6, "");
  add("software", {}, 0.7, "");
  add("software", 0.2, 4.0, "");
  judge(study);
  std::vector<bool> on_front;
  for (const StudyRow& row : study.rows) on_front.push_back(row.on_front);
  CHECK(on_front == std::vector<bool>{true, false, true, false, true});
  const std::vector<const StudyRow*> front = front_of(study, "software");
  REQUIRE(front.size() == 2);
  CHECK((front[0] == &study.rows[0] && front[1] == &study.rows[4]));
}
