// How long work is asked to stop: by a signal handler, or by another thread. Every loop that can take more
// than a moment asks now and then; pieces of work (pipeline/scene/in_pieces.hpp), tiles of the rasterizer,
// passes and rays do so already.
#pragma once
#include "pipeline/gpu/error.hpp"

namespace caustics {

// `code`: Interrupted or Terminated. The first that asks is heard; Done withdraws the wish, and work may
// begin anew. May be called in a signal handler and from any thread.
void ask_to_stop(ExitCode code) noexcept;

// What was asked for; Done: nothing.
ExitCode interruption() noexcept;

// Throws Error with that code where the work is to stop. Costs one relaxed load.
void stop_if_interrupted();

}  // namespace caustics
