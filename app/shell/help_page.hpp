// What a sub-command's help says: the text for a terminal, and the same as Markdown for docs/command_line.md.
#pragma once
#include <string>
#include <vector>

namespace caustics::app {

// What is said of an option, a setting, a layer. Parts that do not apply are empty.
struct About {
  std::string meaning;
  std::string range = {};
  std::string by_default = {};
};

struct HelpEntry {
  std::string names;  // "-o,--output"
  std::string value;  // "FILE"
  About about;
};

struct HelpGroup {
  std::string heading;
  std::vector<HelpEntry> entries;
};

struct HelpPage {
  std::string command, purpose, examples;
  std::vector<HelpEntry> positionals;
  std::vector<HelpGroup> groups;  // of options
  std::vector<HelpGroup> lists;   // what options name: layers, settings
  std::string footer;

  // Adds to the group of this heading, which is made where it is missing.
  static void add(std::vector<HelpGroup>& groups, const std::string& heading, HelpEntry entry);

  std::string text() const;
  // The purpose, and a table for each group and list, with blank lines between.
  std::string markdown() const;
};

// Words in lines of at most 110 columns; all lines but the first begin with `indent` blanks, and `first`
// columns of that one are taken.
std::string wrapped(const std::string& words, std::size_t indent, std::size_t first);

}  // namespace caustics::app
