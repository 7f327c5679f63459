// The one exception of the project: bad input, a missing backend, an output that cannot be written.
#pragma once
#include <stdexcept>
#include <string>

namespace caustics {

// The program's documented exit codes (docs/command_line.md).
enum class ExitCode : int {
  Done = 0,
  AnswerIsNo = 1,
  WrongUsage = 2,
  BadInput = 3,
  CannotWrite = 4,
  BackendUnavailable = 5,
  TargetMissed = 6,
  NumericFault = 7,
  InternalError = 70,
  Interrupted = 130,
  Terminated = 143,
};

// Says in one line what is wrong, where, and what to do. `code` is what the program exits with.
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& line) : std::runtime_error(line), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

}  // namespace caustics
