#include "pipeline/settings/nearest.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace caustics {

namespace {

// Insertions, deletions and substitutions that turn one text into the other (Levenshtein).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitute = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitute});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_name(std::string_view typed, const std::vector<std::string>& names) {
  // Only so much of an absurdly long text matters.
  const std::string_view text = typed.substr(0, 64);
  const auto nearest =
      std::min_element(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
        return edit_distance(text, a) < edit_distance(text, b);
      });
  return nearest == names.end() ? std::string() : *nearest;
}

}  // namespace caustics
