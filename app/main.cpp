// The program: finds the sub-command and runs it.
#include <cstdio>
#include <filesystem>

#include "app/commands.hpp"
#include "app/shell/run_program.hpp"
#include "app/shell/terminal.hpp"
#include "app/shell/version.hpp"
#include "gl_backend/gl_device.hpp"
#include "pipeline/settings/nearest.hpp"
#include "raster/software_device.hpp"

namespace caustics::app {

namespace {

// The program, and the backends that work here.
std::string version_text() {
  std::string text = version_line() + "\nsoftware: " + make_software_device({})->description() + "\nOpenGL: ";
  try {
    const auto gl = caustics::make_gl_device();
    return text + gl->renderer() + ", " + gl->version() + "\n";
  } catch (const Error& error) {
    return text + error.what() + "\n";
  }
}

// A word that can only have been meant as a command: not an option, nor anything like a file's
// name.
bool looks_like_command(const std::string& word) {
  std::error_code ignored;
  return !word.empty() && word[0] != '-' && word.find_first_of("./\\") == std::string::npos &&
         !std::filesystem::exists(word, ignored);
}

ExitCode dispatch(const Arguments& arguments) {
  if (arguments.empty()) {
    throw Error(ExitCode::WrongUsage, "no scene given; try 'caustics SCENE' or 'caustics --help'");
  }
  const std::string& first = arguments.front();
  if (first == "--help" || first == "-h" || (first == "help" && arguments.size() == 1)) {
    std::fputs(program_help().text().c_str(), stdout);
    return ExitCode::Done;
  }
  if (first == "--help-markdown") {
    std::fputs(program_help().markdown().c_str(), stdout);
    return ExitCode::Done;
  }
  if (first == "--version" || first == "-V") {
    std::fputs(version_text().c_str(), stdout);
    return ExitCode::Done;
  }
  if (first == "help") return dispatch({arguments[1], "--help"});
  for (const Command& command : all_commands()) {
    if (first == command.name) return command.run({arguments.begin() + 1, arguments.end()});
  }
  if (looks_like_command(first)) {
    std::vector<std::string> names;
    for (const Command& command : all_commands()) names.emplace_back(command.name);
    throw Error(ExitCode::WrongUsage, "no command or file '" + one_line(first) + "'" +
                                          suggestion(first, names, "see 'caustics --help'"));
  }
  return run_render(arguments);
}

}  // namespace

}  // namespace caustics::app

int main(int count, char** values) {
  return caustics::app::run_program(count, values, caustics::app::dispatch);
}
