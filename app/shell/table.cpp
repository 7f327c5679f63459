#include "app/shell/table.hpp"

#include <algorithm>

namespace caustics::app {

namespace {

constexpr std::size_t kWidest = 64;

}  // namespace

std::string Table::cell(const std::string& text, std::size_t column, std::size_t width) const {
  const std::string blanks(width > text.size() ? width - text.size() : 0, ' ');
  const bool right = column < to_the_right_.size() && to_the_right_[column];
  return right ? blanks + text : text + blanks;
}

std::string Table::text() const {
  std::vector<std::size_t> widths;
  for (const auto& cells : rows_) {
    widths.resize(std::max(widths.size(), cells.size()));
    for (std::size_t i = 0; i < cells.size(); ++i) {
      widths[i] = std::max(widths[i], std::min(cells[i].size(), kWidest));
    }
  }
  std::string result;
  for (const auto& cells : rows_) {
    std::string line = " ";
    for (std::size_t i = 0; i < cells.size(); ++i) {
      line += ' ';
      line += cell(cells[i], i, widths[i]);
      line += ' ';
    }
    result += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return result;
}

}  // namespace caustics::app
