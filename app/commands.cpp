#include "app/commands.hpp"

#include <utility>

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
    {"completion", "completion for shells, and the man page", run_completion},
};

constexpr std::pair<ExitCode, const char*> kExitCodes[] = {
    {ExitCode::Done, "done"},
    {ExitCode::AnswerIsNo,
     "the answer is no: compare, parity or bench found a difference, a figure is above --fail-above, a row "
     "of "
     "paper does not hold"},
    {ExitCode::WrongUsage,
     "wrong usage: unknown word, value out of range, outputs that clash, sizes or scene beyond this "
     "machine's "
     "memory"},
    {ExitCode::BadInput, "input unreadable or unsupported"},
    {ExitCode::CannotWrite, "an output cannot be written"},
    {ExitCode::BackendUnavailable,
     "no such backend here: no driver, too old a driver, no such device, no Embree; the line names the way "
     "on"},
    {ExitCode::TargetMissed,
     "the error or the time that was asked for was missed (render, reference); the picture is written"},
    {ExitCode::NumericFault,
     "numeric fault: the picture would hold a NaN, an infinity, or more light than the scene's lights can "
     "give; its pixel is named, no picture is written"},
    {ExitCode::InternalError, "internal error"},
    {ExitCode::Interrupted, "interrupted (SIGINT)"},
    {ExitCode::Terminated, "terminated (SIGTERM)"},
};

}  // namespace

std::span<const Command> all_commands() { return kCommands; }

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

}  // namespace caustics::app
