// caustics completion: what a shell needs to complete the program's words, and the man page.
#include <algorithm>
#include <cstdio>
#include <iterator>

#include "app/completion/completed.hpp"
#include "app/shell/parser.hpp"
#include "app/shell/terminal.hpp"
#include "pipeline/gpu/error.hpp"
#include "pipeline/settings/nearest.hpp"

namespace caustics::app {

namespace {

struct Form {
  const char* name;
  std::string (*text)(const std::vector<CompletedCommand>& commands);
};

constexpr Form kForms[] = {
    {"bash", bash_completion}, {"zsh", zsh_completion}, {"fish", fish_completion}, {"man", man_page}};

std::vector<std::string> form_names() {
  std::vector<std::string> names;
  for (const Form& form : kForms) names.emplace_back(form.name);
  return names;
}

}  // namespace

ExitCode run_completion(const Arguments& arguments) {
  Parser parser("completion",
                "Prints what completes commands, options and their values in a shell, or the man page.",
                "  source <(caustics completion bash)\n"
                "  caustics completion fish > ~/.config/fish/completions/caustics.fish\n"
                "  caustics completion man | man -l -\n");
  std::string wanted;
  parser.positional("SHELL", "a shell's script, or the man page", wanted, joined_words(form_names(), "|"));
  if (!parser.parse(arguments)) return ExitCode::Done;
  const Form* form = std::find_if(std::begin(kForms), std::end(kForms),
                                  [&](const Form& each) { return each.name == wanted; });
  if (wanted.empty())
    throw Error(ExitCode::WrongUsage, "completion of what? " + joined_words(form_names(), ", "));
  if (form == std::end(kForms))
    throw Error(ExitCode::WrongUsage,
                "no completion for " + in_quotes(wanted) + suggestion(wanted, form_names()));
  std::fputs(form->text(completed_commands()).c_str(), stdout);
  return ExitCode::Done;
}

}  // namespace caustics::app
