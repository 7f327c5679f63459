// The program: finds the sub-command and runs it.
#include <cstdio>
#include <filesystem>

#include "app/shell/run_program.hpp"
#include "app/shell/terminal.hpp"
#include "app/shell/version.hpp"
#include "pipeline/settings/nearest.hpp"

namespace caustics::app {

namespace {

constexpr Command kCommands[] = {
    {"render", "render a scene to a picture (the default: caustics SCENE)", run_render},
    {"plan", "what a scene holds, which passes run, and which caustics to expect",
     run_plan_command},
    {"probe", "follow one ray: every intermediate value of one grid vertex", run_probe},
    {"digest", "hash of every attachment of every pass", run_digest},
    {"parity", "draw every pass on both backends, and compare", run_parity},
    {"reference", "the truth to measure render against, traced ray by ray from the lights", run_reference},
    {"compare", "two images in values and figures, or two dumps of all passes", run_compare},
    {"study", "error against time over many settings, and which of them nothing beats", run_study},
    {"paper", "the effects of Caustics Mapping (2007) made again, each with its check", run_paper},
    {"doctor", "version, instruction sets, threads, OpenGL devices, libraries", run_doctor},
};

void print_help() {
  std::printf(
      "caustics renders the light patterns that glass and water throw onto other surfaces.\n"
      "\n"
      "Examples:\n"
      "  caustics scene.glb                              writes scene.png, 1280x720\n"
      "  caustics render scene.glb -o out.exr -r 640x360\n"
      "  caustics plan scene.glb                         why is there a caustic, or none?\n"
      "\n"
      "Commands:\n");
  for (const Command& command : kCommands) {
    std::printf("  %-9s %s\n", command.name, command.summary);
  }
  std::printf(
      "\n"
      "Options:\n"
      "  -h, --help   this text; 'caustics COMMAND --help' explains a command\n"
      "  --version    version and build\n"
      "\n"
      "Exit codes: 0 done, 1 the answer is no (compare), 2 wrong usage, 3 input unreadable,\n"
      "  4 cannot write, 5 no such backend, 6 error target missed (reference), 7 numeric fault,\n"
      "  70 internal error, 130 interrupted, 143 terminated.\n");
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
    print_help();
    return ExitCode::Done;
  }
  if (first == "--version") {
    std::printf("%s\n", version_line().c_str());
    return ExitCode::Done;
  }
  if (first == "help") return dispatch({arguments[1], "--help"});
  for (const Command& command : kCommands) {
    if (first == command.name) return command.run({arguments.begin() + 1, arguments.end()});
  }
  if (looks_like_command(first)) {
    std::vector<std::string> names;
    for (const Command& command : kCommands) names.emplace_back(command.name);
    throw Error(ExitCode::WrongUsage, "no command or file '" + one_line(first) +
                                          "'; the nearest command is '" +
                                          nearest_name(first, names) + "'");
  }
  return run_render(arguments);
}

}  // namespace

}  // namespace caustics::app

int main(int count, char** values) { return caustics::app::run_program(count, values, caustics::app::dispatch); }
