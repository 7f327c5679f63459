// A study's truth by `caustics reference`.
#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "app/frame_options.hpp"

namespace caustics::app {

struct TracedTruth {
  bool wanted = false;
  bool exact = false;      // shapes that the file states in place of their meshes
  double error = 0.01;     // relative error at which it is good enough
  double seconds = 60.0;   // after which it has to do
};

// Traces what `frame` sees until it is good enough, and writes it to `file` with its layer caustic_error. Goes on from
// what is there where `resume`. Throws Error as `caustics reference` does: where the scene holds what is not traced,
// and when it is interrupted, which leaves what is done.
void trace_truth(const FrameRequest& frame, const TracedTruth& truth, const std::filesystem::path& file, bool resume,
                 const std::function<void(const std::string&)>& say);

}  // namespace caustics::app
