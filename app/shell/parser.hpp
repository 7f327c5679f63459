// One sub-command's options, on top of CLI11: examples come first in the help, values are checked
// by the code that uses them, and a misspelt option names the one that was probably meant.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/shell/command.hpp"

namespace CLI {
class App;
}

namespace caustics::app {

class Parser {
 public:
  Parser(const std::string& command, const std::string& purpose, const std::string& examples);
  Parser(const Parser&) = delete;
  Parser& operator=(const Parser&) = delete;
  ~Parser();

  void flag(const std::string& names, bool& target, const std::string& help);
  // An option with a value; the last of several counts.
  void option(const std::string& names, const std::string& value_name, const std::string& help,
              const std::function<void(const std::string&)>& use);
  // An option that may stand several times.
  void repeated(const std::string& names, const std::string& value_name, const std::string& help,
                const std::function<void(const std::string&)>& use);
  void positional(const std::string& name, const std::string& help, std::string& target);
  void positionals(const std::string& name, const std::string& help,
                   std::vector<std::string>& target);
  // Options added from here on are listed under this heading.
  void group(const std::string& heading) { group_ = heading; }
  // Adds lines to the end of the help.
  void footer(const std::string& text);

  // False when the help was asked for and printed. Throws Error (WrongUsage).
  bool parse(const Arguments& arguments);

 private:
  void refuse_extras() const;

  std::unique_ptr<CLI::App> app_;
  std::string command_;
  std::string group_ = "Options";
};

// The whole text as an integer within the range; throws Error (WrongUsage) that names the option.
int parse_integer(const std::string& option, const std::string& text, int least, int most);
// Likewise a decimal number.
double parse_real(const std::string& option, const std::string& text, double least, double most);
// "640x360" or "640,360", each within the range.
struct Pair {
  int first = 0, second = 0;
};
Pair parse_pair(const std::string& option, const std::string& text, int least, int most);

}  // namespace caustics::app
