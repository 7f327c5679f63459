#include "app/completion/completed.hpp"

namespace caustics::app {

namespace {

// In single quotes, and with what _arguments reads in a description marked as plain.
std::string zsh_text(const std::string& text) {
  std::string plain;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') plain += '\\';
    plain += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return plain;
}

std::string action(const CompletedCommand& command, const CompletedOption& option) {
  switch (option.takes) {
    case Takes::Nothing:
      return "";
    case Takes::Value:
      return ":" + zsh_text(option.value) + ": ";
    case Takes::Path:
      return ":" + zsh_text(option.value) + ":_files";
    case Takes::Word:
      return ":" + zsh_text(option.value) + ":(" + joined_words(option.words) + ")";
    case Takes::List:
      return ":" + zsh_text(option.value) + ":_values -s , " + zsh_text(option.value) + " " +
             joined_words(option.words);
    case Takes::Key:
      break;
  }
  return ":" + zsh_text(option.value) + ":_caustics_" + command.name + "_keys";
}

// KEY=VALUE of -D.
std::string key_function(const CompletedCommand& command) {
  if (command.keys.empty()) return {};
  std::string text = "_caustics_" + command.name + "_keys() {\n  _values setting";
  for (const CompletedKey& key : command.keys) {
    const std::string values = key.words.empty() ? " " : "(" + joined_words(key.words) + ")";
    text += " \\\n    '" + key.name + ":value:" + values + "'";
  }
  return text + "\n}\n";
}

std::string specification(const CompletedCommand& command, const CompletedOption& option) {
  const std::string rest = "'[" + zsh_text(option.meaning) + "]" + action(command, option) + "'";
  if (option.names.size() == 1) return "'*'" + option.names[0] + rest;
  return "'*'{" + joined_words(option.names, ",") + "}" + rest;
}

}  // namespace

std::string zsh_completion(const std::vector<CompletedCommand>& commands) {
  std::string text =
      "#compdef caustics\n"
      "# As 'caustics completion zsh' prints it: a file _caustics in a folder of $fpath.\n";
  for (const CompletedCommand& command : commands) text += key_function(command);
  text += "_caustics() {\n  local -a commands\n  commands=(\n";
  for (const CompletedCommand& command : commands)
    text += "    '" + command.name + ":" + zsh_text(command.summary) + "'\n";
  text +=
      "  )\n  if ((CURRENT == 2)) && [[ $words[2] != -* ]]; then\n"
      "    _describe command commands\n    _files\n    return\n  fi\n"
      "  local command=" +
      commands.front().name +
      "\n  if (($#commands[(r)$words[2]:*])); then\n"
      "    command=$words[2]\n    shift words\n    ((CURRENT--))\n  fi\n  case $command in\n";
  for (const CompletedCommand& command : commands) {
    text += "    " + command.name + ")\n      _arguments -s";
    for (const CompletedOption& option : command.options)
      text += " \\\n        " + specification(command, option);
    text += command.operands.empty() ? " \\\n        '*:file:_files'"
                                     : " \\\n        '1:word:(" + joined_words(command.operands) + ")'";
    text += "\n      ;;\n";
  }
  return text +
         "  esac\n}\nif [[ $funcstack[1] == _caustics ]]; then _caustics \"$@\"; else compdef _caustics "
         "caustics; fi\n";
}

}  // namespace caustics::app
