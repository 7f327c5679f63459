#include "app/completion/completed.hpp"

#include <algorithm>

#include "app/commands.hpp"
#include "app/shell/parser.hpp"
#include "app/shell/setting_options.hpp"

namespace caustics::app {

namespace {

std::vector<std::string> parts(const std::string& text, char between) {
  std::vector<std::string> list;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(between, start), text.size());
    list.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return list;
}

// The words of a range such as "auto|1|2", and none of a range such as "1..8192 texels": what stands in
// capitals is for a person to fill in.
std::vector<std::string> words_of(const std::string& range, bool one_will_do) {
  std::vector<std::string> words;
  if (!one_will_do && range.find('|') == std::string::npos) return words;
  for (const std::string& word : parts(range, '|')) {
    const bool is_word = !word.empty() && std::all_of(word.begin(), word.end(), [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    });
    if (is_word) words.push_back(word);
  }
  return words;
}

// The names of the list whose heading says that it is for this option.
std::vector<std::string> listed_for(const HelpPage& page, const std::string& option) {
  std::vector<std::string> names;
  for (const HelpGroup& list : page.lists) {
    const std::string heading = list.heading + ",";
    if (heading.find(" for " + option + ",") == std::string::npos) continue;
    for (const HelpEntry& entry : list.entries) names.push_back(entry.names);
  }
  return names;
}

Takes taken(const CompletedOption& option) {
  const auto begins = [&](const char* text) { return option.value.rfind(text, 0) == 0; };
  if (option.value.empty()) return Takes::Nothing;
  if (begins("KEY=")) return Takes::Key;
  if (option.value == "LIST" && !option.words.empty()) return Takes::List;
  if (begins("FILE") || begins("F.") || begins("DIR") || begins("PREFIX")) return Takes::Path;
  return option.words.empty() ? Takes::Value : Takes::Word;
}

CompletedOption option_of(const HelpPage& page, const HelpEntry& entry) {
  CompletedOption option{parts(entry.names, ','), entry.about.meaning, entry.value, Takes::Nothing, {}};
  option.words = entry.value == "LIST" ? listed_for(page, option.names.back())
                                       : words_of(entry.about.range, entry.value == "NAME");
  option.takes = taken(option);
  return option;
}

// Of -D: the listed settings, and those that have options of their own.
std::vector<CompletedKey> keys_of(const CompletedCommand& command) {
  const std::vector<std::string> listed = listed_for(command.page, "-D");
  std::vector<CompletedKey> keys;
  for (const Setting& row : all_settings()) {
    const std::string option = option_name(row.name);
    const bool known = std::find(listed.begin(), listed.end(), row.name) != listed.end() ||
                       std::any_of(command.options.begin(), command.options.end(),
                                   [&](const CompletedOption& each) { return each.names.back() == option; });
    if (known && !listed.empty()) keys.push_back({std::string(row.name), words_of(row.range(), false)});
  }
  return keys;
}

}  // namespace

std::vector<CompletedCommand> completed_commands() {
  std::vector<CompletedCommand> commands;
  for (const Command& each : all_commands()) {
    CompletedCommand command{each.name, each.summary, {}, {}, {}, page_of(each)};
    for (const HelpGroup& group : command.page.groups)
      for (const HelpEntry& entry : group.entries) command.options.push_back(option_of(command.page, entry));
    command.options.push_back({{"-h", "--help"}, "its help", "", Takes::Nothing, {}});
    command.keys = keys_of(command);
    for (const HelpEntry& operand : command.page.positionals)
      command.operands = words_of(operand.about.range, false);
    commands.push_back(std::move(command));
  }
  return commands;
}

std::string joined_words(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

}  // namespace caustics::app
