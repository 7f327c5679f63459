#include "app/completion/completed.hpp"

namespace caustics::app {

namespace {

// "render,-D|render,--vary"
std::string pattern(const CompletedCommand& command, const CompletedOption& option) {
  return command.name + "," + joined_words(option.names, ("|" + command.name + ",").c_str());
}

std::string branch(const CompletedCommand& command, const CompletedOption& option) {
  const std::string text = "    " + pattern(command, option) + ") ";
  switch (option.takes) {
    case Takes::Nothing:
      return {};
    case Takes::Value:
      return text + "_caustics_nothing ;;\n";
    case Takes::Path:
      return text + ";;\n";
    case Takes::Word:
      return text + "_caustics_words '" + joined_words(option.words) + "' ;;\n";
    case Takes::List:
      return text + "_caustics_list '" + joined_words(option.words) + "' ;;\n";
    case Takes::Key:
      break;
  }
  std::string keys;
  for (const CompletedKey& key : command.keys) keys += (keys.empty() ? "" : "= ") + key.name;
  return text + "_caustics_key '" + keys + "=' ;;\n";
}

// Behind -D KEY the shell sees KEY, = and VALUE as three words.
std::string branch(const CompletedCommand& command, const CompletedKey& key) {
  const std::string does =
      key.words.empty() ? "_caustics_nothing" : "_caustics_words '" + joined_words(key.words) + "'";
  return "    " + command.name + "," + key.name + ") " + does + " ;;\n";
}

std::string otherwise(const CompletedCommand& command) {
  std::string names;
  for (const CompletedOption& option : command.options) names += joined_words(option.names) + " ";
  std::string text =
      "    " + command.name + ",*)\n      if [[ $cur == -* ]]; then _caustics_words '" + names + "'; ";
  if (!command.operands.empty()) text += "else _caustics_words '" + joined_words(command.operands) + "'; ";
  return text + "fi ;;\n";
}

constexpr char kHead[] =
    R"(# bash completion for caustics, as 'caustics completion bash' prints it. To use it:
#   source <(caustics completion bash)
_caustics_words() { COMPREPLY=($(compgen -W "$1" -- "$cur")); }
_caustics_nothing() { compopt +o default 2> /dev/null || true; }
_caustics_list() {
  local before=${cur%"${cur##*,}"}
  COMPREPLY=($(compgen -P "$before" -W "$1" -- "${cur##*,}"))
}
_caustics_key() {
  _caustics_words "$1"
  compopt -o nospace 2> /dev/null || true
}
_caustics() {
  local cur=${COMP_WORDS[COMP_CWORD]} option=${COMP_WORDS[COMP_CWORD - 1]} command=COMMANDS0
  COMPREPLY=()
  if [[ $cur == = ]]; then
    cur=
  elif [[ $option == = ]]; then
    option=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  case " COMMANDS " in *" ${COMP_WORDS[1]} "*) ((COMP_CWORD > 1)) && command=${COMP_WORDS[1]} ;; esac
  if ((COMP_CWORD == 1)) && [[ $cur != -* ]]; then
    _caustics_words 'COMMANDS'
    local files
    mapfile -t files < <(compgen -f -- "$cur")
    COMPREPLY+=("${files[@]}")
    compopt -o filenames 2> /dev/null || true
    return
  fi
  case $command,$option in
)";

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

}  // namespace

std::string bash_completion(const std::vector<CompletedCommand>& commands) {
  std::string names, branches;
  for (const CompletedCommand& command : commands) {
    names += (names.empty() ? "" : " ") + command.name;
    for (const CompletedOption& option : command.options) branches += branch(command, option);
    for (const CompletedKey& key : command.keys) branches += branch(command, key);
    branches += otherwise(command);
  }
  std::string text = kHead;
  replace_all(text, "COMMANDS0", commands.front().name);
  replace_all(text, "COMMANDS", names);
  return text + branches + "  esac\n}\ncomplete -o default -F _caustics caustics\n";
}

}  // namespace caustics::app
