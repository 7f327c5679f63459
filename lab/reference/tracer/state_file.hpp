// A tracer's state as bytes, so that a long run can be broken off and gone on with.
#pragma once
#include <string>
#include <string_view>

#include "lab/reference/tracer/tracer.hpp"

namespace caustics::tracer {

// What a state belongs to, "name: value" a line: the scene as it is traced, view, size, rays, physics. Equal
// texts mean batches that may be added up.
std::string request_text(const Scene& scene, const Effects& effects, const Camera& camera,
                         const TraceSettings& settings);

// The request's text, then the sums in double precision, as this machine stores them.
std::string to_bytes(const TraceState& state, const std::string& request);
// Throws Error (BadInput), its line to be put behind the file's name: no state, damaged, or of another
// request. `like`: a state of the sizes wanted.
TraceState from_bytes(std::string_view bytes, const std::string& request, const TraceState& like);

}  // namespace caustics::tracer
