// The rows of docs/paper.md: each named thing of the paper, how it is made again, and what is checked.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "lab/paper/shots.hpp"

namespace caustics::paper {

// What a row's check found.
struct Finding {
  bool holds = false;
  std::string figure;  // the number, in words
};

struct Row {
  std::string id;     // of docs/paper.md
  std::string thing;  // what the paper names
  std::vector<Shot> shots;
  std::string
      picture;  // the name of the picture that shows it, a shot's or one that `check` draws; empty: none does
  std::string expected;
  std::function<Finding(const Shots&)> check;
};

// In the order of docs/paper.md.
std::vector<Row> paper_rows();

}  // namespace caustics::paper
