// Work in a process of its own, with an environment, a peak of memory and threads of its own.
#pragma once
#include <functional>
#include <string>

#include "pipeline/gpu/error.hpp"

namespace caustics::app {

struct Answer {
  ExitCode code = ExitCode::Done;
  std::string text;
};

// The answer of the work; where it throws, what it threw stands on stderr, the code is that of the error and
// the text is empty. To be called before this process has threads. Ctrl-C ends the work as it ends this
// program.
Answer in_own_process(const std::function<Answer()>& work);

}  // namespace caustics::app
