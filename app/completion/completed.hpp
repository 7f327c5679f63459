// What can be completed on the command line, as the help has it; and its forms: a script for each shell, and
// the man page.
#pragma once
#include <string>
#include <vector>

#include "app/shell/help_page.hpp"

namespace caustics::app {

// What comes after an option: nothing, a value that only a person knows, a path, or one of `words`; several
// of them with commas between; or KEY=VALUE, of CompletedCommand::keys.
enum class Takes { Nothing, Value, Path, Word, List, Key };

struct CompletedOption {
  std::vector<std::string> names;  // "-o", "--output"
  std::string meaning, value;      // "a picture, ...", "FILE"
  Takes takes = Takes::Nothing;
  std::vector<std::string> words;
};

struct CompletedKey {
  std::string name;
  std::vector<std::string> words;  // its values; empty: a number or text
};

struct CompletedCommand {
  std::string name, summary;
  std::vector<CompletedOption> options;
  std::vector<CompletedKey> keys;
  std::vector<std::string> operands;  // words; empty: files
  HelpPage page;
};

// The first one is what runs without a command's name.
std::vector<CompletedCommand> completed_commands();

std::string bash_completion(const std::vector<CompletedCommand>& commands);
std::string zsh_completion(const std::vector<CompletedCommand>& commands);
std::string fish_completion(const std::vector<CompletedCommand>& commands);
std::string man_page(const std::vector<CompletedCommand>& commands);

// "a b c"
std::string joined_words(const std::vector<std::string>& words, const char* between = " ");

}  // namespace caustics::app
