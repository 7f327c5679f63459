// What every program here does around its work: signals, and one line and an exit code for whatever is
// thrown.
#pragma once
#include <functional>

#include "app/shell/command.hpp"

namespace caustics::app {

// Calls `work` with the arguments; gives what main returns.
int run_program(int count, char** values, ExitCode (*work)(const Arguments& arguments));

// Does the work; gives its exit code, and says on stderr what was thrown.
int report_errors(const std::function<ExitCode()>& work);

}  // namespace caustics::app
