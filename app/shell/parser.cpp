#include "app/shell/parser.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <utility>

#include "app/shell/terminal.hpp"
#include "pipeline/settings/nearest.hpp"

namespace caustics::app {

namespace {

// CLI11's help, in the order that people read: what for, examples, usage, options.
class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter() { column_width(34); }
  std::string make_option_opts(const CLI::Option* option) const override {
    return option->get_type_size() == 0 ? "" : " " + option->get_type_name();
  }
};

// CLI11 leaves two blank lines between groups.
std::string single_spaced(std::string text) {
  for (std::size_t at; (at = text.find("\n\n\n")) != std::string::npos;) text.erase(at, 1);
  return text;
}

std::string in_quotes(const std::string& text) { return "'" + one_line(text).substr(0, 80) + "'"; }

}  // namespace

Parser::Parser(const std::string& command, const std::string& purpose, const std::string& examples)
    : app_(std::make_unique<CLI::App>(purpose + "\n\nExamples:\n" + examples)), command_(command) {
  app_->name("caustics " + command);
  app_->formatter(std::make_shared<HelpFormatter>());
  app_->set_help_flag("-h,--help", "this text");
  app_->allow_extras();
}

Parser::~Parser() = default;

void Parser::footer(const std::string& text) {
  app_->footer(app_->get_footer().empty() ? text : app_->get_footer() + "\n" + text);
}

void Parser::flag(const std::string& names, bool& target, const std::string& help) {
  app_->add_flag(names, target, help)->group(group_);
}

void Parser::option(const std::string& names, const std::string& value_name,
                    const std::string& help, const std::function<void(const std::string&)>& use) {
  app_->add_option_function<std::string>(names, use, help)
      ->type_name(value_name)
      ->group(group_)
      ->take_last();
}

void Parser::repeated(const std::string& names, const std::string& value_name,
                      const std::string& help, const std::function<void(const std::string&)>& use) {
  app_->add_option_function<std::vector<std::string>>(
          names,
          [use](const std::vector<std::string>& values) {
            for (const std::string& value : values) use(value);
          },
          help)
      ->type_name(value_name)
      ->group(group_)
      ->expected(1, 1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false);
}

void Parser::positional(const std::string& name, const std::string& help, std::string& target) {
  app_->add_option(name, target, help)->type_name("FILE");
}

void Parser::positionals(const std::string& name, const std::string& help,
                         std::vector<std::string>& target) {
  app_->add_option(name, target, help)->type_name("FILE ...");
}

void Parser::refuse_extras() const {
  for (const std::string& extra : app_->remaining()) {
    if (extra.size() < 2 || extra[0] != '-') continue;
    std::vector<std::string> names;
    for (const CLI::Option* option : app_->get_options()) {
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    const std::string typed = extra.substr(0, extra.find('='));
    throw Error(ExitCode::WrongUsage, "unknown option " + in_quotes(typed) + ", did you mean '" +
                                          nearest_name(typed, names) + "'?");
  }
  if (!app_->remaining().empty()) {
    throw Error(ExitCode::WrongUsage, "unexpected argument " + in_quotes(app_->remaining().front()) +
                                          "; see 'caustics " + command_ + " --help'");
  }
}

bool Parser::parse(const Arguments& arguments) {
  try {
    // CLI11 takes the arguments last first.
    app_->parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::CallForHelp&) {
    std::fputs(single_spaced(app_->help()).c_str(), stdout);
    return false;
  } catch (const CLI::ParseError& error) {
    refuse_extras();
    throw Error(ExitCode::WrongUsage, error.what());
  }
  refuse_extras();
  return true;
}

int parse_integer(const std::string& option, const std::string& text, int least, int most) {
  int value = 0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc{} || result.ptr != end || value < least || value > most) {
    throw Error(ExitCode::WrongUsage, option + " cannot be " + in_quotes(text) +
                                          ": an integer in " + std::to_string(least) + ".." +
                                          std::to_string(most));
  }
  return value;
}

double parse_real(const std::string& option, const std::string& text, double least, double most) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc{} || result.ptr != end || !(value >= least && value <= most)) {
    throw Error(ExitCode::WrongUsage, option + " cannot be " + in_quotes(text) +
                                          ": a number in " + significant(least, 6) + ".." +
                                          significant(most, 6));
  }
  return value;
}

Pair parse_pair(const std::string& option, const std::string& text, int least, int most) {
  const std::size_t split = text.find_first_of("x,");
  if (split == std::string::npos) {
    throw Error(ExitCode::WrongUsage,
                option + " cannot be " + in_quotes(text) + ": two integers, as in 640x360");
  }
  return {parse_integer(option, text.substr(0, split), least, most),
          parse_integer(option, text.substr(split + 1), least, most)};
}

}  // namespace caustics::app
