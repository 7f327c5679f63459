// A study's truth by `caustics reference`.
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/frame_options.hpp"

namespace caustics::app {

struct TracedTruth {
  bool wanted = false;
  bool exact = false;     // shapes that the file states in place of their meshes
  double error = 0.01;    // relative error at which it is good enough
  double seconds = 60.0;  // after which it has to do
};

// What came of it.
struct TracedLight {
  double error = 0.0;  // relative
  int batches = 0;
  bool good = false;                 // enough
  std::vector<std::string> notes{};  // what is left out
};

// From where a truth is traced.
enum class TraceFrom : std::uint8_t { Nothing, State, Finished };

// Traces what `frame` sees until it is good enough, and writes it to `file` with its layer caustic_error
// (FILE.json has what it took). State: goes on from what is there; Finished: takes that as it is. Either
// begins anew, and says so, where it is of another request. Throws Error as `caustics reference` does: where
// the scene holds what is not traced, and when it is interrupted, which leaves what is done.
TracedLight trace_truth(const FrameRequest& frame, const TracedTruth& truth,
                        const std::filesystem::path& file, TraceFrom from,
                        const std::function<void(const std::string&)>& say,
                        const std::function<void(const std::string&)>& note);

}  // namespace caustics::app
