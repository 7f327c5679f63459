#include "app/shell/help_page.hpp"

#include <algorithm>
#include <sstream>

namespace caustics::app {

namespace {

constexpr std::size_t kWidth = 110, kOptionColumn = 34;

std::string left_of(const HelpEntry& entry) {
  return "  " + entry.names + (entry.value.empty() ? "" : " " + entry.value);
}

// "meaning; range (default x)".
std::string right_of(const About& about) {
  std::string text = about.meaning;
  if (!about.range.empty()) text += (text.empty() ? "" : "; ") + about.range;
  if (!about.by_default.empty()) text += (text.empty() ? "(default " : " (default ") + about.by_default + ")";
  return text;
}

std::string line(const HelpEntry& entry, std::size_t column) {
  std::string text = left_of(entry);
  if (text.size() + 1 > column) {
    text += "\n" + std::string(column, ' ');
  } else {
    text.resize(column, ' ');
  }
  return text + wrapped(right_of(entry.about), column, column) + "\n";
}

std::string section(const HelpGroup& group, std::size_t column) {
  std::string text = "\n" + group.heading + ":\n";
  for (const HelpEntry& entry : group.entries) text += line(entry, column);
  return text;
}

std::size_t column_of(const HelpGroup& list) {
  std::size_t widest = 0;
  for (const HelpEntry& entry : list.entries) widest = std::max(widest, left_of(entry).size());
  return widest + 2;
}

// Of a cell: a bar would end it.
std::string escaped(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, 1, '\\');
  return text;
}

std::string code(const std::string& text) { return text.empty() ? "" : "`" + escaped(text) + "`"; }

// "-o,--output" FILE -> `-o`, `--output FILE`.
std::string names_cell(const HelpEntry& entry) {
  const std::size_t comma = entry.names.find(',');
  const std::string last = comma == std::string::npos ? entry.names : entry.names.substr(comma + 1);
  const std::string before = comma == std::string::npos ? "" : code(entry.names.substr(0, comma)) + ", ";
  return before + code(last + (entry.value.empty() ? "" : " " + entry.value));
}

// "1..8192 texels (512)".
std::string range_cell(const About& about) {
  const bool both = !about.range.empty() && !about.by_default.empty();
  return escaped(about.range + (both ? " " : "") +
                 (about.by_default.empty() ? "" : "(" + about.by_default + ")"));
}

// Its heading stands in the first cell.
std::string table(const HelpGroup& group) {
  const bool ranges = std::any_of(group.entries.begin(), group.entries.end(),
                                  [](const HelpEntry& e) { return !range_cell(e.about).empty(); });
  std::string text = "\n| " + group.heading + (ranges ? " | range (default)" : "") + " | meaning |\n|---|" +
                     (ranges ? "---|" : "") + "---|\n";
  for (const HelpEntry& entry : group.entries)
    text += "| " + names_cell(entry) + " | " + (ranges ? range_cell(entry.about) + " | " : "") +
            escaped(entry.about.meaning) + " |\n";
  return text;
}

}  // namespace

std::string wrapped(const std::string& words, std::size_t indent, std::size_t first) {
  std::string text, word;
  std::size_t used = first;
  for (std::istringstream rest(words); rest >> word; used += word.size()) {
    const bool begins = text.empty() || text.back() == ' ';
    if (used + word.size() + 1 > kWidth && !begins) {
      text += "\n" + std::string(indent, ' ');
      used = indent;
    } else if (!text.empty()) {
      text += ' ';
      ++used;
    }
    text += word;
  }
  return text;
}

void HelpPage::add(std::vector<HelpGroup>& groups, const std::string& heading, HelpEntry entry) {
  auto found =
      std::find_if(groups.begin(), groups.end(), [&](const HelpGroup& g) { return g.heading == heading; });
  if (found == groups.end()) found = groups.insert(groups.end(), {heading, {}});
  found->entries.push_back(std::move(entry));
}

std::string HelpPage::text() const {
  std::string text = purpose + "\n\nExamples:\n" + examples + "\nUsage: caustics " + command + " [OPTIONS]";
  for (const HelpEntry& entry : positionals) text += " [" + entry.names + "]";
  text += "\n";
  if (!positionals.empty()) text += section({"Arguments", positionals}, kOptionColumn);
  text += section({"Help", {{"-h,--help", "", {"this text; --help-markdown: its tables as Markdown"}}}},
                  kOptionColumn);
  for (const HelpGroup& group : groups) text += section(group, kOptionColumn);
  for (const HelpGroup& list : lists) text += section(list, column_of(list));
  return text + (footer.empty() ? "" : "\n" + footer + "\n");
}

std::string HelpPage::markdown() const {
  std::string text = purpose + "\n";
  for (const HelpGroup& group : groups) text += table(group);
  for (const HelpGroup& list : lists) text += table(list);
  return text;
}

}  // namespace caustics::app
