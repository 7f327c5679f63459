// Text in columns, for reports that people read.
#pragma once
#include <string>
#include <vector>

namespace caustics::app {

// Rows in columns as wide as their widest entry (64 at most), the last one free.
class Table {
 public:
  // Columns that hold numbers are aligned to the right.
  explicit Table(std::vector<bool> to_the_right = {}) : to_the_right_(std::move(to_the_right)) {}
  void row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  // Every line indented by two blanks.
  std::string text() const;

 private:
  std::string cell(const std::string& text, std::size_t column, std::size_t width) const;

  std::vector<bool> to_the_right_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace caustics::app
