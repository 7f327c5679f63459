#include <map>
#include <numeric>
#include <set>
#include <sstream>

#include "lab/paper/row.hpp"
#include "tests/support/catch.hpp"

using namespace caustics::paper;

TEST_CASE("paper rows: each of the paper's 39 things has one row, with what is expected of it") {
  std::multiset<int> found;
  for (const Row& row : paper_rows()) {
    std::istringstream numbers(row.id);
    for (std::string number; std::getline(numbers, number, ',');) found.insert(std::stoi(number));
    INFO(row.id);
    CHECK_FALSE(row.expected.empty());
    CHECK(row.check);
  }
  std::vector<int> all(39);
  std::iota(all.begin(), all.end(), 1);
  CHECK(std::vector<int>(found.begin(), found.end()) == all);
}

TEST_CASE("paper rows: shots of one name are one shot") {
  std::map<std::string, Shot> shots;
  for (const Row& row : paper_rows())
    for (const Shot& shot : row.shots) {
      const Shot& first = shots.try_emplace(shot.name, shot).first->second;
      INFO(shot.name);
      CHECK(first.scene == shot.scene);
      CHECK(first.options == shot.options);
      CHECK(first.layers == shot.layers);
    }
}
