// One sub-command's options, on top of CLI11: what is parsed and what the help says come from the same calls,
// and a misspelt option names the one that was probably meant.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/shell/command.hpp"
#include "app/shell/help_page.hpp"

namespace CLI {
class App;
}

namespace caustics::app {

// Numbers that an option takes.
template <class T>
struct Limits {
  T least, most;
};
std::string text_of(Limits<int> bounds);
std::string text_of(Limits<double> bounds);

// The whole text as a number within the bounds; throws Error (WrongUsage) that names the option.
int parse_number(const std::string& option, const std::string& text, Limits<int> bounds);
double parse_number(const std::string& option, const std::string& text, Limits<double> bounds);
// "5" or "5%": as a share, 0.05. The bounds are in percent.
double parse_percent(const std::string& option, const std::string& text, Limits<double> bounds);
// "640x360" or "640,360", each within the bounds.
struct Pair {
  int first = 0, second = 0;
};
Pair parse_pair(const std::string& option, const std::string& text, Limits<int> bounds);

class Parser {
 public:
  using Use = std::function<void(const std::string& value)>;

  Parser(const std::string& command, const std::string& purpose, const std::string& examples);
  Parser(const Parser&) = delete;
  Parser& operator=(const Parser&) = delete;
  ~Parser();

  void flag(const std::string& names, bool& target, const std::string& meaning);
  void flag(const std::string& names, const std::string& meaning, const std::function<void()>& use);
  // An option with a value; the last of several counts.
  void option(const std::string& names, const std::string& value, const About& about, const Use& use);
  // An option that may stand several times.
  void repeated(const std::string& names, const std::string& value, const About& about, const Use& use);
  // An option that is a number within bounds. Its default is what `target` holds, unless it is said.
  template <class T, class Target>
  void number(const std::string& name, const std::string& value, About about, Limits<T> bounds,
              Target& target);
  void positional(const std::string& name, const std::string& meaning, std::string& target,
                  const std::string& range = "");
  void positionals(const std::string& name, const std::string& meaning, std::vector<std::string>& target);
  // Options added from here on are listed under this heading.
  void group(const std::string& heading) { group_ = heading; }
  // A name that some option takes, explained below the options under this heading.
  void list(const std::string& heading, const std::string& name, const About& about);
  // Adds lines to the end of the help.
  void footer(const std::string& text);

  // False when the help was asked for and printed. Throws Error (WrongUsage).
  bool parse(const Arguments& arguments);

 private:
  void refuse_extras() const;
  std::string help_command() const;
  void say(const std::string& names, const std::string& value, const About& about);

  std::unique_ptr<CLI::App> app_;
  HelpPage page_;
  std::string group_ = "Options";
};

// What the help of a command says, from the calls that build its parser; the command is not run.
HelpPage page_of(const Command& command);

template <class T, class Target>
void Parser::number(const std::string& name, const std::string& value, About about, Limits<T> bounds,
                    Target& target) {
  about.range = text_of(bounds);
  if constexpr (std::is_same_v<T, Target>) {
    if (about.by_default.empty()) about.by_default = text_of(Limits<T>{target, target});
  }
  const std::string last = name.substr(name.find(',') + 1);
  option(name, value, about,
         [&target, bounds, last](const std::string& text) { target = parse_number(last, text, bounds); });
}

}  // namespace caustics::app
