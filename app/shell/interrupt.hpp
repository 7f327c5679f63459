// SIGINT and SIGTERM: the first asks the work to stop (pipeline/gpu/interrupt.hpp), a second ends at once.
#pragma once
#include <string>

#include "pipeline/gpu/interrupt.hpp"

namespace caustics::app {

void watch_for_interruption();

// A temporary file that must not outlive the process, even when a second signal ends it.
// Thread-safe against signals only; register and release from one thread.
void register_temporary(const std::string& path);
void release_temporary(const std::string& path);

}  // namespace caustics::app
