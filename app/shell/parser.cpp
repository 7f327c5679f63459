#include "app/shell/parser.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <utility>

#include "app/shell/terminal.hpp"
#include "pipeline/settings/nearest.hpp"
#include "pipeline/settings/setting.hpp"

namespace caustics::app {

namespace {

// Where the next parser puts what its help says, instead of parsing (page_of); null: it parses.
HelpPage* wanted_page = nullptr;

// "least..most", or one number where they are equal.
std::string span(const std::string& least, const std::string& most) {
  return least == most ? least : least + ".." + most;
}

template <class T>
T parse_within(const std::string& option, const std::string& text, Limits<T> bounds, const char* kind) {
  T value{};
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc{} || result.ptr != end || !(value >= bounds.least && value <= bounds.most)) {
    throw Error(ExitCode::WrongUsage,
                option + " cannot be " + in_quotes(text) + ": " + kind + " in " + text_of(bounds));
  }
  return value;
}

}  // namespace

Parser::Parser(const std::string& command, const std::string& purpose, const std::string& examples)
    : app_(std::make_unique<CLI::App>(purpose)) {
  page_.command = command;
  page_.purpose = purpose;
  page_.examples = examples;
  app_->set_help_flag("-h,--help", "");
  app_->set_help_all_flag("--help-markdown", "");
  app_->allow_extras();
}

Parser::~Parser() = default;

void Parser::footer(const std::string& text) { page_.footer += (page_.footer.empty() ? "" : "\n") + text; }

void Parser::list(const std::string& heading, const std::string& name, const About& about) {
  HelpPage::add(page_.lists, heading, {name, "", about});
}

void Parser::say(const std::string& names, const std::string& value, const About& about) {
  HelpPage::add(page_.groups, group_, {names, value, about});
}

void Parser::flag(const std::string& names, bool& target, const std::string& meaning) {
  app_->add_flag(names, target, meaning);
  say(names, "", {meaning});
}

void Parser::flag(const std::string& names, const std::string& meaning, const std::function<void()>& use) {
  app_->add_flag_callback(names, use, meaning);
  say(names, "", {meaning});
}

void Parser::option(const std::string& names, const std::string& value, const About& about, const Use& use) {
  app_->add_option_function<std::string>(names, use)->type_name(value)->take_last();
  say(names, value, about);
}

void Parser::repeated(const std::string& names, const std::string& value, const About& about,
                      const Use& use) {
  app_->add_option_function<std::vector<std::string>>(names,
                                                      [use](const std::vector<std::string>& values) {
                                                        for (const std::string& each : values) use(each);
                                                      })
      ->type_name(value)
      ->expected(1, 1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false);
  say(names, value, about);
}

void Parser::positional(const std::string& name, const std::string& meaning, std::string& target,
                        const std::string& range) {
  app_->add_option(name, target)->type_name("FILE");
  page_.positionals.push_back({name, "FILE", {meaning, range}});
}

void Parser::positionals(const std::string& name, const std::string& meaning,
                         std::vector<std::string>& target) {
  app_->add_option(name, target)->type_name("FILE ...");
  page_.positionals.push_back({name, "FILE ...", {meaning}});
}

std::string Parser::help_command() const { return "'caustics " + page_.command + " --help'"; }

void Parser::refuse_extras() const {
  for (const std::string& extra : app_->remaining()) {
    if (extra.size() < 2 || extra[0] != '-') continue;
    std::vector<std::string> names;
    for (const CLI::Option* option : app_->get_options()) {
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    const std::string typed = extra.substr(0, extra.find('='));
    throw Error(ExitCode::WrongUsage,
                "unknown option " + in_quotes(typed) + suggestion(typed, names, "see " + help_command()));
  }
  if (!app_->remaining().empty()) {
    throw Error(ExitCode::WrongUsage,
                "unexpected argument " + in_quotes(app_->remaining().front()) + "; see " + help_command());
  }
}

HelpPage page_of(const Command& command) {
  HelpPage page;
  wanted_page = &page;
  command.run({});
  wanted_page = nullptr;
  return page;
}

bool Parser::parse(const Arguments& arguments) {
  if (wanted_page) {
    *wanted_page = page_;
    return false;
  }
  try {
    // CLI11 takes the arguments last first.
    app_->parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::CallForHelp&) {
    std::fputs(page_.text().c_str(), stdout);
    return false;
  } catch (const CLI::CallForAllHelp&) {
    std::fputs(page_.markdown().c_str(), stdout);
    return false;
  } catch (const CLI::ParseError& error) {
    refuse_extras();
    throw Error(ExitCode::WrongUsage, error.what());
  }
  refuse_extras();
  return true;
}

std::string text_of(Limits<int> bounds) {
  return span(std::to_string(bounds.least), std::to_string(bounds.most));
}
std::string text_of(Limits<double> bounds) {
  return span(number_text(bounds.least), number_text(bounds.most));
}

int parse_number(const std::string& option, const std::string& text, Limits<int> bounds) {
  return parse_within(option, text, bounds, "an integer");
}

double parse_number(const std::string& option, const std::string& text, Limits<double> bounds) {
  return parse_within(option, text, bounds, "a number");
}

double parse_percent(const std::string& option, const std::string& text, Limits<double> bounds) {
  return parse_number(option, text.ends_with('%') ? text.substr(0, text.size() - 1) : text, bounds) / 100.0;
}

Pair parse_pair(const std::string& option, const std::string& text, Limits<int> bounds) {
  const std::size_t split = text.find_first_of("x,");
  if (split == std::string::npos) {
    throw Error(ExitCode::WrongUsage,
                option + " cannot be " + in_quotes(text) + ": two integers, as in 640x360");
  }
  return {parse_number(option, text.substr(0, split), bounds),
          parse_number(option, text.substr(split + 1), bounds)};
}

}  // namespace caustics::app
