// The sub-commands of `caustics`, one file each.
#pragma once
#include <string>
#include <vector>

#include "pipeline/gpu/error.hpp"

namespace caustics::app {

// What follows the sub-command's name.
using Arguments = std::vector<std::string>;

struct Command {
  const char* name;
  const char* summary;
  ExitCode (*run)(const Arguments& arguments);
};

// Each throws Error, or returns Done (AnswerIsNo where the command asks a question).
ExitCode run_render(const Arguments& arguments);
ExitCode run_plan_command(const Arguments& arguments);
ExitCode run_probe(const Arguments& arguments);
ExitCode run_inspect(const Arguments& arguments);
ExitCode run_digest(const Arguments& arguments);
ExitCode run_parity(const Arguments& arguments);
ExitCode run_bench(const Arguments& arguments);
ExitCode run_reference(const Arguments& arguments);
ExitCode run_compare(const Arguments& arguments);
ExitCode run_study(const Arguments& arguments);
ExitCode run_paper(const Arguments& arguments);
ExitCode run_doctor(const Arguments& arguments);
ExitCode run_completion(const Arguments& arguments);

}  // namespace caustics::app
