#include "app/completion/completed.hpp"

namespace caustics::app {

namespace {

std::string fish_text(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return result + "'";
}

std::string words(const CompletedCommand& command, const CompletedOption& option) {
  switch (option.takes) {
    case Takes::Nothing:
      return "";
    case Takes::Value:
      return " -x";
    case Takes::Path:
      return " -r -F";
    case Takes::Word:
      return " -x -a " + fish_text(joined_words(option.words));
    case Takes::List:
      return " -x -a " + fish_text("(__fish_append , " + joined_words(option.words) + ")");
    case Takes::Key:
      break;
  }
  std::vector<std::string> pairs;
  for (const CompletedKey& key : command.keys) {
    if (key.words.empty()) pairs.push_back(key.name + "=");
    for (const std::string& word : key.words) pairs.push_back(key.name + "=" + word);
  }
  return " -x -a " + fish_text(joined_words(pairs));
}

std::string line(const CompletedCommand& command, const std::string& when, const CompletedOption& option) {
  std::string text = "complete -c caustics -n " + fish_text(when);
  for (const std::string& name : option.names)
    text += name.rfind("--", 0) == 0 ? " -l " + name.substr(2) : " -s " + name.substr(1);
  return text + words(command, option) + " -d " + fish_text(option.meaning) + "\n";
}

}  // namespace

std::string fish_completion(const std::vector<CompletedCommand>& commands) {
  std::string text = "# As 'caustics completion fish' prints it: ~/.config/fish/completions/caustics.fish\n";
  std::vector<std::string> others;
  for (std::size_t i = 1; i < commands.size(); ++i) others.push_back(commands[i].name);
  for (const CompletedCommand& command : commands)
    text += "complete -c caustics -n __fish_use_subcommand -a " + command.name + " -d " +
            fish_text(command.summary) + "\n";
  for (const CompletedCommand& command : commands) {
    const std::string when = &command == &commands.front()
                                 ? "not __fish_seen_subcommand_from " + joined_words(others)
                                 : "__fish_seen_subcommand_from " + command.name;
    for (const CompletedOption& option : command.options) text += line(command, when, option);
    if (!command.operands.empty())
      text += "complete -c caustics -n " + fish_text(when) + " -f -a " +
              fish_text(joined_words(command.operands)) + "\n";
  }
  return text;
}

}  // namespace caustics::app
