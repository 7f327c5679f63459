// SIGINT and SIGTERM: the first asks the work to stop at the next pass, a second ends at once.
#pragma once
#include <string>

#include "pipeline/gpu/error.hpp"

namespace caustics::app {

void watch_for_interruption();

// Done, Interrupted or Terminated: the signal received so far.
ExitCode interruption();
// Throws Error with the signal's code when one was received.
void stop_if_interrupted();

// A temporary file that must not outlive the process, even when a second signal ends it.
// Thread-safe against signals only; register and release from one thread.
void register_temporary(const std::string& path);
void release_temporary(const std::string& path);

}  // namespace caustics::app
