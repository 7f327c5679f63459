// What `caustics reference` is asked for.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/frame_options.hpp"
#include "app/reference_shapes.hpp"
#include "app/shell/parser.hpp"
#include "lab/reference/tracer/tracer.hpp"
#include "pipeline/settings/setting.hpp"

namespace caustics::app {

struct ReferenceRequest {
  FrameRequest frame;
  std::filesystem::path output;
  std::vector<std::string> layers;  // checked
  std::string stats;                // --stats; "": none
  tracer::TraceSettings trace{.physics = tracer::Physics::Full};
  ExactRequest exact;  // looked up in the scene, they are trace.exact
  // Whatever comes first ends the run.
  std::optional<int> batches;
  std::optional<double> seconds;
  std::optional<double> error;  // relative, of Tracer::relative_error
  bool resume = false, quiet = false;

  // Beside standard output there is no place for one.
  bool keeps_state() const { return output != "-"; }
  std::filesystem::path state_file() const { return output.string() + ".state"; }
};

// Of the settings, those that mean something without maps.
std::vector<Setting::Part> traced_parts();

// False when the help was asked for and printed. Throws Error (WrongUsage).
bool parse_reference(const Arguments& arguments, ReferenceRequest& request);

}  // namespace caustics::app
