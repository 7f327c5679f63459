// The program: finds the sub-command and runs it.
#include <cstdio>
#include <filesystem>
#include <utility>

#include "app/shell/help_page.hpp"
#include "app/shell/run_program.hpp"
#include "app/shell/terminal.hpp"
#include "app/shell/version.hpp"
#include "gl_backend/gl_device.hpp"
#include "pipeline/settings/nearest.hpp"
#include "raster/software_device.hpp"

namespace caustics::app {

namespace {

constexpr Command kCommands[] = {
    {"render", "render a scene to a picture (the default: caustics SCENE)", run_render},
    {"plan", "what a scene holds, which passes run, and which caustics to expect", run_plan_command},
    {"inspect", "a page that shows every pass, and where a pixel gets its light", run_inspect},
    {"probe", "one grid vertex, pixel or texel: every value, and where it comes from", run_probe},
    {"digest", "hash of every attachment of every pass", run_digest},
    {"parity", "draw every pass on both backends, and compare", run_parity},
    {"bench", "what each pass of a frame takes, on one backend or both", run_bench},
    {"reference", "the truth to measure render against, traced ray by ray from the lights", run_reference},
    {"compare", "two images in values and figures, or two dumps of all passes", run_compare},
    {"study", "error against time over many settings, and which of them nothing beats", run_study},
    {"paper", "the effects of Caustics Mapping (2007) made again, each with its check", run_paper},
    {"doctor", "version, instruction sets, threads, OpenGL devices, libraries", run_doctor},
};

constexpr std::pair<ExitCode, const char*> kExitCodes[] = {
    {ExitCode::Done, "done"},
    {ExitCode::AnswerIsNo,
     "the answer is no: compare, parity or bench found a difference, a figure is above --fail-above, a row "
     "of "
     "paper does not hold"},
    {ExitCode::WrongUsage,
     "wrong usage: unknown word, value out of range, sizes or scene beyond this machine's memory"},
    {ExitCode::BadInput, "input unreadable or unsupported"},
    {ExitCode::CannotWrite, "an output cannot be written"},
    {ExitCode::BackendUnavailable,
     "no such backend here: no driver, too old a driver, no such device, no Embree; the line names the way "
     "on"},
    {ExitCode::TargetMissed,
     "the error or the time that was asked for was missed (render, reference); the picture is written"},
    {ExitCode::NumericFault,
     "numeric fault: the picture would hold a NaN or an infinity; its pixel is named, no picture is written"},
    {ExitCode::InternalError, "internal error"},
    {ExitCode::Interrupted, "interrupted (SIGINT)"},
    {ExitCode::Terminated, "terminated (SIGTERM)"},
};

HelpPage program_help() {
  HelpPage page{
      .command = "COMMAND",
      .purpose = "caustics renders the light patterns that glass and water throw onto other surfaces.",
      .examples =
          "  caustics scene.glb                              writes scene.png, 1280x720\n"
          "  caustics render scene.glb -o out.exr -r 640x360\n"
          "  caustics plan scene.glb                         why is there a caustic, or none?\n"
          "  caustics render --help                          examples, and every option\n",
      .positionals = {},
      .groups = {{"Options", {{"-V,--version", "", {"version, and the backends that work"}}}}},
      .lists = {{"Commands", {}}, {"Exit codes", {}}},
      .footer = {}};
  for (const Command& command : kCommands)
    page.lists[0].entries.push_back({command.name, "", {command.summary}});
  for (const auto& [code, meaning] : kExitCodes)
    page.lists[1].entries.push_back({std::to_string(static_cast<int>(code)), "", {meaning}});
  return page;
}

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
  for (const Command& command : kCommands) {
    if (first == command.name) return command.run({arguments.begin() + 1, arguments.end()});
  }
  if (looks_like_command(first)) {
    std::vector<std::string> names;
    for (const Command& command : kCommands) names.emplace_back(command.name);
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
