#include "pipeline/settings/nearest.hpp"

#include <algorithm>

#include "pipeline/gpu/text.hpp"

namespace caustics {

namespace {

// Only so much of an absurdly long text matters.
constexpr std::size_t kLongest = 64;
constexpr std::size_t kMostListed = 12;

// Insertions, deletions, substitutions and swaps of neighbours that turn one text into the other (optimal
// string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> table(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t j = 0; j <= b.size(); ++j) table[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::vector<std::size_t>& row = table[i];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitute = table[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({table[i - 1][j] + 1, row[j - 1] + 1, substitute});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], table[i - 2][j - 2] + 1);
    }
  }
  return table[a.size()][b.size()];
}

std::size_t distance(std::string_view typed, const std::string& name) {
  return edit_distance(typed.substr(0, kLongest), std::string_view(name).substr(0, kLongest));
}

// The dashes of options are no letters.
bool is_near(std::string_view typed, const std::string& name) {
  const std::size_t dashes = std::min(typed.find_first_not_of('-'), typed.size());
  const std::size_t letters = std::min(typed.size(), kLongest) - std::min(dashes, kLongest);
  return distance(typed, name) <= std::max<std::size_t>(1, letters / 3);
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMostListed); ++i)
    text += (i == 0 ? "" : ", ") + in_quotes(names[i]);
  return names.size() > kMostListed ? text + ", ..." : text;
}

}  // namespace

std::string nearest_name(std::string_view typed, const std::vector<std::string>& names) {
  const auto nearest = std::min_element(
      names.begin(), names.end(),
      [&](const std::string& a, const std::string& b) { return distance(typed, a) < distance(typed, b); });
  return nearest == names.end() ? std::string() : *nearest;
}

std::string suggestion(std::string_view typed, const std::vector<std::string>& names,
                       const std::string& where_to_look) {
  const std::string nearest = nearest_name(typed, names);
  if (!names.empty() && is_near(typed, nearest)) return ", did you mean " + in_quotes(nearest) + "?";
  if (!where_to_look.empty()) return "; " + where_to_look;
  return names.empty() ? "; there are none" : "; known: " + listed(names);
}

}  // namespace caustics
